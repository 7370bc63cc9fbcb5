#include "sim/tool_motion.hpp"

#include <cmath>

namespace volute::sim {

using geometry::Vec3;

namespace {

/// `v` turned about the unit vector `axis` (Rodrigues).
Vec3 turned(const Vec3& v, const Vec3& axis, double sine, double cosine) {
  return cosine * v + sine * axis.cross(v) + ((1.0 - cosine) * axis.dot(v)) * axis;
}

}  // namespace

ToolMotion::ToolMotion(const kinematics::Machine& machine, const kinematics::Setup& setup, double tool_length_mm)
    : tip_M_mm_(machine.gauge_at_zero_M * Vec3(0.0, 0.0, -tool_length_mm)),
      axis_M_(machine.gauge_at_zero_M.linear().col(2)),
      X_PM_(setup.part_in_machine.inverse()) {
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const int index = machine.chain[steps_.size() - 1 - k];
    const kinematics::Axis& axis = machine.axes[static_cast<std::size_t>(index)];
    steps_[k] = {index, axis.kind == kinematics::AxisKind::linear, axis.direction_M, axis.point_M_mm, axis.zero};
  }
}

kinematics::ToolPose ToolMotion::pose_P(const kinematics::AxisVector& q) const {
  Vec3 tip = tip_M_mm_, axis = axis_M_;
  for (const Step& step : steps_) {
    const double displacement = q[step.axis] - step.zero;
    if (step.linear) {
      tip += displacement * step.direction_M;
      continue;
    }
    const double sine = std::sin(displacement), cosine = std::cos(displacement);
    tip = step.point_M_mm + turned(tip - step.point_M_mm, step.direction_M, sine, cosine);
    axis = turned(axis, step.direction_M, sine, cosine);
  }
  return {X_PM_ * tip, X_PM_.linear() * axis};
}

}  // namespace volute::sim
