// Surfaces and cutters that the tests of this folder share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>

#include "geometry/mesh.hpp"
#include "sim/machining/cut_surface.hpp"
#include "tests/cases.hpp"

namespace volute::sim::test {

using geometry::TriangleMesh;
using geometry::Vec3;

/// A grid of (columns x rows) quads over [0, 1]^2 taken to space.
inline TriangleMesh sheet(int columns, int rows, const std::function<Vec3(double, double)>& at) {
  TriangleMesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i)
      mesh.vertices_mm.push_back(at(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
  }
  const auto vertex = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

/// The horizontal square [0, side]^2 at z = 0.
inline TriangleMesh plane(double side_mm, int cuts = 1) {
  return sheet(cuts, cuts, [=](double u, double v) { return Vec3(side_mm * u, side_mm * v, 0.0); });
}

/// A pose on a line of the program, 0.1 s a line.
inline SweptPose pose_at(const Vec3& tip, const Vec3& axis = Vec3::UnitZ(), std::int64_t line = 1, bool rapid = false) {
  return {{tip, axis}, line, 0.1 * static_cast<double>(line), rapid};
}

inline kinematics::Cutter ball(double radius_mm, double length_mm = 20.0) {
  return {kinematics::CutterShape::ball, radius_mm, radius_mm, {}, length_mm, 2};
}
inline kinematics::Cutter flat(double radius_mm, double length_mm = 20.0) {
  return {kinematics::CutterShape::flat, radius_mm, 0.0, {}, length_mm, 2};
}
inline kinematics::Cutter bull(double radius_mm, double corner_mm, double length_mm = 20.0) {
  return {kinematics::CutterShape::bull, radius_mm, corner_mm, {}, length_mm, 2};
}
inline kinematics::Cutter taper_ball(double radius_mm, double half_angle_deg, double length_mm = 20.0) {
  return {kinematics::CutterShape::taper_ball,      radius_mm, radius_mm,
          geometry::Angle::degrees(half_angle_deg), length_mm, 2};
}

/// Random unit vector, uniform on the sphere.
inline Vec3 random_unit(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// The pose that puts a ball's centre somewhere with the axis given.
inline SweptPose ball_at(const Vec3& centre_mm, const Vec3& axis, double radius_mm, std::int64_t line) {
  return {{centre_mm - radius_mm * axis, axis}, line, 0.1 * static_cast<double>(line), false};
}

/// Parallel passes along y over the plane z = 0, x from -interval to side + interval, lines counted from 1.
inline std::vector<SweptPose> passes_on_plane(double side_mm, double interval_mm, double radius_mm, const Vec3& axis) {
  std::vector<SweptPose> poses;
  std::int64_t line = 1;
  for (double x = -interval_mm; x <= side_mm + interval_mm + 1e-9; x += interval_mm) {
    poses.push_back(ball_at({x, -1.0, radius_mm}, axis, radius_mm, line++));
    poses.push_back(ball_at({x, side_mm + 1.0, radius_mm}, axis, radius_mm, line++));
    poses.push_back(ball_at({x, side_mm + 1.0, radius_mm + 20.0}, axis, radius_mm, line++));
    poses.push_back(ball_at({x, -1.0, radius_mm + 20.0}, axis, radius_mm, line++));
  }
  return poses;
}

/// The measured relative error, in millionths, beside the test's result (--gtest_output=xml:FILE).
inline void record_error(const std::string& key, double got, double expected) {
  ::testing::Test::RecordProperty(key, std::to_string(1e6 * (got - expected) / expected));
}

}  // namespace volute::sim::test
