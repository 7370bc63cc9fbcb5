#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "geometry/mesh_measure.hpp"
#include "planner/path/scallop_map.hpp"

namespace volute::planner {
namespace {

TriangleMesh sheet(int cells, double edge_mm, double bend) {
  TriangleMesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const double x = i * edge_mm, y = j * edge_mm;
      mesh.vertices_mm.emplace_back(x, y, bend * std::sin(0.4 * x) * std::cos(0.3 * y));
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

/// Straight passes along x, in boustrophedon pieces of their own.
CcPath passes(double interval_mm, double size_mm) {
  CcPath path;
  for (double y = 0.0; y <= size_mm + 1e-9; y += interval_mm) {
    CcPiece piece;
    for (double x : {0.0, size_mm}) piece.points.push_back({Vec3(x, y, 0.0), Vec3::UnitZ(), 0.0, false});
    path.pieces.push_back(piece);
  }
  return path;
}

// Closed form: two balls of radius r at distance L on a plane leave h = r - sqrt(r^2 - L^2 / 4).
TEST(ScallopMap, ExactIntervalOnAPlaneGivesRatioOne) {
  const double radius = 3.0, scallop = 0.2, interval = path_interval_mm(radius, scallop, 0.0);
  const TriangleMesh mesh = sheet(60, 4.0 * interval / 60.0, 0.0);
  const auto normals = geometry::vertex_normals(mesh);
  const ScallopMap map =
      measure_scallop(mesh, normals, passes(interval, 4.0 * interval), radius, scallop, {.per_edge = 4});
  EXPECT_NEAR(map.statistics.max_ratio, 1.0, 0.03);  // samples next to, not on, the crest; balls a twentieth apart
  EXPECT_LE(map.statistics.max_ratio, 1.0 + 0.003);
  EXPECT_NEAR(*std::max_element(map.worst_ratio.begin(), map.worst_ratio.end()), map.statistics.max_ratio, 0.0);
}

TEST(ScallopMap, UncutPlacesCountTheRadius) {
  const double radius = 3.0, scallop = 0.2, interval = path_interval_mm(radius, scallop, 0.0);
  const TriangleMesh mesh = sheet(40, interval, 0.0);
  const auto normals = geometry::vertex_normals(mesh);
  const ScallopMap map = measure_scallop(mesh, normals, passes(interval, 4.0 * interval), radius, scallop);
  EXPECT_DOUBLE_EQ(map.statistics.max_ratio, radius / scallop);
  EXPECT_GT(map.statistics.area_above_percent, 80.0);
}

// Closed form: at distance d from a straight pass on a plane the height is r - sqrt(r^2 - d^2), greatest at the corners
// of the sheet, which no inner sample reaches.
TEST(ScallopMap, BoundaryAndCornersAreMeasuredWhereTheyAre) {
  const double radius = 3.0, scallop = 0.2, interval = path_interval_mm(radius, scallop, 0.0);
  const TriangleMesh mesh = sheet(8, 0.55 * interval / 8.0, 0.0);
  const auto normals = geometry::vertex_normals(mesh);
  CcPath path = passes(interval, 0.55 * interval);
  path.pieces.resize(1);
  const ScallopMap map = measure_scallop(mesh, normals, path, radius, scallop);
  const double off = 0.55 * interval, height = radius - std::sqrt(radius * radius - off * off);
  EXPECT_NEAR(map.statistics.max_ratio, height / scallop, 3e-3);  // balls a twentieth of an interval apart
  const auto worst = std::max_element(map.worst_ratio.begin(), map.worst_ratio.end()) - map.worst_ratio.begin();
  EXPECT_NEAR(map.worst_place_P_mm[static_cast<std::size_t>(worst)].y(), off, 1e-9);
}

// The crest between two passes runs beside every sample of a coarse sheet: only a closer look finds its height.
TEST(ScallopMap, CrestsBetweenSamplesAreFound) {
  const double radius = 3.0, scallop = 0.2, interval = path_interval_mm(radius, scallop, 0.0);
  const TriangleMesh mesh = sheet(3, 2.0 * interval / 3.0, 0.0);
  const auto normals = geometry::vertex_normals(mesh);
  const ScallopMap map =
      measure_scallop(mesh, normals, passes(1.1 * interval, 3.0 * interval), radius, scallop, {.per_edge = 3});
  const double off = 0.55 * interval, height = radius - std::sqrt(radius * radius - off * off);
  EXPECT_NEAR(map.statistics.max_ratio, height / scallop, 0.02);
}

// Independent computation: every ball of every path, sampled far more densely, against every sample point; no grid.
TEST(ScallopMap, EqualsBruteForceOnACurvedSheet) {
  const double radius = 2.0, scallop = 0.15, interval = path_interval_mm(radius, scallop, 0.0);
  const TriangleMesh mesh = sheet(24, 0.35, 0.6);
  const auto normals = geometry::vertex_normals(mesh);
  CcPath path;
  for (int row = 0; row <= 24; row += 4) {
    CcPiece piece;
    for (int i = 0; i <= 24; ++i) {
      const auto v = static_cast<std::size_t>(row * 25 + i);
      piece.points.push_back({mesh.vertices_mm[v], normals[v], 0.0, false});
    }
    path.pieces.push_back(piece);
  }
  const ScallopMap map = measure_scallop(mesh, normals, path, radius, scallop, {.per_edge = 1});
  std::vector<Vec3> centres;
  for (const CcPiece& piece : path.pieces) {
    for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
      for (int s = 0; s <= 60; ++s) {
        const CcPoint &a = piece.points[i], &b = piece.points[i + 1];
        const double w = s / 60.0;
        centres.push_back((1 - w) * a.point_P_mm + w * b.point_P_mm +
                          radius * ((1 - w) * a.normal_P + w * b.normal_P).normalized());
      }
    }
  }
  double worst_difference = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    // The normal where the map found the worst place, from the place's barycentric coordinates.
    const Vec3& x = map.worst_place_P_mm[t];
    const auto corner = [&](int k) { return static_cast<std::size_t>(mesh.triangles[t][static_cast<std::size_t>(k)]); };
    const Vec3 a = mesh.vertices_mm[corner(0)], ab = mesh.vertices_mm[corner(1)] - a,
               ac = mesh.vertices_mm[corner(2)] - a, across = ab.cross(ac);
    const double v = (x - a).cross(ac).dot(across) / across.squaredNorm(),
                 w = ab.cross(x - a).dot(across) / across.squaredNorm();
    ASSERT_GE(std::min({v, w, 1.0 - v - w}), -1e-9) << "triangle " << t;
    const Vec3 n = ((1.0 - v - w) * normals[corner(0)] + v * normals[corner(1)] + w * normals[corner(2)]).normalized();
    double height = radius;
    for (const Vec3& c : centres) {
      const Vec3 d = c - x;
      const double along = d.dot(n), disc = radius * radius - d.squaredNorm() + along * along;
      if (disc >= 0.0) height = std::min(height, along - std::sqrt(disc));
    }
    worst_difference = std::max(worst_difference, std::abs(height / scallop - map.worst_ratio[t]));
  }
  EXPECT_LT(worst_difference, 0.01);
  (void)interval;
}

TEST(ScallopMap, RemovingAPassLowersNothing) {
  const double radius = 2.0, scallop = 0.15, interval = path_interval_mm(radius, scallop, 0.0);
  const TriangleMesh mesh = sheet(30, 5.0 * interval / 30.0, 0.0);
  const auto normals = geometry::vertex_normals(mesh);
  CcPath path = passes(interval, 5.0 * interval);
  const ScallopMap all = measure_scallop(mesh, normals, path, radius, scallop);
  path.pieces.erase(path.pieces.begin() + 2);
  const ScallopMap fewer = measure_scallop(mesh, normals, path, radius, scallop);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) EXPECT_GE(fewer.worst_ratio[t], all.worst_ratio[t] - 1e-9);
  EXPECT_GT(fewer.statistics.max_ratio, 3.5);  // twice the interval: four times the height
}

// What is only bounded stays below the bound and above the truth; the rest is the same to the last bit.
TEST(ScallopMap, BoundedHeightsAreExactFromTheRatioOn) {
  const double radius = 2.0, scallop = 0.15, interval = path_interval_mm(radius, scallop, 0.0), from = 0.9;
  const TriangleMesh mesh = sheet(60, 6.0 * interval / 60.0, 0.3);
  const auto normals = geometry::vertex_normals(mesh);
  const CcPath path = passes(1.02 * interval, 6.0 * interval);
  const ScallopMap exact = measure_scallop(mesh, normals, path, radius, scallop, {.closer_from_ratio = 0.92});
  const ScallopMap bounded =
      measure_scallop(mesh, normals, path, radius, scallop, {.exact_from_ratio = from, .closer_from_ratio = 0.92});
  int only_bounded = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (exact.worst_ratio[t] >= from) {
      EXPECT_EQ(bounded.worst_ratio[t], exact.worst_ratio[t]);
    } else {
      EXPECT_GE(bounded.worst_ratio[t], exact.worst_ratio[t]);
      EXPECT_LT(bounded.worst_ratio[t], from);
      only_bounded += bounded.worst_ratio[t] > exact.worst_ratio[t] ? 1 : 0;
    }
  }
  EXPECT_GT(only_bounded, 100);
  EXPECT_EQ(bounded.statistics.max_ratio, exact.statistics.max_ratio);
  EXPECT_EQ(bounded.statistics.area_above_percent, exact.statistics.area_above_percent);
}

}  // namespace
}  // namespace volute::planner
