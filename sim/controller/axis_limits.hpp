// What the axes can do, and the moving average that turns limits on acceleration into limits on jerk.
#pragma once

#include <array>

#include "kinematics/model/control.hpp"
#include "kinematics/model/machine.hpp"

namespace volute::sim {

/// Limits that the path's speed is planned under, for one kind of motion.
///
/// The plan has bounded acceleration; a moving average over n = `filter_samples` of the planned positions goes to the
/// axes. An average never raises a peak, so velocity and acceleration keep their bounds, and the jerk is (a_k -
/// a_(k-n)) / (n dt) <= 2 a / (n dt). Hence Property 1: planned acceleration <= acceleration  =>  every sampled
/// velocity, acceleration and jerk keeps its limit.
struct MotionLimits {
  std::array<double, kinematics::axis_count> velocity{};
  std::array<double, kinematics::axis_count> acceleration{};
  std::array<bool, kinematics::axis_count>
      jerk_bound{};  ///< acceleration is less than the axis's own, to keep its jerk
  int filter_samples = 1;
  /// The average of a motion with acceleration a lags it by a times this (s^2), beside the pure delay.
  double lag_per_acceleration_s2 = 0.0;
};

/// Profile trapezoid: no limit of jerk, acceleration is there at once; the average is `control.filter_time_s` long, or
/// nothing. Profile s_curve: the average is what limits jerk.
/// `tolerance_mm` finite: the filter is made short enough for the tip to keep half of it while the jerk limits still
/// leave as much acceleration as possible (T^3 = 48 e / j); infinite: long enough for the full acceleration of every
/// axis. `control.filter_time_s` > 0 takes the place of both. Requires: velocity and acceleration limits > 0; jerk_max
/// <= 0 means none.
MotionLimits motion_limits(const kinematics::Machine& machine, const kinematics::Control& control, double tolerance_mm);

}  // namespace volute::sim
