// All axis positions that bring the tool to a pose, in closed form, for any two rotary axis lines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/axis_path.hpp"

namespace volute::kinematics {

/// One way to point the tool.
struct RotarySolution {
  double first_rad = 0.0, second_rad = 0.0;  ///< positions of axes[3] and axes[4], each in (-pi, pi]
  bool at_pole = false;  ///< the rotary next to the workpiece or tool has no influence here: it is free
};

/// The rotary positions that turn the tool to `axis_M` (unit, in M): 0, 1 (touching) or 2 solutions; at the pole one
/// whose free axis is 0.
std::vector<RotarySolution> solve_rotaries(const Machine& machine, const Vec3& axis_M);

/// The linear axes that bring the tip to `tip_M_mm` with the rotaries given. Exact: one 3 x 3 solve.
AxisVector solve_linear(const Machine& machine, double tool_length_mm, const Vec3& tip_M_mm, double first_rad,
                        double second_rad);

/// All branches for a pose in the part, rotaries in (-pi, pi], travel not yet looked at.
/// Property: tool_pose(solution) equals the pose within 1e-9 mm and 1e-12 rad, for every branch.
std::vector<AxisVector> solve(const Machine& machine, const Setup& setup, double tool_length_mm, const ToolPose& pose);

struct AxisPathOptions {
  double chordal_tolerance_mm =
      0.005;  ///< tip: between blocks, what the control interpolates stays this close to the tool path
  double rotary_tolerance_rad = 0.001;  ///< axis: likewise
  bool control_keeps_tip = true;        ///< TCP: the tip runs straight between blocks; else the axes run straight
  bool great_circle = false;            ///< TCP and vector words: the axis runs on a great circle
  std::optional<AxisVector>
      start;  ///< where the axes stand before (for the choice of branch and turn); else the zero pose
  double rewind_retract_mm = 50.0;  ///< along the tool axis, before a rotary is rewound
};

struct AxisPathReport {
  int pole_crossings = 0, rewinds = 0, points_added = 0;
  double chordal_error_mm = 0.0, rotary_error_rad = 0.0;  ///< greatest, before points were added
  double chordal_error_after_mm = 0.0, rotary_error_after_rad = 0.0;
};

/// Branch and turn of every rotary over the whole path (dynamic programming: least total motion within travel), rewinds
/// where travel ends, and points put in where the control's interpolation would leave the tolerance. Errors
/// (bad_input): axis-out-of-travel ("CC point 1183: A = 121.4 deg is past [-110, 110] of ac-head; ..."),
/// pose-unreachable.
struct AxisPathResult {
  AxisPath path;
  AxisPathReport report;
};
geometry::Result<AxisPathResult> solve_path(const Machine& machine, const Setup& setup, const Tool& tool,
                                            const ToolPath& path, const AxisPathOptions& options);

}  // namespace volute::kinematics
