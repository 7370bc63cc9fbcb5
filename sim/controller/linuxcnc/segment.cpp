#include "sim/controller/linuxcnc/segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace volute::sim::linuxcnc {

namespace {

constexpr double tiny = std::numeric_limits<double>::epsilon();
constexpr double two_pi = 2.0 * std::numbers::pi;

}  // namespace

template <class Vector>
Straight<Vector>::Straight(const Vector& from, const Vector& to) : start(from), end(to) {
  const Vector way = to - from;
  length = way.norm();
  none = way.cwiseAbs().maxCoeff() < fuzz;
  direction = none ? Vector(Vector::UnitX()) : Vector(way / length);
}
template struct Straight<Vec3>;
template struct Straight<geometry::Vec2>;

Arc Arc::through(const Vec3& start, const Vec3& end, const Vec3& centre, const Vec3& normal, int turns) {
  Arc arc;
  arc.normal = normal.normalized();
  arc.centre = centre + (start - centre).dot(arc.normal) * arc.normal;
  if (turns < 0) {
    turns = -1 - turns;
    arc.normal = -arc.normal;
  }
  arc.to_start = start - arc.centre;
  arc.radius = arc.to_start.norm();
  arc.ahead = arc.normal.cross(arc.to_start);
  const Vec3 to_end = end - arc.centre;
  arc.rise = to_end.dot(arc.normal) * arc.normal;
  const Vec3 flat_end = to_end - arc.rise;
  arc.spiral = flat_end.norm() - arc.radius;
  const Vec3 spoke = flat_end.norm() > 0.0 ? Vec3(flat_end.normalized() * arc.radius) : arc.to_start;
  arc.angle = std::acos(std::clamp(arc.to_start.dot(spoke) / (arc.radius * arc.radius), -1.0, 1.0));
  if (arc.to_start.cross(spoke).dot(arc.normal) < tiny) arc.angle = two_pi - arc.angle;
  if ((end - start - arc.rise).norm() < fuzz) arc.angle = two_pi;
  arc.angle += turns * two_pi;
  arc.fit_length();
  return arc;
}

// ds/dphi = sqrt(r^2 + r'^2) rises from its value at the smaller radius to that at the greater; a straight line between
// the two is integrated.
void Arc::fit_length() {
  const double change = std::abs(spiral / angle);
  inward = spiral < 0.0;
  const double least = inward ? radius + spiral : radius;
  const double slope_start = std::hypot(least, change), slope_end = std::hypot(least + change * angle, change);
  fit_quadratic = (slope_end - slope_start) / (2.0 * angle);
  fit_linear = slope_start;
  flat_length = fit_quadratic * angle * angle + fit_linear * angle;
}

double Arc::length() const { return std::hypot(flat_length, rise.norm()); }

Vec3 Arc::at_angle(double at) const {
  const Vec3 spoke = std::cos(at) * to_start + std::sin(at) * ahead;
  const double share = at / angle;
  return centre + spoke + share * spiral * spoke.normalized() + share * rise;
}

Vec3 Arc::at(double travelled) const {
  const double share = travelled / length();
  const double s = (inward ? 1.0 - share : share) * flat_length;
  const double root = std::sqrt(std::max(0.0, fit_linear * fit_linear + 4.0 * fit_quadratic * s));
  const double turned = 2.0 * s / (fit_linear + root);
  return at_angle(inward ? angle - turned : turned);
}

Vec3 Arc::tangent(double at) const {
  const Vec3 spoke = at_angle(at) - centre;
  return (normal.cross(spoke) + rise / angle + (spiral / angle) * spoke.normalized()).normalized();
}

bool Arc::shorten(double kept, bool keep_end) {
  if (kept <= tiny || rise.squaredNorm() > 1e-6) return false;
  if (keep_end) {
    to_start = at_angle(angle - kept) - centre;
    ahead = normal.cross(to_start);
    radius = to_start.norm();
  }
  spiral *= kept / angle;
  angle = kept;
  return true;
}

double Arc::least_radius_of_curvature() const {
  const double change = spiral / angle;
  const double inner = change * change + radius * radius;
  const double flat = std::sqrt(inner * inner * inner) / (inner + change * change);
  return rise.squaredNorm() / flat + flat;
}

Vec3 BlendArc::at(double travelled) const {
  const double on_arc = travelled - lead_length;
  if (on_arc <= 0.0 && lead_length > 0.0) return start + on_arc * lead_direction;
  const double turned = on_arc / radius;
  return centre + (std::sin(angle - turned) * to_start + std::sin(turned) * to_end) / std::sin(angle);
}

Vec3 BlendArc::tangent(bool at_end) const {
  const Vec3& spoke = at_end ? to_end : to_start;
  return (binormal.cross(spoke) + (spiral / angle) * spoke.normalized()).normalized();
}

Position Segment::position() const {
  switch (shape) {
    case Shape::line:
      return {line.at(progress * line.length / length), rotary.at(progress * rotary.length / length)};
    case Shape::arc:
      return {arc.at(progress), rotary.at(progress * rotary.length / length)};
    case Shape::blend:
      break;
  }
  return {blend.at(progress), rotary.end};
}

Position Segment::end_position() const {
  Segment there = *this;
  there.progress = length;
  return there.position();
}

Vec3 Segment::start_tangent() const { return shape == Shape::arc ? arc.tangent(0.0) : line.direction; }
Vec3 Segment::end_tangent() const { return shape == Shape::arc ? arc.tangent(arc.angle) : line.direction; }

Vec3 Segment::start_pull() const {
  if (shape != Shape::arc) return line.direction;
  const Vec3 spoke = arc.at_angle(0.0) - arc.centre;
  const double half_speed = 0.5 * speed_requested;
  return (acceleration_left() * arc.normal.cross(spoke).normalized() -
          half_speed * half_speed / arc.radius * spoke.normalized())
      .normalized();
}

Vec3 Segment::end_pull() const {
  if (shape != Shape::arc) return line.direction;
  return arc.normal.cross(arc.at_angle(arc.angle) - arc.centre).normalized();
}

// Two segments that overlap share the axes, so each may use half.
double Segment::acceleration_left() const {
  const double for_kinks = 1.0 - std::max(kink_loss, kink_loss_before);
  return acceleration * for_kinks * (parabolic_before || end == EndMode::parabolic ? 0.5 : 1.0);
}

double Segment::acceleration_along() const {
  return acceleration_left() * (shape == Shape::line ? 1.0 : along_arc_share);
}

double Segment::speed_target() const { return std::min(speed_requested, speed_max); }

void Segment::cap_speed_by_length() { speed_max = std::min(speed_max, length / cycle_s); }

void Segment::fix_length() {
  if (length_final) return;
  cap_speed_by_length();
  if (shape == Shape::arc) {
    const double total = acceleration_left(), across_most = normal_share * total,
                 radius = arc.least_radius_of_curvature();
    const double across = speed_max * speed_max / std::max(radius, tiny);
    along_arc_share = 0.5;
    if (across > across_most)
      speed_max = std::sqrt(across_most * radius);
    else
      along_arc_share = std::sqrt(1.0 - (across / total) * (across / total));
  }
  length_final = true;
}

void set_end(Segment& before, Segment* after, EndMode mode) {
  if (after) after->parabolic_before = mode == EndMode::parabolic;
  before.end = mode;
}

}  // namespace volute::sim::linuxcnc
