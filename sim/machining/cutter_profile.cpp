#include "sim/machining/cutter_profile.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::sim {
namespace {

using kinematics::CutterShape;

struct Nearest {
  double square = 0.0;
  Vec2 point = Vec2::Zero();
};

void take_segment(Nearest& nearest, const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const double length_sq = ab.squaredNorm();
  const double s = length_sq > 0.0 ? std::clamp((p - a).dot(ab) / length_sq, 0.0, 1.0) : 0.0;
  const Vec2 foot = a + s * ab;
  const double square = (p - foot).squaredNorm();
  if (square < nearest.square) nearest = {square, foot};
}

Vec2 outward_normal(const Vec2& a, const Vec2& b) { return Vec2(b.y() - a.y(), a.x() - b.x()).normalized(); }

}  // namespace

CutterProfile::CutterProfile(const kinematics::Cutter& cutter) {
  const double r = cutter.radius_mm;
  const bool ball = cutter.shape == CutterShape::ball || cutter.shape == CutterShape::taper_ball;
  arc_radius_ = ball ? r : (cutter.shape == CutterShape::flat ? 0.0 : cutter.corner_radius_mm);
  const double taper = cutter.shape == CutterShape::taper_ball ? cutter.taper.radians() : 0.0;
  VOLUTE_CHECK(r > 0.0 && arc_radius_ <= r && cutter.length_mm >= arc_radius_, r, arc_radius_, cutter.length_mm);
  flat_end_ = Vec2(r - arc_radius_, 0.0);
  arc_centre_ = Vec2(r - arc_radius_, arc_radius_);
  flank_start_ = arc_centre_ + arc_radius_ * Vec2(std::cos(taper), -std::sin(taper));
  const double rise = std::max(0.0, cutter.length_mm - flank_start_.y());
  flank_end_ = flank_start_ + Vec2(rise * std::tan(taper), rise);
}

bool CutterProfile::inside(double radius_mm, double z_mm) const {
  if (z_mm < 0.0 || z_mm > flank_end_.y()) return false;
  if (z_mm < flank_start_.y()) {
    if (radius_mm <= flat_end_.x()) return true;
    return (Vec2(radius_mm, z_mm) - arc_centre_).squaredNorm() <= arc_radius_ * arc_radius_;
  }
  const double rise = flank_end_.y() - flank_start_.y();
  const double share = rise > 0.0 ? (z_mm - flank_start_.y()) / rise : 0.0;
  return radius_mm <= flank_start_.x() + share * (flank_end_.x() - flank_start_.x());
}

CutterProfile::Distance CutterProfile::distance(double radius_mm, double z_mm) const {
  const Vec2 p(radius_mm, z_mm);
  const Vec2 from_centre = p - arc_centre_;
  Nearest nearest{(p - flank_end_).squaredNorm(), flank_end_};
  take_segment(nearest, p, flank_start_, flank_end_);
  take_segment(nearest, p, flank_end_, Vec2(0.0, flank_end_.y()));
  if (flat_end_.x() > 0.0) take_segment(nearest, p, Vec2::Zero(), flat_end_);
  const Vec2 flank_normal = outward_normal(flank_start_, flank_end_);
  const bool in_span = from_centre.x() >= 0.0 && from_centre.dot(Vec2(flank_normal.y(), -flank_normal.x())) >= 0.0;
  if (arc_radius_ > 0.0 && in_span) {
    const double length = from_centre.norm();
    const Vec2 unit = length > 0.0 ? Vec2(from_centre / length) : Vec2(0.0, -1.0);
    const double gap = length - arc_radius_;
    if (gap * gap <= nearest.square) return {gap, unit};
  }
  const double sign = inside(radius_mm, z_mm) ? -1.0 : 1.0;
  const double value = std::sqrt(nearest.square);
  // On the boundary itself the direction of the foot is lost; the flank's normal stands for it (only its sign matters
  // there).
  const Vec2 gradient = value > 0.0 ? Vec2(sign * (p - nearest.point) / value) : flank_normal;
  return {sign * value, gradient};
}

Vec2 CutterProfile::support(double along_axis) const {
  const double away = std::sqrt(std::max(0.0, 1.0 - along_axis * along_axis));
  const Vec2 direction(away, along_axis);
  const Vec2 flank_normal = outward_normal(flank_start_, flank_end_);
  const bool below_flank = direction.dot(Vec2(flank_normal.y(), -flank_normal.x())) >= 0.0;
  if (below_flank) return arc_centre_ + arc_radius_ * direction;
  return flank_end_;
}

namespace {

/// Signed distance at a height on the line, and its slope there.
struct LineDistance {
  const CutterProfile& profile;
  Vec3 start;  // relative to the tip
  Vec3 direction;
  Vec3 axis;

  struct Value {
    double distance, slope;
  };
  [[nodiscard]] Value at(double t) const {
    const Vec3 p = start + t * direction;
    const double z = p.dot(axis);
    const Vec3 away = p - z * axis;
    const double radius = away.norm();
    const auto d = profile.distance(radius, z);
    const double slope_z = direction.dot(axis);
    const double slope_radius =
        radius > 0.0 ? direction.dot(away) / radius : std::sqrt(std::max(0.0, 1.0 - slope_z * slope_z));
    return {d.value_mm, d.gradient.x() * slope_radius + d.gradient.y() * slope_z};
  }
};

constexpr double entry_tolerance_mm = 1e-10;
constexpr int entry_iterations = 60;

/// Newton upwards from a point outside. Requires: the distance at t is positive.
std::optional<double> newton_up(const LineDistance& line, double t, double limit_mm) {
  for (int i = 0; i < entry_iterations; ++i) {
    const auto value = line.at(t);
    if (value.distance <= entry_tolerance_mm) return t;
    if (value.slope >= 0.0) return std::nullopt;  // convex: it only grows from here
    t -= value.distance / value.slope;
    if (t > limit_mm) return std::nullopt;
  }
  return line.at(t).distance <= 1e-6 ? std::optional<double>(t) : std::nullopt;
}

}  // namespace

std::optional<double> line_entry_mm(const CutterProfile& profile, const StandingCutter& cutter, const Vec3& point_mm,
                                    const Vec3& direction, double limit_mm) {
  const LineDistance line{profile, point_mm - cutter.tip_mm, direction, cutter.axis};
  // From below the plane of its bottom a line can only enter above it: the iteration begins there.
  const double rise = direction.dot(cutter.axis), below_bottom_mm = -line.start.dot(cutter.axis);
  if (below_bottom_mm > 0.0) {
    if (rise <= 0.0 || below_bottom_mm > limit_mm * rise) return std::nullopt;
    return newton_up(line, below_bottom_mm / rise, limit_mm);
  }
  // Cheap refusal first: the middle of the asked stretch is farther than half the stretch.
  const double half = 0.5 * limit_mm;
  if (limit_mm > 0.0 && line.at(half).distance > half) return std::nullopt;
  const double at_point = line.at(0.0).distance;
  if (at_point > 0.0) return newton_up(line, 0.0, limit_mm);
  const double below = -2.0 * (profile.length_mm() + profile.greatest_radius_mm());
  // What rises along the line begins no lower than the plane of the bottom: a flat end that faces it exactly there.
  return newton_up(line, rise > 0.0 ? std::max(below, below_bottom_mm / rise) : below, limit_mm);
}

}  // namespace volute::sim
