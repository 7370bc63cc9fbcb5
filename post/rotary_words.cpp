#include "post/rotary_words.hpp"

#include <cmath>

namespace volute::post {

using kinematics::AxisPath;
using kinematics::AxisPathPoint;

namespace {

constexpr double turn_deg = 360.0;
constexpr double longest_step_rad =
    geometry::Angle::degrees(170.0).radians();  // clear of the half turn, where the sense is a toss-up

bool rolls_over(const kinematics::Axis& axis) { return !axis.travel_min || !axis.travel_max; }

// With TCP the rotaries share the step evenly and the tip keeps its line.
AxisPathPoint share_of_step(const kinematics::Machine& machine, const kinematics::Setup& setup, double tool_length_mm,
                            const AxisPathPoint& from, const AxisPathPoint& to, double share) {
  AxisPathPoint point = to;
  point.source = -1;
  const kinematics::Vec3 tip_P_mm = from.pose.tip_P_mm + share * (to.pose.tip_P_mm - from.pose.tip_P_mm);
  const Eigen::Vector2d rotary = from.q.tail<2>() + share * (to.q.tail<2>() - from.q.tail<2>());
  point.q = kinematics::solve_linear(machine, tool_length_mm, setup.part_in_machine * tip_P_mm, rotary[0], rotary[1]);
  point.pose = kinematics::tool_pose(machine, setup, tool_length_mm, point.q);
  return point;
}

}  // namespace

double rotary_word_deg(const kinematics::Control& control, const kinematics::Axis& axis, double position_rad) {
  const double degrees = geometry::Angle::radians(position_rad).degrees();
  if (!control.rotary_shortest_way || !rolls_over(axis)) return degrees;
  const double place = std::fmod(degrees, turn_deg);
  return place < 0.0 ? place + turn_deg : place;
}

AxisPath split_long_turns(const kinematics::Machine& machine, const kinematics::Setup& setup, double tool_length_mm,
                          const AxisPath& path) {
  AxisPath split;
  split.points.reserve(path.points.size());
  for (const AxisPathPoint& to : path.points) {
    if (!split.points.empty() && !to.machine_move) {
      const AxisPathPoint from = split.points.back();
      const double widest = (to.q.tail<2>() - from.q.tail<2>()).cwiseAbs().maxCoeff();
      const int steps = static_cast<int>(std::ceil(widest / longest_step_rad));
      for (int k = 1; k < steps; ++k)
        split.points.push_back(share_of_step(machine, setup, tool_length_mm, from, to, static_cast<double>(k) / steps));
    }
    split.points.push_back(to);
  }
  return split;
}

}  // namespace volute::post
