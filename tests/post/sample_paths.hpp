// Small tool paths with known geometry.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/check.hpp"
#include "kinematics/model/control.hpp"
#include "post/post.hpp"

namespace volute::post::testing {

/// A spiral down a dome of radius 40 mm about the part's origin, the tool along the normal: C winds one turn per turn
/// of the spiral. Rapid above, approach, cut, retract.
inline kinematics::ToolPath dome_spiral(int turns, int points_per_turn, double feed_mm_s = 25.0) {
  constexpr double radius_mm = 40.0;
  kinematics::ToolPath path;
  const int count = turns * points_per_turn;
  for (int i = 0; i <= count; ++i) {
    const double along = static_cast<double>(i) / count, azimuth = 2.0 * std::numbers::pi * turns * along;
    const double polar = 0.15 + 0.75 * along;
    const geometry::Vec3 normal(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                                std::cos(polar));
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

inline kinematics::ToolPathPoint at(const geometry::Vec3& tip_P_mm, double tilt_deg, double azimuth_deg,
                                    kinematics::MoveKind move) {
  const double tilt = geometry::Angle::degrees(tilt_deg).radians(),
               azimuth = geometry::Angle::degrees(azimuth_deg).radians();
  kinematics::ToolPathPoint point;
  point.pose = {tip_P_mm, {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)}};
  point.move = move;
  point.feed_mm_s = move == kinematics::MoveKind::rapid ? 0.0 : 20.0;
  return point;
}

/// Every kind of move once: rapid above, approach, four cuts (one without turning, one along Z alone), a link, a rapid
/// jump, retract.
inline kinematics::ToolPath short_pass() {
  using kinematics::MoveKind;
  kinematics::ToolPath path;
  path.points = {at({10, 20, 40}, 20, 0, MoveKind::rapid),         at({10, 20, 5}, 20, 0, MoveKind::approach),
                 at({10.5, 20, 5}, 20.02, 0.05, MoveKind::cut),    at({11, 20.25, 5}, 20.02, 0.05, MoveKind::cut),
                 at({11, 20.25, 4.5}, 20.02, 0.05, MoveKind::cut), at({11.5, 20.5, 4.5}, 20.04, 0.1, MoveKind::cut),
                 at({12, 21, 4.75}, 20.06, 0.15, MoveKind::link),  at({12, 21, 10}, 20.06, 0.15, MoveKind::retract),
                 at({10, 20, 40}, 20, 0, MoveKind::rapid)};
  path.points[4].feed_mm_s = 10.0;
  return path;
}

/// A ring of radius 20 mm, the tool leaning outward by 30 degrees.
inline kinematics::ToolPath ring(double turns, int points_per_turn) {
  using kinematics::MoveKind;
  kinematics::ToolPath path;
  const int count = static_cast<int>(turns * points_per_turn);
  for (int i = 0; i <= count; ++i) {
    const double azimuth_deg = 360.0 * i / points_per_turn, azimuth = geometry::Angle::degrees(azimuth_deg).radians();
    path.points.push_back(at({20 * std::cos(azimuth), 20 * std::sin(azimuth), 0.0}, 30, azimuth_deg,
                             i == 0 ? MoveKind::approach : MoveKind::cut));
  }
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

/// Every machine with every control that is meant for it.
inline std::vector<std::string> all_profiles() {
  std::vector<std::string> names;
  const auto listed = kinematics::list_profiles(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines");
  for (const kinematics::ProfileName& name : *listed) names.push_back(name.name);
  return names;
}

/// A name that GoogleTest takes.
inline std::string identifier(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

inline kinematics::Profile profile_named(const std::string& name) {
  auto profile = kinematics::load_profile(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines", name);
  VOLUTE_CHECK(profile.has_value(), name, profile ? "" : profile.error().message);
  return *profile;
}

}  // namespace volute::post::testing
