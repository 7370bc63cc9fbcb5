// The program's own points against the tool path that it should carry (invariant 2).
#pragma once

#include <vector>

#include "geometry/result.hpp"
#include "sim/finding.hpp"
#include "sim/interpreter/program.hpp"

namespace volute::sim {

struct ReadBackTolerance {
  double tip_mm = 0.0, axis_rad = 0.0;
};

/// Poses in P that the blocks of the program command at their ends, feed moves only, in order; block by block through
/// the forward chain: under TCP the tip as programmed, else program zero plus words. Machine-coordinate moves are not
/// among them. Work coordinates have their origin at the part's and their axes along M's.
struct CommandedPose {
  kinematics::ToolPose pose;
  std::int64_t line = 0;
};
geometry::Result<std::vector<CommandedPose>> commanded_poses(ProgramReader& program, const kinematics::Machine& machine,
                                                             const kinematics::Setup& setup, double tool_length_mm);

/// Each expected pose must be met by a commanded one, in order; commanded ones between (linearization, approach) are
/// passed over. The findings, kind "disagreement": at most 20, the last one tells how many more.
std::vector<Finding> compare_poses(const std::vector<kinematics::ToolPose>& expected,
                                   const std::vector<CommandedPose>& commanded, const ReadBackTolerance& tolerance);

}  // namespace volute::sim
