#include "planner/contact.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/check.hpp"

namespace volute::planner {

using kinematics::Cutter;
using kinematics::CutterShape;
using kinematics::ToolPose;

namespace {

// Below this sine of the tilt the axis counts as the normal: the contact of a flat bottom is its centre.
constexpr double least_tilt_sine = 1e-9;

bool has_ball_tip(const Cutter& cutter) {
  return cutter.shape == CutterShape::ball || cutter.shape == CutterShape::taper_ball;
}

/// Radius of the circle on which the centre of the corner's arc runs round the axis: 0 for a ball.
double corner_circle_radius_mm(const Cutter& cutter) {
  return has_ball_tip(cutter) ? 0.0 : cutter.radius_mm - cutter.corner_radius_mm;
}

double tip_arc_radius_mm(const Cutter& cutter) {
  if (has_ball_tip(cutter)) return cutter.radius_mm;
  return cutter.shape == CutterShape::flat ? 0.0 : cutter.corner_radius_mm;
}

/// The outline that a cutter touching the origin shows along the feed (x): across is y, the surface's normal z.
/// Point t of a side is where the cutter's outward normal is (0, side sin t, -cos t).
class Outline {
 public:
  Outline(const Cutter& cutter, const Vec3& axis)
      : arc_(tip_arc_radius_mm(cutter)),
        circle_(corner_circle_radius_mm(cutter)),
        axis_(axis),
        tip_(contact_pose(cutter, Vec3::Zero(), Vec3::UnitZ(), axis).tip_P_mm) {}

  /// How far the outline reaches to one side, at the height; where the rounded part ends below it along the flank, or,
  /// where that leans back, no farther.
  [[nodiscard]] double reach_mm(double side, double height_mm) const {
    const double lean = side * axis_.y();
    double low = 0.0, high = lean > 0.0 ? std::atan2(axis_.z(), lean) : 0.5 * std::numbers::pi;
    Vec3 below = Vec3::Zero(), above = point(side, high);
    if (above.z() < height_mm) {
      const double along_flank = lean > 0.0 ? (height_mm - above.z()) * lean / axis_.z() : 0.0;
      return side * above.y() + along_flank;
    }
    // The flat bottom is one angle: there the outline jumps, and the height lies on the line between both ends. 40
    // rounds end 1e-12 rad beside it, where the rim's direction still has four digits.
    for (int round = 0; round < 40; ++round) {
      const double middle = 0.5 * (low + high);
      const Vec3 p = point(side, middle);
      (p.z() < height_mm ? low : high) = middle;
      (p.z() < height_mm ? below : above) = p;
    }
    const double rise = above.z() - below.z();
    const double share = rise > 0.0 ? (height_mm - below.z()) / rise : 1.0;
    return side * (below.y() + share * (above.y() - below.y()));
  }

 private:
  [[nodiscard]] Vec3 point(double side, double angle_rad) const {
    const Vec3 out(0.0, side * std::sin(angle_rad), -std::cos(angle_rad));
    const Vec3 square = out - out.dot(axis_) * axis_;
    const Vec3 rim = circle_ > 0.0 ? Vec3(circle_ * square.normalized()) : Vec3::Zero();
    return tip_ + arc_ * axis_ + rim + arc_ * out;
  }

  double arc_, circle_;
  Vec3 axis_, tip_;
};

}  // namespace

FeedFrame feed_frame(const Vec3& feed_P, const Vec3& normal_P) {
  const Vec3 normal = normal_P.normalized();
  const Vec3 along = feed_P - feed_P.dot(normal) * normal;
  VOLUTE_CHECK(along.norm() > 1e-12 * feed_P.norm(), feed_P.transpose(), normal_P.transpose());
  FeedFrame frame;
  frame.feed_P = along.normalized();
  frame.normal_P = normal;
  frame.across_P = normal.cross(frame.feed_P);
  return frame;
}

Vec3 tool_axis(const FeedFrame& frame, geometry::Angle tilt, geometry::Angle yaw) {
  const double out = sin(tilt);
  const Vec3 axis = out * cos(yaw) * frame.feed_P + out * sin(yaw) * frame.across_P + cos(tilt) * frame.normal_P;
  return axis.normalized();
}

ToolPose contact_pose(const Cutter& cutter, const Vec3& contact_P_mm, const Vec3& normal_P, const Vec3& axis_P) {
  VOLUTE_CHECK(axis_P.dot(normal_P) >= 0.0, axis_P.transpose(), normal_P.transpose());
  const double arc = tip_arc_radius_mm(cutter);
  const double circle = corner_circle_radius_mm(cutter);
  // The cutter's outward normal at the contact is -normal: its part square to the axis points to the touching arc.
  const Vec3 square = -(normal_P - normal_P.dot(axis_P) * axis_P);
  const double sine = square.norm();
  ToolPose pose;
  pose.axis_P = axis_P;
  pose.tip_P_mm = contact_P_mm;
  if (circle > 0.0 && sine < least_tilt_sine) return pose;
  pose.tip_P_mm += arc * (normal_P - axis_P);
  if (circle > 0.0) pose.tip_P_mm -= circle / sine * square;
  return pose;
}

double effective_radius_mm(const Cutter& cutter, geometry::Angle tilt, geometry::Angle yaw) {
  const double arc = tip_arc_radius_mm(cutter);
  const double circle = corner_circle_radius_mm(cutter);
  if (circle == 0.0) return arc;
  const double sine = std::abs(sin(tilt));
  if (sine < least_tilt_sine) return std::numeric_limits<double>::infinity();
  // Principal radii at the contact: the arc's own in the plane of axis and normal, and the length of the normal to the
  // axis across it. The swept profile is the outline seen along the feed, whose radius is r1 r2 (cos^2/r1 + sin^2/r2).
  const double round_axis = arc + circle / sine;
  return round_axis * cos(yaw) * cos(yaw) + arc * sin(yaw) * sin(yaw);
}

double cleared_width_mm(const Cutter& cutter, geometry::Angle tilt, geometry::Angle yaw, double height_mm) {
  const FeedFrame along_x{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const Vec3 axis = tool_axis(along_x, tilt, yaw);
  VOLUTE_CHECK(height_mm > 0.0 && axis.z() > 0.0, height_mm, tilt.radians());
  const Outline outline(cutter, axis);
  return outline.reach_mm(1.0, height_mm) + outline.reach_mm(-1.0, height_mm);
}

double clearing_radius_mm(const Cutter& cutter, geometry::Angle tilt, geometry::Angle yaw, double height_mm) {
  if (has_ball_tip(cutter)) return cutter.radius_mm;
  const double half_width = 0.5 * cleared_width_mm(cutter, tilt, yaw, height_mm);
  return (half_width * half_width + height_mm * height_mm) / (2.0 * height_mm);
}

}  // namespace volute::planner
