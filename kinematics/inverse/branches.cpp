// Which branch every point takes: dynamic programming over two states a point.
#include <algorithm>
#include <limits>
#include <utility>

#include "geometry/number_text.hpp"
#include "kinematics/inverse/path_steps.hpp"

namespace volute::kinematics {

using geometry::bad_input;
using geometry::Result;
using geometry::short_text;

namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();
// A reposition costs more than any motion of the rotaries over a path (s); so the fewest of them are taken.
constexpr double reposition_cost_s = 1e6;
constexpr double equal_cost = 1e-9;  // relative, and in s

std::string degrees(double rad) { return short_text(geometry::Angle::radians(rad).degrees()); }

// Solutions are told apart by which way the rotary next to the tool turns from the pole, so a branch keeps its number
// over a path.
PointCandidates candidates_at(const PathProblem& problem, const Vec3& axis_P) {
  PointCandidates point;
  const RotarySolutions solutions = problem.solver.rotaries(problem.R_MP * axis_P);
  for (std::size_t k = 0; k < solutions.count; ++k) {
    point.at_pole = solutions.way[k].at_pole;
    point.rotary[k] = {solutions.way[k].first_rad, solutions.way[k].second_rad};
    point.possible[k] = true;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto place = place_in_travel(problem.machine.axes[3 + axis], point.rotary[k][axis]);
      point.possible[k] = point.possible[k] && place.has_value();
      if (place) point.rotary[k][axis] = *place;
    }
  }
  return point;
}

/// The two poles and how near to them a direction counts as one.
struct Pole {
  Vec3 direction_M;
  double sine_max;
};

Pole pole_of(const PathProblem& problem) {
  const Axis& by_workpiece = problem.machine.axes[static_cast<std::size_t>(3 + free_rotary(problem.machine))];
  // Half of the tolerance is for leaning at the pole, the other half for what the control does between points.
  return {by_workpiece.direction_M, std::sin(0.5 * problem.options.rotary_tolerance_rad)};
}

PointCandidates candidates_near_pole(const PathProblem& problem, const Pole& pole, const Vec3& axis_P) {
  const Vec3 axis_M = problem.R_MP * axis_P;
  if (axis_M.cross(pole.direction_M).norm() > pole.sine_max) return candidates_at(problem, axis_P);
  const double side = axis_M.dot(pole.direction_M) > 0.0 ? 1.0 : -1.0;
  PointCandidates exact = candidates_at(problem, problem.R_PM * (side * pole.direction_M));
  return exact.possible[0] ? exact : candidates_at(problem, axis_P);
}

std::string travel_message(const PathProblem& problem, std::size_t index) {
  const Vec3 axis_M = problem.R_MP * problem.path.points[index].pose.axis_P;
  const std::string where = "CC point " + std::to_string(index) + ": ";
  const RotarySolutions found = problem.solver.rotaries(axis_M);
  for (const RotarySolution& solution : found.all())
    for (std::size_t k = 0; k < 2; ++k) {
      const Axis& axis = problem.machine.axes[3 + k];
      const double angle = k == 0 ? solution.first_rad : solution.second_rad;
      if (place_in_travel(axis, angle)) continue;
      return where + axis.letter + " = " + degrees(angle) + " deg is past [" + degrees(*axis.travel_min) + ", " +
             degrees(*axis.travel_max) + "] of " + problem.machine.name + "; lower the tilt or turn the part";
    }
  return where + "no rotary positions are within travel of " + problem.machine.name +
         "; lower the tilt or turn the part";
}

Result<std::vector<PointCandidates>> all_candidates(const PathProblem& problem) {
  const Pole pole = pole_of(problem);
  std::vector<PointCandidates> candidates;
  candidates.reserve(problem.path.points.size());
  for (std::size_t i = 0; i < problem.path.points.size(); ++i) {
    const Vec3& axis_P = problem.path.points[i].pose.axis_P;
    candidates.push_back(candidates_near_pole(problem, pole, axis_P));
    if (candidates.back().possible[0] || candidates.back().possible[1]) continue;
    if (problem.solver.rotaries(problem.R_MP * axis_P).count == 0)
      return bad_input("pose-unreachable", "CC point " + std::to_string(i) + ": tool axis (" + short_text(axis_P.x()) +
                                               ", " + short_text(axis_P.y()) + ", " + short_text(axis_P.z()) +
                                               ") cannot be reached by " + problem.machine.name +
                                               " at any rotary position; lower the tilt or turn the part");
    return bad_input("axis-out-of-travel", travel_message(problem, i));
  }
  return candidates;
}

/// Motion from one pair of rotary positions to the other, each axis by its own way.
Rotary2 motion(const Machine& machine, const Rotary2& from, const Rotary2& to) {
  Rotary2 way{};
  for (std::size_t k = 0; k < 2; ++k)
    way[k] = is_wide(machine.axes[3 + k]) ? within_half_turn(to[k] - from[k]) : to[k] - from[k];
  return way;
}

class BranchChoice {
 public:
  BranchChoice(const PathProblem& problem, const std::vector<PointCandidates>& candidates)
      : problem_(problem),
        candidates_(candidates),
        pole_(pole_of(problem)),
        pole_P_(problem.R_PM * pole_.direction_M),
        steps_(candidates.size()) {}

  void run() {
    cost_ = {impossible, impossible};
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (candidates_[i].at_pole) continue;
      last_ ? step(*last_, i) : start(i);
      last_ = i;
    }
  }

  /// False: no way at all.
  [[nodiscard]] bool hand_out(const std::function<bool(BranchOption)>& take) const {
    if (!last_) return take(trace(0, 0.0)), true;  // every point stands at the pole
    // Equal up to rounding: the first branch, on every machine and with every compiler.
    const std::size_t cheaper = cost_[1] < cost_[0] - equal_cost * (1.0 + cost_[0]) || cost_[0] == impossible ? 1 : 0;
    if (cost_[cheaper] == impossible) return false;
    if (!take(trace(cheaper, cost_[cheaper])) && cost_[1 - cheaper] < impossible)
      take(trace(1 - cheaper, cost_[1 - cheaper]));
    return true;
  }

 private:
  enum class Way : std::uint8_t { same, through_pole, reposition_before, reposition_here };
  struct Step {
    std::array<std::int8_t, 2> from{};
    std::array<Way, 2> way{};
  };

  void start(std::size_t i) {
    const AxisVector q = problem_.options.start.value_or(AxisVector::Zero());
    for (std::size_t j = 0; j < 2; ++j)
      if (candidates_[i].possible[j])
        cost_[j] = seconds(motion(problem_.machine, {q[3], q[4]}, candidates_[i].rotary[j]));
  }

  [[nodiscard]] double seconds(const Rotary2& way) const {
    return std::abs(way[0]) / problem_.machine.axes[3].velocity_max +
           std::abs(way[1]) / problem_.machine.axes[4].velocity_max;
  }

  // A small share of the motion through the pole makes the choice between equal ways the same on every machine.
  [[nodiscard]] bool passes_pole(std::size_t before, std::size_t i) const {
    if (before + 1 < i) return true;  // the points between stand at the pole
    const Vec3& a = problem_.path.points[before].pose.axis_P;
    const Vec3& b = problem_.path.points[i].pose.axis_P;
    const Vec3 a_across = a - a.dot(pole_P_) * pole_P_, b_across = b - b.dot(pole_P_) * pole_P_;
    if (a_across.dot(b_across) >= 0.0 || a.dot(pole_P_) * b.dot(pole_P_) <= 0.0) return false;
    const Vec3 chord = b_across - a_across;
    return a_across.cross(chord).norm() <= pole_.sine_max * chord.norm();
  }

  [[nodiscard]] std::pair<double, Way> change_of_branch(std::size_t before, std::size_t i, std::size_t from,
                                                        std::size_t to, bool through_pole) const {
    const double turning =
        seconds(motion(problem_.machine, candidates_[before].rotary[from], candidates_[i].rotary[to]));
    if (through_pole) return {turning, Way::through_pole};
    const bool before_pole_run = before + 1 < i;
    if (candidates_[before].possible[to] && !before_pole_run)
      return {reposition_cost_s + turning, Way::reposition_before};
    if (candidates_[i].possible[from]) return {reposition_cost_s + turning, Way::reposition_here};
    return {impossible, Way::same};
  }

  void step(std::size_t before, std::size_t i) {
    const bool through_pole = passes_pole(before, i);
    std::array<double, 2> cost = {impossible, impossible};
    for (std::size_t j = 0; j < 2; ++j) {
      if (!candidates_[i].possible[j]) continue;
      const double stay =
          cost_[j] == impossible
              ? impossible
              : cost_[j] + seconds(motion(problem_.machine, candidates_[before].rotary[j], candidates_[i].rotary[j]));
      const std::size_t other = 1 - j;
      steps_[i].from[j] = static_cast<std::int8_t>(j);
      steps_[i].way[j] = Way::same;
      cost[j] = stay;
      if (!through_pole && stay <= cost_[other] + reposition_cost_s) continue;  // no change can be cheaper
      auto [change, way] = change_of_branch(before, i, other, j, through_pole);
      if (cost_[other] == impossible) change = impossible;
      if (stay <= cost_[other] + change) continue;
      cost[j] = cost_[other] + change;
      steps_[i].from[j] = static_cast<std::int8_t>(other);
      steps_[i].way[j] = way;
    }
    cost_ = cost;
  }

  [[nodiscard]] BranchOption trace(std::size_t last_branch, double cost_s) const {
    BranchOption option;
    option.points.resize(candidates_.size());
    option.cost_s = cost_s;
    if (last_) trace_branches(last_branch, option);
    unwrap(option.points);
    fill_poles(option.points, option);
    return option;
  }

  void trace_branches(std::size_t branch, BranchOption& option) const {
    std::vector<ChosenPoint>& chosen = option.points;
    for (std::size_t i = *last_ + 1; i-- > 0;) {
      if (candidates_[i].at_pole) continue;
      chosen[i].branch = static_cast<std::int8_t>(branch);
      chosen[i].rotary = candidates_[i].rotary[branch];
      const Way way = steps_[i].way[branch];
      chosen[i].reposition = way == Way::reposition_before || way == Way::reposition_here;
      chosen[i].meet_here = way == Way::reposition_here;
      option.pole_crossings += way == Way::through_pole ? 1 : 0;
      branch = static_cast<std::size_t>(steps_[i].from[branch]);
    }
  }

  // Wide axes count their turns on from the point before.
  void unwrap(std::vector<ChosenPoint>& chosen) const {
    const AxisVector q = problem_.options.start.value_or(AxisVector::Zero());
    Rotary2 before = {q[3], q[4]};
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (candidates_[i].at_pole) continue;
      const Rotary2 way = motion(problem_.machine, before, chosen[i].rotary);
      for (std::size_t k = 0; k < 2; ++k)
        if (is_wide(problem_.machine.axes[3 + k])) chosen[i].rotary[k] = before[k] + way[k];
      before = chosen[i].rotary;
    }
  }

  // At the pole the free rotary turns evenly from where it was to where it must be.
  void fill_poles(std::vector<ChosenPoint>& chosen, BranchOption& option) const {
    const std::size_t free = static_cast<std::size_t>(free_rotary(problem_.machine));
    for (std::size_t begin = 0; begin < chosen.size();) {
      std::size_t end = begin;
      while (end < chosen.size() && candidates_[end].at_pole) ++end;
      if (end > begin) fill_run(chosen, begin, end, free, option);
      begin = end + 1;
    }
  }

  void fill_run(std::vector<ChosenPoint>& chosen, std::size_t begin, std::size_t end, std::size_t free,
                BranchOption& option) const {
    const AxisVector q = problem_.options.start.value_or(AxisVector::Zero());
    double from = q[static_cast<Eigen::Index>(3 + free)];
    if (begin > 0) from = chosen[begin - 1].rotary[free];
    const double to = end < chosen.size() ? chosen[end].rotary[free] : from;
    if (begin == 0) from = to;
    option.pole_crossings += begin > 0 && end < chosen.size() && chosen[begin - 1].branch == chosen[end].branch ? 1 : 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double share = static_cast<double>(i - begin + 1) / static_cast<double>(end - begin + 1);
      chosen[i].rotary = candidates_[i].rotary[0];
      chosen[i].rotary[free] = from + share * (to - from);
      chosen[i].at_pole = true;
    }
    const std::size_t other = 1 - free;
    for (std::size_t i = begin; i < end; ++i) {
      if (!is_wide(problem_.machine.axes[3 + other])) continue;
      const double near = i > 0                 ? chosen[i - 1].rotary[other]
                          : end < chosen.size() ? chosen[end].rotary[other]
                                                : chosen[i].rotary[other];
      chosen[i].rotary[other] = near + within_half_turn(chosen[i].rotary[other] - near);
    }
  }

  const PathProblem& problem_;
  const std::vector<PointCandidates>& candidates_;
  Pole pole_;
  Vec3 pole_P_;
  std::vector<Step> steps_;
  std::array<double, 2> cost_{};
  std::optional<std::size_t> last_;
};

}  // namespace

std::optional<double> place_in_travel(const Axis& axis, double angle_rad) {
  if (is_wide(axis)) return angle_rad;
  const double middle = 0.5 * (*axis.travel_min + *axis.travel_max);
  const double place = middle + within_half_turn(angle_rad - middle);
  if (place >= *axis.travel_min && place <= *axis.travel_max) return place;
  return std::nullopt;
}

int free_rotary(const Machine& machine) {
  const auto third = std::find(machine.chain.begin(), machine.chain.end(), 3);
  const auto fourth = std::find(machine.chain.begin(), machine.chain.end(), 4);
  return third < fourth ? 0 : 1;
}

Result<void> choose_branches(const PathProblem& problem, const std::function<bool(BranchOption)>& take) {
  const auto candidates = all_candidates(problem);
  if (!candidates) return tl::unexpected(candidates.error());
  BranchChoice choice(problem, *candidates);
  choice.run();
  if (choice.hand_out(take)) return {};
  return bad_input("axis-out-of-travel", "no branch of " + problem.machine.name +
                                             " can be followed from the first to the last point, not even by changing "
                                             "it off the part; lower the tilt or turn the part");
}

}  // namespace volute::kinematics
