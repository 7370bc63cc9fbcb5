// Whole turns of rotaries that wind: where a rewind is due, and how far to rewind.
#include <algorithm>
#include <limits>

#include "kinematics/inverse/path_steps.hpp"

namespace volute::kinematics {

namespace {

/// Least and greatest value of both rotaries over part of a path.
struct Extent {
  Rotary2 min{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Rotary2 max{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

  void add(const Rotary2& rotary) {
    for (std::size_t k = 0; k < 2; ++k) {
      min[k] = std::min(min[k], rotary[k]);
      max[k] = std::max(max[k], rotary[k]);
    }
  }
};

struct TurnRange {
  double least, greatest;
};

/// Whole turns that bring [min, max] into the axis's travel; empty when least > greatest.
TurnRange turns_within(const Axis& axis, double min, double max) {
  if (!is_wide(axis)) return {0.0, 0.0};
  constexpr double all = 1e9;
  return {axis.travel_min ? std::ceil((*axis.travel_min - min) / turn_rad) : -all,
          axis.travel_max ? std::floor((*axis.travel_max - max) / turn_rad) : all};
}

bool fits(const Machine& machine, const Extent& extent) {
  for (std::size_t k = 0; k < 2; ++k) {
    const TurnRange range = turns_within(machine.axes[3 + k], extent.min[k], extent.max[k]);
    if (range.least > range.greatest) return false;
  }
  return true;
}

bool off_the_part(MoveKind move) { return move == MoveKind::rapid || move == MoveKind::retract; }

// Greedy: every stretch reaches as far as any choice of turns lets it. No other cut of the path has fewer stretches.
std::vector<std::size_t> farthest_ends(const PathProblem& problem, const std::vector<ChosenPoint>& points,
                                       std::size_t first) {
  std::vector<std::size_t> ends;
  Extent extent;
  if (first > 0) extent.add(points[first - 1].rotary);
  for (std::size_t i = first; i < points.size(); ++i) {
    Extent grown = extent;
    grown.add(points[i].rotary);
    if (!points[i].reposition && fits(problem.machine, grown)) {
      extent = grown;
      continue;
    }
    if (i > first || points[i].reposition) ends.push_back(i);
    extent = Extent();
    if (i > 0 && !points[i].reposition) extent.add(points[i - 1].rotary);
    extent.add(points[i].rotary);
  }
  return ends;
}

// The last place before `end` where the tool is off the part anyway, if rewinding there costs no further rewind.
std::size_t safest_place(const PathProblem& problem, const std::vector<ChosenPoint>& points, std::size_t begin,
                         std::size_t end, std::size_t rewinds_left) {
  for (std::size_t i = end; i > begin + 1; --i) {
    if (!off_the_part(problem.path.points[i - 1].move)) continue;
    return farthest_ends(problem, points, i).size() <= rewinds_left ? i : end;
  }
  return end;
}

std::vector<std::size_t> rewind_places(const PathProblem& problem, const std::vector<ChosenPoint>& points) {
  std::vector<std::size_t> places;
  std::size_t begin = 0;
  for (std::vector<std::size_t> ends = farthest_ends(problem, points, 0); !ends.empty();) {
    std::size_t place = ends.front();
    if (!points[place].reposition) place = safest_place(problem, points, begin, place, ends.size() - 1);
    places.push_back(place);
    if (place == ends.front()) {
      ends.erase(ends.begin());
    } else {
      ends = farthest_ends(problem, points, place);
    }
    begin = place;
  }
  return places;
}

std::array<int, 2> nearest_turns(const PathProblem& problem, const std::vector<ChosenPoint>& points, std::size_t begin,
                                 std::size_t end, const Rotary2& stands) {
  Extent extent;
  if (begin > 0 && !points[begin].reposition) extent.add(points[begin - 1].rotary);
  for (std::size_t i = begin; i < end; ++i) extent.add(points[i].rotary);
  std::array<int, 2> turns{};
  for (std::size_t k = 0; k < 2; ++k) {
    const TurnRange range = turns_within(problem.machine.axes[3 + k], extent.min[k], extent.max[k]);
    const double wanted =
        is_wide(problem.machine.axes[3 + k]) ? std::round((stands[k] - points[begin].rotary[k]) / turn_rad) : 0.0;
    turns[k] = static_cast<int>(std::clamp(wanted, range.least, std::max(range.least, range.greatest)));
  }
  return turns;
}

}  // namespace

std::vector<Stretch> choose_turns(const PathProblem& problem, const std::vector<ChosenPoint>& points) {
  std::vector<std::size_t> begins = {0};
  for (const std::size_t place : rewind_places(problem, points)) begins.push_back(place);
  const AxisVector start = problem.options.start.value_or(AxisVector::Zero());
  Rotary2 stands = {start[3], start[4]};
  std::vector<Stretch> stretches;
  for (std::size_t s = 0; s < begins.size(); ++s) {
    const std::size_t end = s + 1 < begins.size() ? begins[s + 1] : points.size();
    Stretch stretch{.begin = begins[s], .turns = {}, .meets_before = !points[begins[s]].meet_here};
    stretch.turns = nearest_turns(problem, points, stretch.begin, end, stands);
    for (std::size_t k = 0; k < 2; ++k) stands[k] = points[end - 1].rotary[k] + stretch.turns[k] * turn_rad;
    stretches.push_back(stretch);
  }
  return stretches;
}

}  // namespace volute::kinematics
