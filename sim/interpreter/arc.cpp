// The centre and the sweep of an arc from its words.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/number_text.hpp"
#include "sim/interpreter/motion_state.hpp"

namespace volute::sim {

namespace {

using geometry::short_text;

/// The radii at start and end may differ by what rounding of the end point to 0.01 mm (0.001 inch) makes of them, or by
/// more when that is less than a thousandth of the radius: measured on LinuxCNC 2.9's interpreter.
constexpr double radius_difference_mm = 0.02 * std::numbers::sqrt2;
constexpr double radius_difference_inch_mm = 0.002 * 25.4 * std::numbers::sqrt2;
constexpr double radius_difference_share = 0.001;
/// A radius may be this much too short for its chord: rounding of end points to 0.001 mm or 0.0001 inch.
constexpr double chord_excess_mm = 0.0025;
/// An end point this close to the start means a full circle.
constexpr double same_point_mm = 1e-9;

struct PlaneAxes {
  int first, second, normal;
};

PlaneAxes plane_axes(Plane plane) {
  switch (plane) {
    case Plane::zx:
      return {2, 0, 1};
    case Plane::yz:
      return {1, 2, 0};
    case Plane::xy:
      break;
  }
  return {0, 1, 2};
}

/// The sweep from `start` to `end` about the origin, counter-clockwise, in (0, 2 pi].
double counter_clockwise(const Eigen::Vector2d& start, const Eigen::Vector2d& end) {
  const double angle = std::atan2(start.x() * end.y() - start.y() * end.x(), start.dot(end));
  return angle > 0.0 ? angle : angle + 2.0 * std::numbers::pi;
}

}  // namespace

namespace {

struct FlatArc {
  Eigen::Vector2d start, end, centre;
};

/// The centre from R: the short arc for R > 0, the long one for R < 0. Nothing: the points lie more than 2 |R| apart.
std::optional<Eigen::Vector2d> centre_from_radius(const FlatArc& flat, double radius_mm, bool clockwise) {
  const Eigen::Vector2d half = 0.5 * (flat.end - flat.start);
  double rest_sq = radius_mm * radius_mm - half.squaredNorm();
  if (rest_sq < 0.0 && half.norm() - std::abs(radius_mm) <= chord_excess_mm) rest_sq = 0.0;
  if (rest_sq < 0.0) return std::nullopt;
  const Eigen::Vector2d left(-half.y(), half.x());
  const bool centre_left = (radius_mm > 0.0) != clockwise;
  const double along = std::sqrt(rest_sq) / half.norm();
  return Eigen::Vector2d(flat.start + half + (centre_left ? along : -along) * left);
}

}  // namespace

bool MotionState::arc_geometry(const ArcWords& arc, const Vec3& start, MotionBlock& out) {
  const PlaneAxes in = plane_axes(plane);
  const auto fault = [&](const std::string& text) { return diagnosis_.fault(arc.column, "program-arc", text); };
  FlatArc flat{{start[in.first], start[in.second]}, {out.xyz_mm[in.first], out.xyz_mm[in.second]}, {0, 0}};
  const bool closed = (flat.end - flat.start).norm() <= same_point_mm;
  const auto normal_bit = 1U << static_cast<unsigned>(in.normal);
  if (arc.radius_mm || arc.opening_rad) {
    if (arc.centre != 0) return fault("an arc takes its centre or its radius, not both");
    if (closed) return fault("an arc by radius ends where it starts; give its centre with I J K");
    double radius = arc.radius_mm.value_or(0.0);
    if (arc.opening_rad) {
      radius = 0.5 * (flat.end - flat.start).norm() / std::sin(0.5 * *arc.opening_rad);
      if (*arc.opening_rad > std::numbers::pi) radius = -radius;
    }
    const auto centre = centre_from_radius(flat, radius, arc.clockwise);
    if (!centre)
      return fault("arc radius " + short_text(std::abs(radius)) + " mm is too small: start and end lie " +
                   short_text((flat.end - flat.start).norm()) + " mm apart");
    flat.centre = *centre;
  } else {
    if (arc.centre == 0) return fault("an arc needs a centre (I J K) or a radius");
    if ((arc.centre & normal_bit) != 0)
      return fault("the arc's centre has a coordinate that is not in the working plane");
    const auto coordinate = [&](int axis, double from) {
      const auto i = static_cast<std::size_t>(axis);
      if (((arc.centre >> i) & 1U) == 0) return from;
      return ((arc.centre_absolute >> i) & 1U) != 0 ? arc.centre_mm[i] + shift.linear_mm[axis]
                                                    : from + arc.centre_mm[i];
    };
    flat.centre = {coordinate(in.first, flat.start.x()), coordinate(in.second, flat.start.y())};
  }
  const Eigen::Vector2d from = flat.start - flat.centre, to = flat.end - flat.centre;
  const double radius_start = from.norm(), radius_end = to.norm(), difference = std::abs(radius_start - radius_end);
  if (radius_start <= same_point_mm || radius_end <= same_point_mm) return fault("an arc of radius 0");
  if (difference > (inches ? radius_difference_inch_mm : radius_difference_mm) &&
      difference > radius_difference_share * std::max(radius_start, radius_end))
    return fault("the arc's radius is " + short_text(radius_start) + " mm at its start and " + short_text(radius_end) +
                 " mm at its end; correct the centre or the end point");
  double sweep = closed ? 2.0 * std::numbers::pi : counter_clockwise(from, to);
  if (arc.clockwise) sweep = closed ? -sweep : sweep - 2.0 * std::numbers::pi;
  if (arc.clockwise && sweep == 0.0) sweep = -2.0 * std::numbers::pi;
  sweep += (arc.clockwise ? -1.0 : 1.0) * 2.0 * std::numbers::pi * (arc.turns - 1);
  out.centre_mm = start;
  out.centre_mm[in.first] = flat.centre.x();
  out.centre_mm[in.second] = flat.centre.y();
  out.plane_normal = Vec3::Unit(in.normal);
  out.sweep_rad = sweep;
  return true;
}

}  // namespace volute::sim
