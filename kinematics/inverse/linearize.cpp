// Points put between neighbours where the control's own interpolation would leave the tolerance.
//
// Between two points the tool path means: the tip on the straight line, the tool axis on the great circle. A control
// with TCP keeps the tip and moves the rotaries linearly; without TCP it moves every axis linearly, so the tip bows as
// well.
#include <algorithm>

#include "kinematics/inverse/path_steps.hpp"

namespace volute::kinematics {

namespace {

constexpr int depth_max = 24;          // halvings of one step: 1 m becomes 0.06 um
constexpr double rapid_share = 100.0;  // rapids are in the air: without TCP they may bow this much more

struct Deviation {
  double tip_mm = 0.0, axis_rad = 0.0;
};

/// The same for unit vectors less than a right angle apart, where the chord loses nothing.
double small_angle_between(const Vec3& a, const Vec3& b) {
  return 2.0 * std::asin(std::min(1.0, 0.5 * (a - b).norm()));
}

double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double length_sq = along.squaredNorm();
  const double share = length_sq > 0.0 ? std::clamp((point - from).dot(along) / length_sq, 0.0, 1.0) : 0.0;
  return (point - from - share * along).norm();
}

class Linearizer {
 public:
  Linearizer(const PathProblem& problem, AxisPathReport& report) : problem_(problem), report_(report) {}

  // Points go over to a new path from the first step on that must be divided; most paths have none.
  AxisPath run(AxisPath rough) {
    rough_ = std::move(rough.points);
    const std::size_t count = rough_.size();
    for (taken_ = 1; taken_ < count; ++taken_) connect(rough_[taken_ - 1], rough_[taken_]);
    if (path_.points.empty()) path_.points = std::move(rough_);
    return std::move(path_);
  }

 private:
  void connect(const AxisPathPoint& from, const AxisPathPoint& to) {
    const bool tip_is_kept = problem_.options.control_keeps_tip;
    const bool exact = to.machine_move || from.machine_move ||
                       (tip_is_kept && (problem_.options.great_circle || to.move == MoveKind::rapid));
    if (exact) return keep(to);
    tolerance_share_ = to.move == MoveKind::rapid ? rapid_share : 1.0;
    const Deviation before = deviation(from, to);
    if (to.move != MoveKind::rapid) {
      report_.chordal_error_mm = std::max(report_.chordal_error_mm, before.tip_mm);
      report_.rotary_error_rad = std::max(report_.rotary_error_rad, before.axis_rad);
    }
    divide(from, to, before, 0, false);
  }

  void keep(const AxisPathPoint& point) {
    if (!path_.points.empty()) path_.points.push_back(point);
  }

  void insert(const AxisPathPoint& point) {
    if (path_.points.empty()) {
      path_.points.reserve(rough_.size() + rough_.size() / 4);
      path_.points.assign(rough_.begin(), rough_.begin() + static_cast<std::ptrdiff_t>(taken_));
    }
    path_.points.push_back(point);
  }

  void divide(const AxisPathPoint& from, const AxisPathPoint& to, const Deviation& error, int depth, bool to_is_new) {
    const bool within = error.tip_mm <= tolerance_share_ * problem_.options.chordal_tolerance_mm &&
                        error.axis_rad <= tolerance_share_ * problem_.options.rotary_tolerance_rad;
    const auto middle = within || depth == depth_max ? std::nullopt : between(from, to);
    if (!middle) return finish(to, error, to_is_new);
    ++report_.points_added;
    divide(from, *middle, deviation(from, *middle), depth + 1, true);
    divide(*middle, to, deviation(*middle, to), depth + 1, to_is_new);
  }

  void finish(const AxisPathPoint& to, const Deviation& error, bool to_is_new) {
    to_is_new ? insert(to) : keep(to);
    if (to.move == MoveKind::rapid) return;
    report_.chordal_error_after_mm = std::max(report_.chordal_error_after_mm, error.tip_mm);
    report_.rotary_error_after_rad = std::max(report_.rotary_error_after_rad, error.axis_rad);
  }

  [[nodiscard]] std::optional<AxisPathPoint> between(const AxisPathPoint& from, const AxisPathPoint& to) const {
    const AxisVector halfway = 0.5 * (from.q + to.q);
    AxisPathPoint middle = to;
    middle.source = -1;
    middle.pose = {0.5 * (from.pose.tip_P_mm + to.pose.tip_P_mm), slerp(from.pose.axis_P, to.pose.axis_P, 0.5)};
    const auto rotary = nearest_rotaries(problem_, middle.pose.axis_P, {halfway[3], halfway[4]});
    if (!rotary) return std::nullopt;
    middle.q = problem_.solver.linear(problem_.in_machine(middle.pose.tip_P_mm), (*rotary)[0], (*rotary)[1]);
    return middle;
  }

  // The deviation vanishes at both ends. Over a small turn it is a parabola with its top in the middle, to third order
  // of the turn; over a larger one it may lean to a side, and three places bracket its top.
  [[nodiscard]] Deviation deviation(const AxisPathPoint& from, const AxisPathPoint& to) const {
    constexpr double small_turn_rad = 0.02;
    const bool small = std::max(std::abs(to.q[3] - from.q[3]), std::abs(to.q[4] - from.q[4])) < small_turn_rad;
    Deviation greatest = deviation_at(from, to, 0.5);
    for (const double t : {0.25, 0.75}) {
      if (small) break;
      const Deviation beside = deviation_at(from, to, t);
      greatest = {std::max(greatest.tip_mm, beside.tip_mm), std::max(greatest.axis_rad, beside.axis_rad)};
    }
    return greatest;
  }

  [[nodiscard]] Deviation deviation_at(const AxisPathPoint& from, const AxisPathPoint& to, double t) const {
    const AxisVector q = from.q + t * (to.q - from.q);
    const auto axis_P = [&](const Vec3& axis_M) { return Vec3(problem_.R_PM * axis_M); };
    const Vec3 wanted_P = slerp(from.pose.axis_P, to.pose.axis_P, t);
    if (problem_.options.control_keeps_tip)
      return {0.0, small_angle_between(axis_P(problem_.solver.axis_M(q[3], q[4])), wanted_P)};
    const ToolPose pose_M = problem_.solver.pose_M(q);
    return {distance_to_segment(problem_.in_part(pose_M.tip_P_mm), from.pose.tip_P_mm, to.pose.tip_P_mm),
            small_angle_between(axis_P(pose_M.axis_P), wanted_P)};
  }

  const PathProblem& problem_;
  AxisPathReport& report_;
  std::vector<AxisPathPoint> rough_;
  std::size_t taken_ = 0;  ///< points of rough_ that stand as they are or have gone over
  AxisPath path_;
  double tolerance_share_ = 1.0;
};

double distance(const Rotary2& a, const Rotary2& b) { return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]); }

bool within_travel(const Axis& axis, double position) {
  return (!axis.travel_min || position >= *axis.travel_min) && (!axis.travel_max || position <= *axis.travel_max);
}

// The pole's own rotaries where the axis is so near to it that the free one does not matter.
RotarySolutions solutions_near(const PathProblem& problem, const Vec3& axis_M, const Rotary2& near) {
  const std::size_t free = static_cast<std::size_t>(free_rotary(problem.machine));
  const Vec3& pole_M = problem.machine.axes[3 + free].direction_M;
  const bool leans = axis_M.cross(pole_M).norm() <= std::sin(0.5 * problem.options.rotary_tolerance_rad);
  RotarySolutions solutions =
      problem.solver.rotaries(leans ? Vec3(axis_M.dot(pole_M) > 0.0 ? pole_M : -pole_M) : axis_M);
  for (RotarySolution& solution : solutions.way)
    if (solution.at_pole) (free == 0 ? solution.first_rad : solution.second_rad) = near[free];
  return solutions;
}

}  // namespace

Vec3 slerp(const Vec3& a, const Vec3& b, double t) {
  if (t == 0.5 && a.dot(b) > 0.0) return (a + b).normalized();
  const double angle = angle_between(a, b);
  if (angle < 1e-9) return (a + t * (b - a)).normalized();
  return (std::sin((1.0 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

std::optional<Rotary2> nearest_rotaries(const PathProblem& problem, const Vec3& axis_P, const Rotary2& near) {
  std::optional<Rotary2> nearest;
  const RotarySolutions found = solutions_near(problem, problem.R_MP * axis_P, near);
  for (const RotarySolution& solution : found.all()) {
    Rotary2 rotary = {solution.first_rad, solution.second_rad};
    for (std::size_t k = 0; k < 2; ++k) rotary[k] = near[k] + within_half_turn(rotary[k] - near[k]);
    const bool possible =
        within_travel(problem.machine.axes[3], rotary[0]) && within_travel(problem.machine.axes[4], rotary[1]);
    if (possible && (!nearest || distance(rotary, near) < distance(*nearest, near))) nearest = rotary;
  }
  return nearest;
}

AxisPath linearize(const PathProblem& problem, AxisPath rough, AxisPathReport& report) {
  return Linearizer(problem, report).run(std::move(rough));
}

}  // namespace volute::kinematics
