#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "geometry/mesh_measure.hpp"
#include "planner/path/scallop_climb.hpp"
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

/// Passes along x on the sheet, each with a wave of its own, and normals of the sheet.
CcPath wavy_passes(const TriangleMesh& mesh, int cells, int every, std::mt19937& random) {
  const auto normals = geometry::vertex_normals(mesh);
  std::uniform_real_distribution<double> off(-0.3, 0.3);
  CcPath path;
  for (int row = 0; row <= cells; row += every) {
    CcPiece piece;
    const double wave = off(random);
    for (int i = 0; i <= cells; ++i) {
      const auto v = static_cast<std::size_t>(row * (cells + 1) + i);
      const Vec3 aside(0.0, wave * std::sin(0.4 * i), 0.0);
      piece.points.push_back({mesh.vertices_mm[v] + aside, normals[v], 1.0, false});
    }
    path.pieces.push_back(piece);
  }
  return path;
}

// Independent computation: the same heights at 1600 places of every triangle, no climbing needed.
TEST(ScallopMap, ClimbingReachesWhatDenseSamplesSee) {
  const double radius = 2.0, scallop = 0.15;
  const TriangleMesh mesh = sheet(12, 0.7, 0.6);
  const auto normals = geometry::vertex_normals(mesh);
  std::mt19937 random(3);
  const CcPath path = wavy_passes(mesh, 12, 2, random);
  const ScallopMap climbed = measure_scallop(mesh, normals, path, radius, scallop, {.closer_from_ratio = 0.6});
  const ScallopMap dense = measure_scallop(mesh, normals, path, radius, scallop, {.per_edge = 40});
  double sum = 0.0, worst = 0.0;
  int looked_at = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (dense.worst_ratio[t] < 1.0) continue;
    const double missed = dense.worst_ratio[t] - climbed.worst_ratio[t];
    worst = std::max(worst, missed);
    sum += std::max(missed, 0.0);
    ++looked_at;
  }
  ASSERT_GT(looked_at, 50);
  EXPECT_LT(worst, 0.06);
  EXPECT_LT(sum / looked_at, 0.005);
}

// A triangle holds several crests: the climb from its highest sample alone may end on the lower one.
TEST(ScallopMap, AThoroughLookMissesLess) {
  const double radius = 2.0, scallop = 0.15, from = 0.9;
  const TriangleMesh mesh = sheet(12, 0.7, 0.6);
  const auto normals = geometry::vertex_normals(mesh);
  double missed = 0.0, missed_thoroughly = 0.0;  // summed
  int looked_at = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const CcPath path = wavy_passes(mesh, 12, 2, random);
    const ScallopMap climbed = measure_scallop(mesh, normals, path, radius, scallop, {.closer_from_ratio = 0.6});
    const ScallopMap thorough =
        measure_scallop(mesh, normals, path, radius, scallop, {.closer_from_ratio = 0.6, .thorough_from_ratio = from});
    const ScallopMap dense = measure_scallop(mesh, normals, path, radius, scallop, {.per_edge = 40});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      EXPECT_GE(thorough.worst_ratio[t], climbed.worst_ratio[t]);
      if (climbed.worst_ratio[t] <= from) continue;
      missed += std::max(0.0, dense.worst_ratio[t] - climbed.worst_ratio[t]);
      missed_thoroughly += std::max(0.0, dense.worst_ratio[t] - thorough.worst_ratio[t]);
      ++looked_at;
    }
    EXPECT_EQ(thorough.statistics.p9999_ratio, climbed.statistics.p9999_ratio);
  }
  ASSERT_GT(looked_at, 200);
  EXPECT_LT(missed_thoroughly / looked_at, 0.003);
  EXPECT_GT(missed, 2.0 * missed_thoroughly);
}

// A meter that has seen other paths before answers as one that has not, to the last bit, with less work.
TEST(ScallopMeter, EqualsAFreshMeasureAfterEveryChange) {
  const double radius = 2.0, scallop = 0.15;
  const int cells = 64;
  const TriangleMesh mesh = sheet(cells, 0.35, 0.6);
  const auto normals = geometry::vertex_normals(mesh);
  for (const double exact_from : {0.0, 0.8}) {
    const unsigned seed = 11;
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", exact from " << exact_from);
    std::mt19937 random(seed);
    const ScallopSampling sampling{.exact_from_ratio = exact_from};
    CcPath path = wavy_passes(mesh, cells, 4, random);
    ScallopMeter meter(mesh, normals, radius, scallop, sampling);
    meter.measure(path);
    EXPECT_EQ(meter.measured(), mesh.triangles.size());
    std::uniform_int_distribution<std::size_t> piece(0, path.pieces.size() - 1), point(0, cells);
    std::uniform_real_distribution<double> shift(-0.2, 0.2);
    for (int change = 0; change < 12; ++change) {
      auto& points = path.pieces[piece(random)].points;
      const std::size_t i = point(random) % points.size();
      points[i].point_P_mm += Vec3(shift(random), shift(random), 0.2 * shift(random));
      points[i].normal_P = (points[i].normal_P + Vec3(0.1 * shift(random), 0.0, 0.0)).normalized();
      if (change % 3 == 1) points.insert(points.begin() + static_cast<std::ptrdiff_t>(i), points[i / 2 + i % 2]);
      if (change % 3 == 2) points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      const ScallopMap& after = meter.measure(path);
      const ScallopMap fresh = measure_scallop(mesh, normals, path, radius, scallop, sampling);
      EXPECT_EQ(after.worst_ratio, fresh.worst_ratio);
      EXPECT_EQ(after.worst_place_P_mm, fresh.worst_place_P_mm);
      EXPECT_EQ(after.statistics.max_ratio, fresh.statistics.max_ratio);
      EXPECT_EQ(after.statistics.p9999_ratio, fresh.statistics.p9999_ratio);
      EXPECT_EQ(after.statistics.area_above_percent, fresh.statistics.area_above_percent);
      EXPECT_GT(meter.measured(), 0U);
      if (change % 3 == 0) {
        EXPECT_LT(meter.measured(), mesh.triangles.size() / 3);
      }
    }
    meter.measure(path);
    EXPECT_EQ(meter.measured(), 0U);
  }
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
      // Below 0 a ball gouges: how deep the deepest one goes only the balls near by tell.
      if (exact.worst_ratio[t] >= 0.0) {
        EXPECT_GE(bounded.worst_ratio[t], exact.worst_ratio[t]);
      }
      EXPECT_LT(bounded.worst_ratio[t], from);
      only_bounded += bounded.worst_ratio[t] > exact.worst_ratio[t] ? 1 : 0;
    }
  }
  EXPECT_GT(only_bounded, 100);
  EXPECT_EQ(bounded.statistics.max_ratio, exact.statistics.max_ratio);
  EXPECT_EQ(bounded.statistics.area_above_percent, exact.statistics.area_above_percent);
}

// Two balls, 1 mm apart. A height that a guess settled belongs to the farther ball; the crest between the two then
// reckons to 1 mm beyond the place, off the triangle, where no ball is met and all would stand uncut.
TEST(ScallopClimb, ACrestLiesBetweenTheTwoPlacesWhateverBallSettledAHeight) {
  constexpr double radius_mm = 3.0;
  CcPath path;
  CcPiece piece;
  for (const double x : {0.0, 1.0}) piece.points.push_back({Vec3(x, 0.0, 0.0), Vec3::UnitZ(), 0.0, false});
  path.pieces.push_back(piece);
  const ScallopBalls balls(path, radius_mm, 20.0);
  const auto seen = [&](double x_mm, Index ball) {
    ScallopEntry entry{Vec3(x_mm, 0.0, 0.0), Vec3::UnitZ(), 0.0, ball};
    entry.height_mm = balls.height_mm(ball, entry);
    return entry;
  };
  EXPECT_NEAR(crest_share(balls, seen(0.3, 0), seen(0.7, 1)), 0.5, 1e-9);
  EXPECT_EQ(crest_share(balls, seen(0.3, 0), seen(0.4, 1)), 1.0);
}

}  // namespace
}  // namespace volute::planner
