// The direction problem: two turns about fixed lines that bring the tool axis to a given direction.
//
// In M with every axis at zero let d1 be the rotary nearer to the workpiece, d2 the one nearer to the tool, a0 the tool
// axis: wanted are t1, t2 with R(d1, t1) R(d2, t2) a0 = a. The turned axis u = R(d2, t2) a0 keeps its angle rho to d2
// and must have the angle theta of a to d1. So d1, d2, u are the corners of a spherical triangle with sides sigma (d1
// to d2), rho (d2 to u) and theta (d1 to u), and its angle phi at d2 gives both solutions t2 = +-phi - psi0, psi0 being
// the azimuth of a0 about d2 counted from d1. The half-angle formula
//   tan^2(phi/2) = sin(s - sigma) sin(s - rho) / (sin s sin(s - theta)),  s = (sigma + rho + theta) / 2
// is exact to rounding next to the pole, where the cosine rule loses half the digits.
#include "kinematics/inverse/pose_solver.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/check.hpp"

namespace volute::kinematics {

using geometry::Mat3;

namespace {

// The pole: the angle theta is 0 or pi within this, so that leaving t1 at 0 turns the axis by less than 1e-12 rad.
constexpr double pole_rad = 1e-13;
// How far past its reach a direction may lie and still count as touching; rounding of the inputs alone makes some
// 1e-16.
constexpr double reach_rad = 1e-13;
// Two solutions nearer than this are one.
constexpr double same_rad = 1e-9;

Vec3 part_across(const Vec3& axis, const Vec3& v) { return v - axis.dot(v) * axis; }

/// Turn about `axis` (unit) that takes the azimuth of `from` to that of `to`.
double azimuth(const Vec3& axis, const Vec3& from, const Vec3& to) {
  const Vec3 from_across = part_across(axis, from), to_across = part_across(axis, to);
  return std::atan2(axis.dot(from_across.cross(to_across)), from_across.dot(to_across));
}

double wrapped(double angle) {
  if (angle > -std::numbers::pi && angle <= std::numbers::pi) return angle;
  const double reduced = std::remainder(angle, 2.0 * std::numbers::pi);
  return reduced == -std::numbers::pi ? std::numbers::pi : reduced;
}

/// v turned about `direction`.
Vec3 turn_about(const Vec3& direction, double sine, double cosine, const Vec3& v) {
  const Vec3 along = direction.dot(v) * direction;
  return along + cosine * (v - along) + sine * direction.cross(v);
}

}  // namespace

PoseSolver::TurnedVector::TurnedVector(const Vec3& direction, const Vec3& v)
    : along(direction.dot(v) * direction), across(v - along), ahead(direction.cross(v)) {}

PoseSolver::PoseSolver(const Machine& machine, double tool_length_mm) {
  std::size_t turns = 0, slides = 0;
  Mat3 directions;
  for (const int i : machine.chain) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (axis.kind == AxisKind::linear) {
      VOLUTE_CHECK(slides < 3, machine.name);
      directions.col(i) = axis.direction_M;
      slides_[slides++] = {i, static_cast<int>(turns), axis.direction_M, axis.zero};
      continue;
    }
    VOLUTE_CHECK(turns < 2, machine.name);
    turns_[turns++] = {i, axis.direction_M, axis.point_M_mm, axis.zero};
  }
  slides_together_ = slides_[0].turns_before == slides_[2].turns_before;
  slides_inverse_ = directions.inverse();
  const Vec3 &d1 = turns_[0].direction, &d2 = turns_[1].direction;
  const Vec3 tool = machine.gauge_at_zero_M.linear().col(2);
  tip_arm_ = {d2, machine.gauge_at_zero_M.translation() - tool_length_mm * tool - turns_[1].point};
  tool_ = {d2, tool};
  const double sigma = angle_between(d1, d2), rho = angle_between(d2, tool);
  sine_sum_ = std::sin(0.5 * (sigma + rho));
  cosine_sum_ = std::cos(0.5 * (sigma + rho));
  sine_difference_ = std::sin(0.5 * (sigma - rho));
  cosine_difference_ = std::cos(0.5 * (sigma - rho));
  azimuth_at_zero_ = azimuth(d2, d1, tool);
  reference_ = d1.unitOrthogonal();
  beside_ = d1.cross(reference_);
  const auto in_plane = [&](const Vec3& v) { return Eigen::Vector2d(reference_.dot(v), beside_.dot(v)); };
  const Vec3 ahead = part_across(d2, tool).norm() * part_across(d2, sigma > same_rad ? d1 : tool).normalized();
  along_ = in_plane(d2.dot(tool) * d2);
  ahead_ = in_plane(ahead);
  side_ = in_plane(d2.cross(ahead));
}

RotarySolution PoseSolver::in_axis_order(double by_workpiece_rad, double by_tool_rad, bool at_pole) const {
  // The free axis stands at its displayed zero: its own zero offset cancels.
  const double first = at_pole ? 0.0 : wrapped(by_workpiece_rad + turns_[0].zero),
               second = wrapped(by_tool_rad + turns_[1].zero);
  if (turns_[0].axis == 3) return {first, second, at_pole};
  return {second, first, at_pole};
}

// The sines of the triangle's half sums come from those of theta / 2 by the addition theorem,
// and the turned axis from cos phi and sin phi, so that only angles which are answers are ever computed.
RotarySolutions PoseSolver::rotaries(const Vec3& axis_M) const {
  const double x = reference_.dot(axis_M), y = beside_.dot(axis_M);
  const double sine = std::sqrt(x * x + y * y), cosine = turns_[0].direction.dot(axis_M);
  const double length = std::sqrt(sine * sine + cosine * cosine);
  const double larger = std::sqrt(0.5 * (1.0 + std::abs(cosine) / length)), smaller = 0.5 * sine / (length * larger);
  const double half_sine = cosine >= 0.0 ? smaller : larger, half_cosine = cosine >= 0.0 ? larger : smaller;
  const double past_sigma = half_sine * cosine_difference_ - half_cosine * sine_difference_;
  const double past_rho = half_sine * cosine_difference_ + half_cosine * sine_difference_;
  const double past_theta = sine_sum_ * half_cosine - cosine_sum_ * half_sine;
  const double whole = sine_sum_ * half_cosine + cosine_sum_ * half_sine;
  if (std::min({past_sigma, past_rho, past_theta, whole}) < -reach_rad) return {};
  const double over = std::sqrt(std::max(0.0, past_sigma) * std::max(0.0, past_rho)),
               under = std::sqrt(std::max(0.0, whole) * std::max(0.0, past_theta));
  const double phi = 2.0 * std::atan2(over, under);

  RotarySolutions solutions;
  if (2.0 * smaller < pole_rad) {
    solutions.way[0] = in_axis_order(0.0, phi - azimuth_at_zero_, true);
    solutions.count = 1;
    return solutions;
  }
  const double square = over * over + under * under;
  const double cosine_phi = square > 0.0 ? (under * under - over * over) / square : 1.0,
               sine_phi = square > 0.0 ? 2.0 * over * under / square : 0.0;
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector2d turned = along_ + cosine_phi * ahead_ + side * sine_phi * side_;
    const double azimuth = std::atan2(turned.x() * y - turned.y() * x, turned.x() * x + turned.y() * y);
    solutions.way[solutions.count] = in_axis_order(azimuth, side * phi - azimuth_at_zero_, false);
    if (solutions.count == 1) {
      const auto& [a, b] = solutions.way;
      if (std::abs(wrapped(a.first_rad - b.first_rad)) < same_rad &&
          std::abs(wrapped(a.second_rad - b.second_rad)) < same_rad)
        break;
    }
    ++solutions.count;
  }
  return solutions;
}

std::array<PoseSolver::Angle2, 2> PoseSolver::angles(double first_rad, double second_rad) const {
  const bool in_order = turns_[0].axis == 3;
  const double t1 = (in_order ? first_rad : second_rad) - turns_[0].zero,
               t2 = (in_order ? second_rad : first_rad) - turns_[1].zero;
  return {Angle2{std::sin(t1), std::cos(t1)}, Angle2{std::sin(t2), std::cos(t2)}};
}

Vec3 PoseSolver::turned(Vec3 v, int count, const std::array<Angle2, 2>& at) const {
  if (count > 1) v = turn_about(turns_[1].direction, at[1].sine, at[1].cosine, v);
  if (count > 0) v = turn_about(turns_[0].direction, at[0].sine, at[0].cosine, v);
  return v;
}

Vec3 PoseSolver::turned_back(Vec3 v, int count, const std::array<Angle2, 2>& at) const {
  if (count > 0) v = turn_about(turns_[0].direction, -at[0].sine, at[0].cosine, v);
  if (count > 1) v = turn_about(turns_[1].direction, -at[1].sine, at[1].cosine, v);
  return v;
}

Vec3 PoseSolver::tip_without_slides(const std::array<Angle2, 2>& at) const {
  return turns_[0].point + turned(turns_[1].point - turns_[0].point + tip_arm_.at(at[1]), 1, at);
}

// The tip depends on the linear axes by a constant matrix once the rotaries stand: its columns are their directions,
// each turned by the rotaries between it and the workpiece.
AxisVector PoseSolver::linear(const Vec3& tip_M_mm, double first_rad, double second_rad) const {
  const std::array<Angle2, 2> at = angles(first_rad, second_rad);
  Vec3 way_mm = tip_M_mm - tip_without_slides(at);
  Vec3 slid_mm;
  if (slides_together_) {
    slid_mm.noalias() = slides_inverse_ * turned_back(way_mm, slides_[0].turns_before, at);
  } else {
    Mat3 directions_M;
    for (const Slide& slide : slides_) directions_M.col(slide.axis) = turned(slide.direction, slide.turns_before, at);
    slid_mm = directions_M.inverse() * way_mm;
  }
  AxisVector q;
  for (const Slide& slide : slides_) q[slide.axis] = slid_mm[slide.axis] + slide.zero;
  q[3] = first_rad;
  q[4] = second_rad;
  return q;
}

Vec3 PoseSolver::axis_M(double first_rad, double second_rad) const {
  const std::array<Angle2, 2> at = angles(first_rad, second_rad);
  return turned(tool_.at(at[1]), 1, at);
}

ToolPose PoseSolver::pose_M(const AxisVector& q) const {
  const std::array<Angle2, 2> at = angles(q[3], q[4]);
  ToolPose pose{tip_without_slides(at), turned(tool_.at(at[1]), 1, at)};
  for (const Slide& slide : slides_)
    pose.tip_P_mm += (q[slide.axis] - slide.zero) * turned(slide.direction, slide.turns_before, at);
  return pose;
}

}  // namespace volute::kinematics
