// The direction problem: two turns about fixed lines that bring the tool axis to a given direction.
//
// In M with every axis at zero let d1 be the rotary nearer to the workpiece, d2 the one nearer to the tool, a0 the tool
// axis: wanted are t1, t2 with R(d1, t1) R(d2, t2) a0 = a. The turned axis u = R(d2, t2) a0 keeps its angle rho to d2
// and must have the angle theta of a to d1. So d1, d2, u are the corners of a spherical triangle with sides sigma (d1
// to d2), rho (d2 to u) and theta (d1 to u), and its angle phi at d2 gives both solutions t2 = +-phi - psi0, psi0 being
// the azimuth of a0 about d2 counted from d1. The half-angle formula
//   tan^2(phi/2) = sin(s - sigma) sin(s - rho) / (sin s sin(s - theta)),  s = (sigma + rho + theta) / 2
// is exact to rounding next to the pole, where the cosine rule loses half the digits.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/inverse/inverse.hpp"

namespace volute::kinematics {

namespace {

// The pole: the angle theta is 0 or pi within this, so that leaving t1 at 0 turns the axis by less than 1e-12 rad.
constexpr double pole_rad = 1e-13;
// How far past its reach a direction may lie and still count as touching; rounding of the inputs alone makes some
// 1e-16.
constexpr double reach_rad = 1e-13;

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Turn about `axis` (unit) that takes the azimuth of `from` to that of `to`.
double azimuth(const Vec3& axis, const Vec3& from, const Vec3& to) {
  const Vec3 from_across = from - axis.dot(from) * axis;
  const Vec3 to_across = to - axis.dot(to) * axis;
  return std::atan2(axis.dot(from_across.cross(to_across)), from_across.dot(to_across));
}

double wrapped(double angle) {
  const double reduced = std::remainder(angle, 2.0 * std::numbers::pi);
  return reduced == -std::numbers::pi ? std::numbers::pi : reduced;
}

/// The triangle's angle at d2 in [0, pi]; nothing when the sides form no triangle.
std::optional<double> triangle_angle(double sigma, double rho, double theta) {
  const double s = 0.5 * (sigma + rho + theta);
  const double past_sigma = 0.5 * (rho + theta - sigma), past_rho = 0.5 * (sigma + theta - rho),
               past_theta = 0.5 * (sigma + rho - theta);
  const double least = std::min({past_sigma, past_rho, past_theta, std::numbers::pi - s});
  if (least < -reach_rad) return std::nullopt;
  const double over = std::max(0.0, std::sin(past_sigma)) * std::max(0.0, std::sin(past_rho));
  const double under = std::max(0.0, std::sin(s)) * std::max(0.0, std::sin(past_theta));
  return 2.0 * std::atan2(std::sqrt(over), std::sqrt(under));
}

struct Rotaries {
  int by_workpiece = 3, by_tool = 4;
};

Rotaries rotaries_in_chain(const Machine& machine) {
  const auto third = std::find(machine.chain.begin(), machine.chain.end(), 3);
  const auto fourth = std::find(machine.chain.begin(), machine.chain.end(), 4);
  return third < fourth ? Rotaries{3, 4} : Rotaries{4, 3};
}

RotarySolution in_axis_order(const Machine& machine, const Rotaries& rotaries, double t1, double t2, bool at_pole) {
  const auto shown = [&](int axis, double turn) {
    return wrapped(turn + machine.axes[static_cast<std::size_t>(axis)].zero);
  };
  // The free axis stands at its displayed zero: its own zero offset cancels.
  const double by_workpiece = at_pole ? 0.0 : shown(rotaries.by_workpiece, t1), by_tool = shown(rotaries.by_tool, t2);
  if (rotaries.by_workpiece == 3) return {by_workpiece, by_tool, at_pole};
  return {by_tool, by_workpiece, at_pole};
}

bool same(const RotarySolution& a, const RotarySolution& b) {
  return std::abs(wrapped(a.first_rad - b.first_rad)) < 1e-9 && std::abs(wrapped(a.second_rad - b.second_rad)) < 1e-9;
}

}  // namespace

std::vector<RotarySolution> solve_rotaries(const Machine& machine, const Vec3& axis_M) {
  const Rotaries rotaries = rotaries_in_chain(machine);
  const Vec3 d1 = machine.axes[static_cast<std::size_t>(rotaries.by_workpiece)].direction_M;
  const Vec3 d2 = machine.axes[static_cast<std::size_t>(rotaries.by_tool)].direction_M;
  const Vec3 a0 = machine.gauge_at_zero_M.linear().col(2);
  const double theta = angle_between(d1, axis_M);
  const auto phi = triangle_angle(angle_between(d1, d2), angle_between(d2, a0), theta);
  if (!phi) return {};

  const double psi0 = azimuth(d2, d1, a0);
  if (std::min(theta, std::numbers::pi - theta) < pole_rad)
    return {in_axis_order(machine, rotaries, 0.0, *phi - psi0, true)};
  std::vector<RotarySolution> solutions;
  for (const double t2 : {*phi - psi0, -*phi - psi0}) {
    const Vec3 u = Eigen::AngleAxisd(t2, d2) * a0;
    const RotarySolution solution = in_axis_order(machine, rotaries, azimuth(d1, u, axis_M), t2, false);
    if (solutions.empty() || !same(solutions.front(), solution)) solutions.push_back(solution);
  }
  return solutions;
}

}  // namespace volute::kinematics
