// Small tool paths with known geometry.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/check.hpp"
#include "kinematics/model/control.hpp"
#include "post/post.hpp"

namespace volute::post::testing {

/// A spiral down a dome of radius 40 mm about the part's origin, tool axis leaning `tilt_rad` outward from the normal's upright share:
/// C winds one turn per turn of the spiral. Rapid above, approach, cut, retract.
inline kinematics::ToolPath dome_spiral(int turns, int points_per_turn, double feed_mm_s = 25.0) {
  constexpr double radius_mm = 40.0;
  kinematics::ToolPath path;
  const int count = turns * points_per_turn;
  for (int i = 0; i <= count; ++i) {
    const double along = static_cast<double>(i) / count, azimuth = 2.0 * std::numbers::pi * turns * along;
    const double polar = 0.15 + 0.75 * along;
    const geometry::Vec3 normal(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
    kinematics::ToolPathPoint point;
    point.pose = {radius_mm * normal, normal};
    point.feed_mm_s = feed_mm_s;
    point.contact_P_mm = point.pose.tip_P_mm;
    point.normal_P = normal;
    path.points.push_back(point);
  }
  kinematics::ToolPathPoint above = path.points.front();
  above.pose.tip_P_mm += 20.0 * above.pose.axis_P;
  above.move = kinematics::MoveKind::rapid;
  above.feed_mm_s = 0.0;
  path.points.front().move = kinematics::MoveKind::approach;
  path.points.insert(path.points.begin(), above);
  kinematics::ToolPathPoint away = path.points.back();
  away.pose.tip_P_mm += 20.0 * away.pose.axis_P;
  away.move = kinematics::MoveKind::retract;
  path.points.push_back(away);
  return path;
}

inline PostRequest request_for(kinematics::ToolPath path) {
  PostRequest request;
  request.program_name = "dome spiral";
  request.path = std::move(path);
  request.tool.gauge_length_mm = 120.0;
  request.spindle_rpm = 12000.0;
  return request;
}

inline kinematics::Profile profile_named(const std::string& name) {
  auto profile = kinematics::load_profile(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines", name);
  VOLUTE_CHECK(profile.has_value(), name, profile ? "" : profile.error().message);
  return *profile;
}

}  // namespace volute::post::testing
