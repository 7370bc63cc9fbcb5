// From poses to axis positions: branches, turns, rewinds, linear axes, points between.
#include <algorithm>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"
#include "kinematics/inverse/path_steps.hpp"

namespace volute::kinematics {

using geometry::bad_input;
using geometry::Result;
using geometry::short_text;

namespace {

AxisVector place(const PathProblem& problem, const ToolPose& pose, const Rotary2& rotary) {
  return problem.solver.linear(problem.in_machine(pose.tip_P_mm), rotary[0], rotary[1]);
}

ToolPose pose_P(const PathProblem& problem, const AxisVector& q) {
  const ToolPose pose_M = problem.solver.pose_M(q);
  return {problem.in_part(pose_M.tip_P_mm), problem.R_PM * pose_M.axis_P};
}

Rotary2 with_turns(const Rotary2& rotary, const std::array<int, 2>& turns) {
  return {rotary[0] + turns[0] * turn_rad, rotary[1] + turns[1] * turn_rad};
}

AxisPathPoint path_point(const PathProblem& problem, std::size_t index, const Rotary2& rotary) {
  const ToolPathPoint& source = problem.path.points[index];
  AxisPathPoint point;
  point.pose = source.pose;
  point.q = place(problem, source.pose, rotary);
  point.move = source.move;
  point.feed_mm_s = source.feed_mm_s;
  point.source = static_cast<std::int32_t>(index);
  return point;
}

AxisPathPoint inserted(const AxisPathPoint& like, MoveKind move, bool machine_move) {
  AxisPathPoint point = like;
  point.source = -1;
  point.move = move;
  point.machine_move = machine_move;
  return point;
}

AxisPathPoint lifted(const PathProblem& problem, const AxisPathPoint& from, MoveKind move) {
  AxisPathPoint point = inserted(from, move, false);
  point.pose.tip_P_mm += problem.options.rewind_retract_mm * from.pose.axis_P;
  point.q = place(problem, point.pose, {from.q[3], from.q[4]});
  return point;
}

// Z at the end of its travel, the other axes as given; the pose follows.
AxisPathPoint over_the_top(const PathProblem& problem, const AxisPathPoint& from, const AxisVector& q) {
  AxisPathPoint point = inserted(from, MoveKind::rapid, true);
  point.q = q;
  point.q[2] = *problem.machine.axes[2].travel_max;
  point.pose = pose_P(problem, point.q);
  return point;
}

// A place in the air was reached in rapid and has no feed to go on with.
MoveKind at_feed(const AxisPathPoint& place, MoveKind move) { return place.feed_mm_s > 0.0 ? move : MoveKind::rapid; }

// Off the part along the tool axis, up to the top of Z, turn there, down again, back along the axis: TCP is off while
// rotaries turn.
void append_rewind(const PathProblem& problem, AxisPath& path, const AxisPathPoint& back_at) {
  const AxisPathPoint left_at = path.points.back();
  const AxisPathPoint lifted_before = lifted(problem, left_at, at_feed(left_at, MoveKind::retract));
  const AxisPathPoint lifted_after = lifted(problem, back_at, MoveKind::rapid);
  AxisPathPoint down = lifted_after;
  down.machine_move = true;
  path.points.push_back(lifted_before);
  path.points.push_back(over_the_top(problem, lifted_before, lifted_before.q));
  path.points.push_back(over_the_top(problem, lifted_after, lifted_after.q));
  path.points.push_back(down);
  path.points.push_back(inserted(back_at, at_feed(back_at, MoveKind::approach), false));
}

// Rotaries of the point that a rewind returns to, with the turns (and, at a reposition, the branch) of the stretch that
// begins.
std::optional<AxisPathPoint> return_point(const PathProblem& problem, const std::vector<ChosenPoint>& chosen,
                                          const Stretch& stretch) {
  const std::size_t index = stretch.meets_before ? stretch.begin - 1 : stretch.begin;
  const ChosenPoint& first = chosen[stretch.begin];
  Rotary2 rotary = with_turns(chosen[index].rotary, stretch.turns);
  if (first.reposition && stretch.meets_before) {
    const auto other_branch =
        nearest_rotaries(problem, problem.path.points[index].pose.axis_P, with_turns(first.rotary, stretch.turns));
    if (!other_branch) return std::nullopt;
    rotary = *other_branch;
  }
  return path_point(problem, index, rotary);
}

Result<AxisPath> place_points(const PathProblem& problem, const std::vector<ChosenPoint>& chosen,
                              const std::vector<Stretch>& stretches) {
  AxisPath path;
  path.points.reserve(chosen.size() + 5 * stretches.size());
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    const Stretch& stretch = stretches[s];
    const std::size_t end = s + 1 < stretches.size() ? stretches[s + 1].begin : chosen.size();
    if (s > 0) {
      const auto back_at = return_point(problem, chosen, stretch);
      if (!back_at)
        return bad_input("axis-out-of-travel",
                         "CC point " + std::to_string(stretch.begin) + ": the rotaries of " + problem.machine.name +
                             " must change branch here, but no place allows both; lower the tilt or turn the part");
      if (!stretch.meets_before) {  // finish the step with the old branch, then change at its end
        const auto old_branch = nearest_rotaries(problem, problem.path.points[stretch.begin].pose.axis_P,
                                                 {path.points.back().q[3], path.points.back().q[4]});
        if (old_branch) path.points.push_back(path_point(problem, stretch.begin, *old_branch));
      }
      append_rewind(problem, path, *back_at);
    }
    const std::size_t begin = s > 0 && !stretch.meets_before ? stretch.begin + 1 : stretch.begin;
    for (std::size_t i = begin; i < end; ++i)
      path.points.push_back(path_point(problem, i, with_turns(chosen[i].rotary, stretch.turns)));
  }
  return path;
}

struct Chosen {
  BranchOption option;
  std::vector<Stretch> stretches;
};

// Branches of equal motion can differ by a rewind, as they start at different places of a rotary's travel. The cheaper
// one wins a tie, and is all that is looked at when it needs none.
Result<Chosen> fewest_rewinds(const PathProblem& problem) {
  Chosen best;
  const auto take = [&](BranchOption option) {
    std::vector<Stretch> stretches = choose_turns(problem, option.points);
    if (best.stretches.empty() || stretches.size() < best.stretches.size())
      best = {std::move(option), std::move(stretches)};
    return best.stretches.size() == 1;
  };
  if (auto chosen = choose_branches(problem, take); !chosen) return tl::unexpected(chosen.error());
  return best;
}

std::string shown(const Axis& axis, double position) {
  return axis.kind == AxisKind::linear ? short_text(position)
                                       : short_text(geometry::Angle::radians(position).degrees());
}

// How far the part would have to move for a linear axis to stay within its travel. Exact where the axis is not turned
// by a rotary between it and the part; near enough to try where it is.
std::string remedy_for_linear(const Axis& axis, int index, const AxisPath& path) {
  double least = path.points.front().q[index], greatest = least;
  for (const AxisPathPoint& point : path.points) {
    least = std::min(least, point.q[index]);
    greatest = std::max(greatest, point.q[index]);
  }
  const std::string needs =
      "; the path needs " + std::string(1, axis.letter) + " from " + short_text(least) + " to " + short_text(greatest);
  const double below = axis.travel_min ? *axis.travel_min - least : 0.0,
               above = axis.travel_max ? greatest - *axis.travel_max : 0.0;
  if (below > 0.0 && above > 0.0) return needs + ", more than the travel: shorten the path or take a larger machine";
  const double shift_mm = below > 0.0 ? std::ceil(below) : -std::ceil(above);
  return needs + ": move the part by about " + short_text(shift_mm) + " mm in " + axis.letter +
         " (setup.origin_mm) or change the tool's length";
}

Result<void> check_travel(const PathProblem& problem, const AxisPath& path) {
  constexpr double slack = 1e-9;
  std::int32_t last_source = 0;
  for (const AxisPathPoint& point : path.points) {
    last_source = std::max(last_source, point.source);
    for (int i = 0; i < axis_count; ++i) {
      const Axis& axis = problem.machine.axes[static_cast<std::size_t>(i)];
      const bool below = axis.travel_min && point.q[i] < *axis.travel_min - slack,
                 above = axis.travel_max && point.q[i] > *axis.travel_max + slack;
      if (!below && !above) continue;
      const std::string unit = axis.kind == AxisKind::linear ? " mm" : " deg";
      const std::string where = point.source >= 0 ? "CC point " + std::to_string(point.source)
                                                  : "after CC point " + std::to_string(last_source);
      return bad_input("axis-out-of-travel",
                       where + ": " + axis.letter + " = " + shown(axis, point.q[i]) + unit + " is past [" +
                           shown(axis, *axis.travel_min) + ", " + shown(axis, *axis.travel_max) + "] of " +
                           problem.machine.name +
                           (i < 3 ? remedy_for_linear(axis, i, path) : "; lower the tilt or turn the part"));
    }
  }
  return {};
}

}  // namespace

Result<AxisPathResult> solve_path(const Machine& machine, const Setup& setup, const Tool& tool, const ToolPath& path,
                                  const AxisPathOptions& options) {
  VOLUTE_CHECK(options.chordal_tolerance_mm > 0.0 && options.rotary_tolerance_rad > 0.0, options.chordal_tolerance_mm,
               options.rotary_tolerance_rad);
  AxisPathResult result;
  if (path.points.empty()) return result;
  const PathProblem problem{machine, setup, path, options, PoseSolver(machine, tool.gauge_length_mm)};
  const auto chosen = fewest_rewinds(problem);
  if (!chosen) return tl::unexpected(chosen.error());
  result.report.pole_crossings = chosen->option.pole_crossings;
  result.report.rewinds = static_cast<int>(chosen->stretches.size()) - 1;
  auto rough = place_points(problem, chosen->option.points, chosen->stretches);
  if (!rough) return tl::unexpected(rough.error());
  result.path = linearize(problem, std::move(*rough), result.report);
  if (auto travel = check_travel(problem, result.path); !travel) return tl::unexpected(travel.error());
  return result;
}

}  // namespace volute::kinematics
