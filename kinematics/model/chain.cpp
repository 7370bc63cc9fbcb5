// Forward kinematics: the product of the chain, its derivative, and where each link stands.
#include <Eigen/LU>
#include <cmath>

#include "geometry/check.hpp"
#include "kinematics/model/machine.hpp"

namespace volute::kinematics {

using geometry::Mat3;

namespace {

/// exp(axis, q): the motion of one axis away from its zero pose.
Transform axis_motion(const Axis& axis, double position) {
  const double displacement = position - axis.zero;
  Transform motion = Transform::Identity();
  if (axis.kind == AxisKind::linear) {
    motion.translation() = displacement * axis.direction_M;
    return motion;
  }
  motion.linear() = Eigen::AngleAxisd(displacement, axis.direction_M).toRotationMatrix();
  motion.translation() = axis.point_M_mm - motion.linear() * axis.point_M_mm;
  return motion;
}

/// Product of the first `count` axes of the chain.
Transform chain_product(const Machine& machine, int count, const AxisVector& q) {
  Transform product = Transform::Identity();
  for (int k = 0; k < count; ++k) {
    const int axis = machine.chain[static_cast<std::size_t>(k)];
    product = product * axis_motion(machine.axes[static_cast<std::size_t>(axis)], q[axis]);
  }
  return product;
}

Transform tip_at_zero(const Machine& machine, double tool_length_mm) {
  return machine.gauge_at_zero_M * Eigen::Translation3d(0.0, 0.0, -tool_length_mm);
}

int place_in_chain(const Machine& machine, int axis) {
  for (int k = 0; k < axis_count; ++k)
    if (machine.chain[static_cast<std::size_t>(k)] == axis) return k;
  VOLUTE_CHECK(false, axis);
  return -1;
}

}  // namespace

int Machine::axis_index(char letter) const {
  for (int i = 0; i < axis_count; ++i)
    if (axes[static_cast<std::size_t>(i)].letter == letter) return i;
  return -1;
}

Transform forward(const Machine& machine, double tool_length_mm, const AxisVector& q) {
  return chain_product(machine, axis_count, q) * tip_at_zero(machine, tool_length_mm);
}

ToolPose tool_pose(const Machine& machine, const Setup& setup, double tool_length_mm, const AxisVector& q) {
  const Transform X_PT = setup.part_in_machine.inverse() * forward(machine, tool_length_mm, q);
  return {X_PT.translation(), X_PT.linear().col(2)};
}

Jacobian jacobian(const Machine& machine, double tool_length_mm, const AxisVector& q) {
  const Vec3 tip_M_mm = forward(machine, tool_length_mm, q).translation();
  Jacobian columns = Jacobian::Zero();
  Transform before = Transform::Identity();
  for (const int i : machine.chain) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    const Vec3 direction_M = before.linear() * axis.direction_M;
    if (axis.kind == AxisKind::linear) {
      columns.col(i).head<3>() = direction_M;
    } else {
      columns.col(i).head<3>() = direction_M.cross(tip_M_mm - before * axis.point_M_mm);
      columns.col(i).tail<3>() = direction_M;
    }
    before = before * axis_motion(axis, q[i]);
  }
  return columns;
}

// A link of the head moves with its own axis. A link of the table stands on the other side of its axis: the axis that
// carries it moves it relative to the base, and what lies between it and the workpiece moves it relative to the
// workpiece.
Transform link_motion(const Machine& machine, int link, const AxisVector& q) {
  VOLUTE_CHECK(link >= -1 && link < axis_count, link);
  if (link == -1) return chain_product(machine, machine.table_axes, q);
  const int place = place_in_chain(machine, link);
  return chain_product(machine, place < machine.table_axes ? place : place + 1, q);
}

AxisVector program_zero(const Machine& machine, const Setup& setup, double tool_length_mm) {
  const AxisVector rotaries_at_zero = AxisVector::Zero();
  const Vec3 tip_M_mm = forward(machine, tool_length_mm, rotaries_at_zero).translation();
  const Mat3 linear_part = jacobian(machine, tool_length_mm, rotaries_at_zero).topLeftCorner<3, 3>();
  AxisVector zero = AxisVector::Zero();
  zero.head<3>() = linear_part.partialPivLu().solve(setup.part_in_machine.translation() - tip_M_mm);
  return zero;
}

}  // namespace volute::kinematics
