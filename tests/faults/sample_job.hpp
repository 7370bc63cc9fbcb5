// The job that every good program of this folder does: a square patch of 6 x 6 mm, z = 0, finished by a ball of 3 mm in
// 13 passes.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/mesh.hpp"
#include "post/post.hpp"

namespace volute::faults {

constexpr double half_size_mm = 3.0, step_over_mm = 0.5, feed_mm_s = 20.0;

inline geometry::TriangleMesh patch() {
  geometry::TriangleMesh mesh;
  mesh.vertices_mm = {{-half_size_mm, -half_size_mm, 0},
                      {half_size_mm, -half_size_mm, 0},
                      {half_size_mm, half_size_mm, 0},
                      {-half_size_mm, half_size_mm, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A plate below the part, 2 mm under its surface: what a tool hits that turns before it is lifted.
inline geometry::TriangleMesh fixture() {
  geometry::TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices_mm.emplace_back(corner & 1 ? 140.0 : -140.0, corner & 2 ? 140.0 : -140.0, corner & 4 ? -2.0 : -12.0);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline kinematics::Tool tool() {
  kinematics::Tool tool;
  tool.gauge_length_mm = 120.0;
  tool.holder = {{10.0, 12.0, 40.0, 30.0}, {16.0, 16.0, 70.0, 50.0}};
  return tool;
}

inline kinematics::ToolPathPoint point_at(double x_mm, double y_mm, double height_mm, double azimuth_rad,
                                          kinematics::MoveKind move) {
  constexpr double tilt = 20.0 * std::numbers::pi / 180.0;
  const double radius_mm = tool().cutter.radius_mm;
  kinematics::ToolPathPoint point;
  point.pose.axis_P = {std::sin(tilt) * std::cos(azimuth_rad), std::sin(tilt) * std::sin(azimuth_rad), std::cos(tilt)};
  point.contact_P_mm = {x_mm, y_mm, 0.0};
  point.pose.tip_P_mm =
      point.contact_P_mm + radius_mm * (geometry::Vec3::UnitZ() - point.pose.axis_P) + height_mm * point.pose.axis_P;
  point.move = move;
  point.feed_mm_s = move == kinematics::MoveKind::rapid ? 0.0 : feed_mm_s;
  return point;
}

/// Back and forth, the tool leaning by 20 degrees to a side that turns by 60 degrees over the whole path.
inline kinematics::ToolPath passes() {
  using kinematics::MoveKind;
  kinematics::ToolPath path;
  const int count = static_cast<int>(2.0 * half_size_mm / step_over_mm) + 1;
  for (int pass = 0; pass < count; ++pass)
    for (int k = 0; k < 3; ++k) {
      const double x_mm = (pass % 2 == 0 ? 1.0 : -1.0) * half_size_mm * (k - 1),
                   y_mm = -half_size_mm + pass * step_over_mm;
      const double azimuth = std::numbers::pi / 3.0 * (3 * pass + k) / (3 * count - 1);
      path.points.push_back(point_at(x_mm, y_mm, 0.0, azimuth, pass > 0 && k == 0 ? MoveKind::link : MoveKind::cut));
    }
  kinematics::ToolPathPoint first = path.points.front(), last = path.points.back();
  path.points.front().move = MoveKind::approach;
  first.pose.tip_P_mm += 15.0 * first.pose.axis_P;
  first.move = MoveKind::rapid;
  first.feed_mm_s = 0.0;
  last.pose.tip_P_mm += 15.0 * last.pose.axis_P;
  last.move = MoveKind::retract;
  path.points.insert(path.points.begin(), first);
  path.points.push_back(last);
  return path;
}

inline post::PostRequest request() {
  post::PostRequest request;
  request.program_name = "patch";
  request.path = passes();
  request.tool = tool();
  request.spindle_rpm = 12000.0;
  return request;
}

}  // namespace volute::faults
