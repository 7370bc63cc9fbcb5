#include "sim/controller/axis_limits.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::sim {

namespace {

/// Rounding of positions of some metres must not lift a sampled peak over its limit.
constexpr double rounding_margin = 1.0 - 1e-6;

bool limits_jerk(const kinematics::Control& control) {
  return control.acceleration_profile == kinematics::AccelerationProfile::s_curve;
}

/// The time over which the axes need to average.
double filter_time(const kinematics::Machine& machine, const kinematics::Control& control, double tolerance_mm) {
  if (control.filter_time_s > 0.0 || !limits_jerk(control)) return control.filter_time_s;
  double full = 0.0;
  double jerk = 0.0;
  for (const kinematics::Axis& axis : machine.axes) {
    if (axis.jerk_max <= 0.0) continue;
    full = std::max(full, 2.0 * axis.acceleration_max / axis.jerk_max);
    if (axis.kind == kinematics::AxisKind::linear) jerk = std::max(jerk, axis.jerk_max);
  }
  if (!std::isfinite(tolerance_mm) || jerk <= 0.0) return full;
  return std::min(full, std::cbrt(24.0 * tolerance_mm / jerk));
}

}  // namespace

MotionLimits motion_limits(const kinematics::Machine& machine, const kinematics::Control& control,
                           double tolerance_mm) {
  MotionLimits limits;
  const double dt = control.servo_period_s;
  VOLUTE_CHECK(dt > 0.0, dt);
  limits.filter_samples =
      std::max(1, static_cast<int>(std::ceil(filter_time(machine, control, tolerance_mm) / dt - 1e-9)));
  const double n = limits.filter_samples;
  limits.lag_per_acceleration_s2 = (n * n - 1.0) * dt * dt / 24.0;
  for (std::size_t i = 0; i < limits.velocity.size(); ++i) {
    const kinematics::Axis& axis = machine.axes[i];
    VOLUTE_CHECK(axis.velocity_max > 0.0 && axis.acceleration_max > 0.0, axis.letter, axis.velocity_max,
                 axis.acceleration_max);
    limits.velocity[i] = axis.velocity_max * rounding_margin;
    const double by_jerk =
        limits_jerk(control) && axis.jerk_max > 0.0 ? 0.5 * axis.jerk_max * n * dt : axis.acceleration_max;
    limits.jerk_bound[i] = by_jerk < axis.acceleration_max;
    limits.acceleration[i] = std::min(axis.acceleration_max, by_jerk) * rounding_margin;
  }
  return limits;
}

}  // namespace volute::sim
