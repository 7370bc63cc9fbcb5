// The answers for a single pose.
#include "kinematics/inverse/pose_solver.hpp"

namespace volute::kinematics {

std::vector<RotarySolution> solve_rotaries(const Machine& machine, const Vec3& axis_M) {
  const RotarySolutions found = PoseSolver(machine, 0.0).rotaries(axis_M);
  return {found.all().begin(), found.all().end()};
}

AxisVector solve_linear(const Machine& machine, double tool_length_mm, const Vec3& tip_M_mm, double first_rad,
                        double second_rad) {
  return PoseSolver(machine, tool_length_mm).linear(tip_M_mm, first_rad, second_rad);
}

std::vector<AxisVector> solve(const Machine& machine, const Setup& setup, double tool_length_mm, const ToolPose& pose) {
  const PoseSolver solver(machine, tool_length_mm);
  const Vec3 tip_M_mm = setup.part_in_machine * pose.tip_P_mm;
  std::vector<AxisVector> solutions;
  for (const RotarySolution& rotary : solver.rotaries(setup.part_in_machine.linear() * pose.axis_P).all())
    solutions.push_back(solver.linear(tip_M_mm, rotary.first_rad, rotary.second_rad));
  return solutions;
}

}  // namespace volute::kinematics
