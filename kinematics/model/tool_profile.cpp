// The half section of a tool as a polyline that never cuts into the true profile.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/check.hpp"
#include "kinematics/model/tool.hpp"

namespace volute::kinematics {

namespace {

struct Arc {
  double centre_z_mm, centre_radius_mm, radius_mm, from_rad, to_rad;
};  // angle 0 points outward, -pi/2 to the tip

ProfilePoint on_arc(const Arc& arc, double distance_mm, double angle_rad) {
  return {arc.centre_z_mm + distance_mm * std::sin(angle_rad),
          arc.centre_radius_mm + distance_mm * std::cos(angle_rad)};
}

// Corners of the circumscribed polyline: tangents at the ends and between, meeting at radius / cos(step / 2).
// Its greatest distance from the arc is radius (1 / cos(step / 2) - 1), which fixes the number of steps.
void append_circumscribed(std::vector<ProfilePoint>& profile, const Arc& arc, double tolerance_mm) {
  const double span = arc.to_rad - arc.from_rad;
  const double half_step_max = std::acos(arc.radius_mm / (arc.radius_mm + tolerance_mm));
  const int steps = std::max(1, static_cast<int>(std::ceil(span / (2.0 * half_step_max))));
  const double step = span / steps;
  profile.push_back(on_arc(arc, arc.radius_mm, arc.from_rad));
  for (int k = 0; k < steps; ++k)
    profile.push_back(on_arc(arc, arc.radius_mm / std::cos(0.5 * step), arc.from_rad + (k + 0.5) * step));
  profile.push_back(on_arc(arc, arc.radius_mm, arc.to_rad));
}

void append_distinct(std::vector<ProfilePoint>& profile, ProfilePoint point) {
  if (!profile.empty() && std::abs(profile.back().z_mm - point.z_mm) < 1e-12 &&
      std::abs(profile.back().radius_mm - point.radius_mm) < 1e-12)
    return;
  profile.push_back(point);
}

// Where the rounded tip ends: 0 for the quarter circle of ball and bull, the taper for a cone that touches the ball.
double arc_end_rad(const Cutter& cutter) {
  return cutter.shape == CutterShape::taper_ball ? -cutter.taper.radians() : 0.0;
}

double taper_radius(const Cutter& cutter, double z_mm) {
  const double taper = cutter.taper.radians();
  const double touch_z_mm = cutter.radius_mm * (1.0 - std::sin(taper));
  return cutter.radius_mm * std::cos(taper) + (z_mm - touch_z_mm) * std::tan(taper);
}

}  // namespace

double cutter_radius_at(const Cutter& cutter, double z_mm) {
  if (z_mm < 0.0 || z_mm > cutter.length_mm) return 0.0;
  const double corner_mm = cutter.corner_radius_mm;
  const double arc_top_mm = corner_mm * (1.0 + std::sin(arc_end_rad(cutter)));
  if (z_mm < arc_top_mm) return cutter.radius_mm - corner_mm + std::sqrt(z_mm * (2.0 * corner_mm - z_mm));
  return cutter.shape == CutterShape::taper_ball ? taper_radius(cutter, z_mm) : cutter.radius_mm;
}

std::vector<ProfilePoint> cutter_profile(const Cutter& cutter, double tolerance_mm) {
  VOLUTE_CHECK(tolerance_mm > 0.0, tolerance_mm);
  std::vector<ProfilePoint> rough = {{0.0, 0.0}};
  if (cutter.corner_radius_mm > 0.0) {
    const Arc arc{cutter.corner_radius_mm, cutter.radius_mm - cutter.corner_radius_mm, cutter.corner_radius_mm,
                  -0.5 * std::numbers::pi, arc_end_rad(cutter)};
    append_circumscribed(rough, arc, tolerance_mm);
  } else {
    rough.push_back({0.0, cutter.radius_mm});
  }
  rough.push_back({cutter.length_mm, cutter_radius_at(cutter, cutter.length_mm)});
  std::vector<ProfilePoint> profile;
  for (const ProfilePoint& point : rough) append_distinct(profile, point);
  return profile;
}

std::vector<ProfilePoint> assembly_profile(const Tool& tool, double tolerance_mm) {
  std::vector<ProfilePoint> profile = cutter_profile(tool.cutter, tolerance_mm);
  if (tool.stick_out_mm > tool.cutter.length_mm) {
    append_distinct(profile, {tool.cutter.length_mm, tool.shank_radius_mm});
    append_distinct(profile, {tool.stick_out_mm, tool.shank_radius_mm});
  }
  for (const ConeSegment& segment : tool.holder) {
    append_distinct(profile, {segment.z_mm, segment.bottom_radius_mm});
    append_distinct(profile, {segment.z_mm + segment.length_mm, segment.top_radius_mm});
  }
  return profile;
}

}  // namespace volute::kinematics
