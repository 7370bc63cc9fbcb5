#include "planner/orientation/rotary_chart.hpp"

#include <cmath>
#include <numbers>

#include "kinematics/inverse/inverse.hpp"

namespace volute::planner {

using geometry::Mat3;

namespace {

constexpr double full_turn_rad = 2.0 * std::numbers::pi;
// Travel is met up to rounding.
constexpr double travel_slack_rad = 1e-9;

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

}  // namespace

RotaryChart::RotaryChart(const kinematics::Machine& machine, const kinematics::Setup& setup)
    : machine_(&machine),
      part_from_machine_(setup.part_in_machine.linear().transpose()),
      zero_axis_M_(machine.gauge_at_zero_M.linear().col(2)) {
  std::size_t found = 0;
  for (const int link : machine.chain) {
    if (link >= 3 && found < 2) order_[found++] = link - 3;
  }
  for (int k = 0; k < 2; ++k) {
    const Vec3 a = axis(k).direction_M;
    const Mat3 along = a * a.transpose();
    parts_[static_cast<std::size_t>(k)] = {along, Mat3::Identity() - along, cross_matrix(a)};
  }
}

Vec3 RotaryChart::axis_P(const Rotaries& at) const {
  Vec3 v = zero_axis_M_;
  for (int place = 1; place >= 0; --place) {
    const auto k = static_cast<std::size_t>(order_[static_cast<std::size_t>(place)]);
    const double t = at[k] - axis(static_cast<int>(k)).zero;
    v = parts_[k][0] * v + std::cos(t) * (parts_[k][1] * v) + std::sin(t) * (parts_[k][2] * v);
  }
  return part_from_machine_ * v;
}

std::vector<RotaryChoice> RotaryChart::choices(const Vec3& axis_P_wanted) const {
  std::vector<RotaryChoice> found;
  for (const kinematics::RotarySolution& s :
       kinematics::solve_rotaries(*machine_, part_from_machine_.transpose() * axis_P_wanted)) {
    RotaryChoice choice{{s.first_rad, s.second_rad}, -1};
    for (int k = 0; k < 2; ++k) {
      Rotaries turned = choice.at;
      turned[static_cast<std::size_t>(k)] += std::numbers::pi;
      // Half a turn of a rotary moves the axis by twice its angle from that rotary's line.
      if ((axis_P(turned) - axis_P_wanted).norm() < 2.0 * pole_rad) choice.free_axis = k;
    }
    found.push_back(choice);
  }
  return found;
}

bool RotaryChart::is_endless(int k) const {
  return released_[static_cast<std::size_t>(k)] || !axis(k).travel_min || !axis(k).travel_max;
}

bool RotaryChart::in_travel(const Rotaries& at) const {
  for (int k = 0; k < 2; ++k) {
    if (is_endless(k)) continue;
    const double value = at[static_cast<std::size_t>(k)];
    if (value < *axis(k).travel_min - travel_slack_rad) return false;
    if (value > *axis(k).travel_max + travel_slack_rad) return false;
  }
  return true;
}

std::vector<double> RotaryChart::turns(int k, double value_rad) const {
  const kinematics::Axis& a = axis(k);
  if (is_endless(k)) return {value_rad};
  std::vector<double> values;
  const double first =
      value_rad + full_turn_rad * std::ceil((*a.travel_min - travel_slack_rad - value_rad) / full_turn_rad);
  for (double v = first; v <= *a.travel_max + travel_slack_rad; v += full_turn_rad) values.push_back(v);
  return values;
}

bool RotaryChart::reaches(const Vec3& axis_P_wanted) const {
  for (const RotaryChoice& choice : choices(axis_P_wanted)) {
    const bool first = choice.free_axis == 0 || !turns(0, choice.at[0]).empty();
    const bool second = choice.free_axis == 1 || !turns(1, choice.at[1]).empty();
    if (first && second) return true;
  }
  return false;
}

}  // namespace volute::planner
