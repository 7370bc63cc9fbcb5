// The linear axes for given rotaries, and every branch of a pose.
#include <Eigen/LU>

#include "kinematics/inverse/inverse.hpp"

namespace volute::kinematics {

// The tip depends on the linear axes by a constant matrix once the rotaries stand: its columns are their directions,
// each turned by the rotaries between it and the workpiece.
AxisVector solve_linear(const Machine& machine, double tool_length_mm, const Vec3& tip_M_mm, double first_rad,
                        double second_rad) {
  AxisVector q = AxisVector::Zero();
  q[3] = first_rad;
  q[4] = second_rad;
  geometry::Mat3 directions_M;
  Transform before = Transform::Identity();
  for (const int i : machine.chain) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (axis.kind == AxisKind::linear) {
      directions_M.col(i) = before.linear() * axis.direction_M;
      before.translation() -= axis.zero * directions_M.col(i);
      continue;
    }
    const geometry::Mat3 turn = Eigen::AngleAxisd(q[i] - axis.zero, axis.direction_M).toRotationMatrix();
    before.translation() += before.linear() * (axis.point_M_mm - turn * axis.point_M_mm);
    before.linear() = before.linear() * turn;
  }
  const Vec3 tip_at_zero_M_mm =
      machine.gauge_at_zero_M.translation() - tool_length_mm * machine.gauge_at_zero_M.linear().col(2);
  q.head<3>() = directions_M.inverse() * (tip_M_mm - before * tip_at_zero_M_mm);
  return q;
}

std::vector<AxisVector> solve(const Machine& machine, const Setup& setup, double tool_length_mm, const ToolPose& pose) {
  const Vec3 tip_M_mm = setup.part_in_machine * pose.tip_P_mm;
  std::vector<AxisVector> solutions;
  for (const RotarySolution& rotary : solve_rotaries(machine, setup.part_in_machine.linear() * pose.axis_P))
    solutions.push_back(solve_linear(machine, tool_length_mm, tip_M_mm, rotary.first_rad, rotary.second_rad));
  return solutions;
}

}  // namespace volute::kinematics
