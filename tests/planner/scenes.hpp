// Small bodies for tests.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "geometry/mesh.hpp"
#include "kinematics/model/machine.hpp"
#include "kinematics/model/tool.hpp"

namespace volute::planner::testing {

using geometry::TriangleMesh;
using geometry::Vec3;

/// A closed box.
inline TriangleMesh box(const Vec3& least, const Vec3& greatest) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.vertices_mm.emplace_back((k & 1) != 0 ? greatest.x() : least.x(), (k & 2) != 0 ? greatest.y() : least.y(),
                                  (k & 4) != 0 ? greatest.z() : least.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// z = height(x, y) over a rectangle, in cells of about `step`.
inline TriangleMesh sheet(double x0, double x1, double y0, double y1, double step,
                          const std::function<double(double, double)>& height) {
  TriangleMesh mesh;
  const int nx = static_cast<int>(std::ceil((x1 - x0) / step)), ny = static_cast<int>(std::ceil((y1 - y0) / step));
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      const double x = x0 + (x1 - x0) * i / nx, y = y0 + (y1 - y0) * j / ny;
      mesh.vertices_mm.emplace_back(x, y, height(x, y));
    }
  }
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i;
      mesh.triangles.push_back({a, a + 1, a + nx + 2});
      mesh.triangles.push_back({a, a + nx + 2, a + nx + 1});
    }
  }
  return mesh;
}

/// Ball of radius 3, 20 long, on a shank of radius 3 with a holder of radius 15 from 40 to 80.
inline kinematics::Tool ball_tool() {
  kinematics::Tool tool;
  tool.cutter = {kinematics::CutterShape::ball, 3.0, 3.0, {}, 20.0, 2};
  tool.shank_radius_mm = 3.0;
  tool.stick_out_mm = 40.0;
  tool.holder = {{15.0, 15.0, 40.0, 40.0}};
  return tool;
}

/// Dual rotary head: C on the gantry, A on C; the axis is (sin C sin A, -cos C sin A, cos A), [Sun2016] eq. 22.
inline kinematics::Machine ac_head() {
  kinematics::Machine machine;
  machine.name = "ac-head";
  machine.kind = "head-head";
  const char letters[] = {'X', 'Y', 'Z', 'A', 'C'};
  for (std::size_t k = 0; k < 5; ++k) {
    kinematics::Axis& axis = machine.axes[k];
    axis.letter = letters[k];
    axis.kind = k < 3 ? kinematics::AxisKind::linear : kinematics::AxisKind::rotary;
    axis.direction_M =
        k == 3 ? Vec3::UnitX() : (k == 4 ? Vec3::UnitZ() : Vec3(Vec3::Unit(static_cast<Eigen::Index>(k))));
  }
  machine.axes[3].travel_min = -2.0;
  machine.axes[3].travel_max = 2.0;
  machine.chain = {0, 1, 2, 4, 3};
  return machine;
}

}  // namespace volute::planner::testing
