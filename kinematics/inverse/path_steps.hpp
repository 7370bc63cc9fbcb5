// The steps of solve_path and what passes between them. Private to kinematics/inverse.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/inverse/inverse.hpp"
#include "kinematics/inverse/pose_solver.hpp"

namespace volute::kinematics {

using Rotary2 = std::array<double, 2>;  ///< positions of axes[3], axes[4]

/// Everything that the steps read and none of them changes.
struct PathProblem {
  const Machine& machine;
  const Setup& setup;
  const ToolPath& path;
  const AxisPathOptions& options;
  PoseSolver solver;
  geometry::Mat3 R_MP = setup.part_in_machine.linear(), R_PM = R_MP.transpose();
  Vec3 part_in_machine_mm = setup.part_in_machine.translation();

  [[nodiscard]] Vec3 in_machine(const Vec3& point_P_mm) const { return R_MP * point_P_mm + part_in_machine_mm; }
  [[nodiscard]] Vec3 in_part(const Vec3& point_M_mm) const { return R_PM * (point_M_mm - part_in_machine_mm); }
};

constexpr double turn_rad = 2.0 * std::numbers::pi;

/// The same angle in [-pi, pi].
inline double within_half_turn(double angle_rad) {
  if (std::abs(angle_rad) <= std::numbers::pi) return angle_rad;
  if (std::abs(angle_rad) < 1.5 * turn_rad) return angle_rad - std::copysign(turn_rad, angle_rad);  // exact, and quick
  return std::remainder(angle_rad, turn_rad);
}

/// A rotary whose travel holds at least one whole turn: any angle can be shown, and turns are counted. The others are
/// narrow: an angle has at most one place in their travel.
inline bool is_wide(const Axis& axis) {
  return !axis.travel_min || !axis.travel_max || *axis.travel_max - *axis.travel_min >= turn_rad;
}
/// The place of an angle in a narrow axis's travel, or nothing.
std::optional<double> place_in_travel(const Axis& axis, double angle_rad);
/// Index (0 or 1, of axes 3 and 4) of the rotary nearer to the workpiece: the one that is free at the pole.
int free_rotary(const Machine& machine);

/// The ways to point the tool at one point of the path. Narrow axes: values within travel. Wide ones: in (-pi, pi].
struct PointCandidates {
  std::array<Rotary2, 2> rotary{};
  std::array<bool, 2> possible{};
  bool at_pole = false;  ///< within the tolerance: the free rotary may stand anywhere; only rotary[0] is used
};

/// How a point is reached: by which branch, with rotaries that count their turns from the point before.
struct ChosenPoint {
  Rotary2 rotary{};
  std::int8_t branch = 0;
  bool at_pole = false;
  bool reposition = false;  ///< the branch changes on the way here, away from the pole: lift off, turn, come back
  bool meet_here = false;   ///< reposition at this point (else at the one before)
};

/// One way along the whole path. Rotaries unwrapped; travel of wide axes not yet looked at.
struct BranchOption {
  std::vector<ChosenPoint> points;
  double cost_s = 0.0;  ///< motion of the rotaries at their greatest velocity, and a great deal for every reposition
  int pole_crossings = 0;
};

/// The ways of least motion that end in either branch, by dynamic programming over both; repositions only where nothing
/// else is possible. One or two, the cheaper first, handed to `take` until it is content (true).
/// Errors: axis-out-of-travel, pose-unreachable.
geometry::Result<void> choose_branches(const PathProblem& problem, const std::function<bool(BranchOption)>& take);

/// A stretch of the path with its own whole turns added to the rotaries. The first one starts at point 0; each later
/// one starts with a rewind.
struct Stretch {
  std::size_t begin = 0;  ///< first point that is cut with these turns
  std::array<int, 2> turns{};
  bool meets_before = true;  ///< the rewind returns to point begin - 1; else to begin
};
/// The fewest stretches that keep wide axes within their travel; a stretch may end earlier where the tool is off the
/// part.
std::vector<Stretch> choose_turns(const PathProblem& problem, const std::vector<ChosenPoint>& points);

/// The rotaries that reach `pose` nearest to `near`, or nothing when travel or reach forbid it. Within the tolerance of
/// the pole the free rotary keeps its value.
std::optional<Rotary2> nearest_rotaries(const PathProblem& problem, const Vec3& axis_P, const Rotary2& near);

/// Puts points between neighbours until what the control interpolates stays within the tolerances.
AxisPath linearize(const PathProblem& problem, AxisPath rough, AxisPathReport& report);

/// Great-circle interpolation of unit vectors; exact at both ends. Requires: not opposite.
Vec3 slerp(const Vec3& a, const Vec3& b, double t);

}  // namespace volute::kinematics
