// Passes moved together until no place between them is too high; judged by a dense measure of its own.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/mesh_measure.hpp"
#include "planner/path/even_mend.hpp"
#include "planner/path/even_verdict.hpp"
#include "tests/planner/path/dense_scallop.hpp"

namespace volute::planner {
namespace {

constexpr double radius_mm = 3.0, scallop_mm = 0.2;
const double interval_mm = path_interval_mm(radius_mm, scallop_mm, 0.0);

/// Passes along x, to and fro, at the given distances (intervals) from one another; turn 1, 2, ...
CcPiece passes_apart(const std::vector<double>& gaps) {
  CcPiece piece;
  double y = 0.0;
  for (std::size_t pass = 0; pass <= gaps.size(); ++pass) {
    for (int i = 0; i <= 40; ++i) {
      const double x = pass % 2 == 0 ? i : 40 - i;
      piece.points.push_back({Vec3(x, y, 0.0), Vec3::UnitZ(), 1.0 + static_cast<double>(pass), false});
    }
    if (pass < gaps.size()) y += gaps[pass] * interval_mm;
  }
  return piece;
}

/// A plane below the passes, from the first to the last, clear of their ends.
TriangleMesh plane_below(const CcPiece& piece, double edge_mm) {
  const double first = 8.0, last = 32.0, width = piece.points.back().point_P_mm.y();
  const int columns = static_cast<int>(std::ceil((last - first) / edge_mm)),
            rows = static_cast<int>(std::ceil(width / edge_mm));
  TriangleMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      mesh.vertices_mm.emplace_back(first + (last - first) * i / columns, width * j / rows, 0.0);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + columns + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

double dense_ratio(const TriangleMesh& mesh, const CcPiece& piece) {
  return samples::greatest_scallop_ratio(mesh, {{piece}}, radius_mm, scallop_mm, 8000, 5);
}

double length_mm(const CcPiece& piece) {
  double sum = 0.0;
  for (std::size_t i = 1; i < piece.points.size(); ++i)
    sum += (piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm).norm();
  return sum;
}

// Closed form: passes L apart leave h = r - sqrt(r^2 - L^2 / 4), so dh = L / (4 sqrt(r^2 - L^2 / 4)) dL, whichever of
// the two moves.
TEST(EvenMend, ACrestFallsWithEitherPassAsTheClosedFormSays) {
  const CcPiece piece = passes_apart({1.1});
  const TriangleMesh mesh = plane_below(piece, 0.5);
  const std::vector<Vec3> normals(mesh.vertices_mm.size(), Vec3::UnitZ());
  const auto operators = triangle_operators(mesh);
  const BallSteps steps = ball_steps(piece, radius_mm, interval_mm / 20.0);
  const MendSurface on{mesh, normals, operators};
  const Crests crests(steps, on, radius_mm, scallop_mm);
  const double apart = 1.1 * interval_mm;
  const CrestRow row = crests.row(0, Vec3(20.0, 0.5 * apart, 0.0), 1.2);
  ASSERT_EQ(row.by_shift.size(), 2U);
  const double slope = apart / 4.0 / std::sqrt(radius_mm * radius_mm - apart * apart / 4.0) * interval_mm / scallop_mm;
  EXPECT_NEAR(row.by_shift[0].second.y(), -slope, 0.01 * slope);  // forward is towards the crest
  EXPECT_NEAR(row.by_shift[1].second.y(), slope, 0.01 * slope);
  EXPECT_NEAR(row.by_shift[0].first, 20.0, 0.1);
  EXPECT_NEAR(row.by_shift[1].first, 40.0 + apart + 20.0, 0.1);
}

// One gap 1.07 intervals wide, 1.145 times the height, between gaps that have next to nothing to give (0.99): what is
// too much has to be shared by several.
TEST(EvenMend, AWideGapIsSharedByThePassesAround) {
  CcPiece piece = passes_apart({0.99, 0.99, 0.99, 1.07, 0.99, 0.99, 0.99});
  const TriangleMesh mesh = plane_below(piece, 0.8);
  const auto normals = geometry::vertex_normals(mesh);
  const auto operators = triangle_operators(mesh);
  ScallopMeter meter(mesh, normals, radius_mm, scallop_mm, {.thorough_from_ratio = 0.9});
  const double before_mm = length_mm(piece);
  EXPECT_NEAR(dense_ratio(mesh, piece), 1.07 * 1.07, 0.01);
  for (int round = 0; round < 4; ++round) {
    const ScallopMap map = meter.measure({{piece}});
    ASSERT_TRUE(mend_finished(piece, map, {mesh, normals, operators}, radius_mm, scallop_mm).has_value());
  }
  EXPECT_LE(dense_ratio(mesh, piece), 1.04);
  EXPECT_LE(meter.measure({{piece}}).statistics.max_ratio, 1.04);
  EXPECT_LE(length_mm(piece), 1.002 * before_mm);
}

TEST(EvenMend, WhatIsLowEnoughStaysBitByBit) {
  CcPiece piece = passes_apart({0.99, 0.99});
  const CcPiece before = piece;
  const TriangleMesh mesh = plane_below(piece, 0.8);
  const auto normals = geometry::vertex_normals(mesh);
  const auto operators = triangle_operators(mesh);
  const ScallopMap map = measure_scallop(mesh, normals, {{piece}}, radius_mm, scallop_mm);
  ASSERT_TRUE(mend_finished(piece, map, {mesh, normals, operators}, radius_mm, scallop_mm).has_value());
  ASSERT_EQ(piece.points.size(), before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i)
    EXPECT_EQ(piece.points[i].point_P_mm, before.points[i].point_P_mm);
}

// The first pass is the run along the boundary: it stays, and so do the ends and all that is far from the wide gap.
TEST(EvenMend, EndsTheBoundaryRunAndWhatIsFarStayBitByBit) {
  CcPiece piece = passes_apart({1.05, 0.95, 0.95, 0.95, 0.95, 0.95});
  for (CcPoint& p : piece.points) p.turn -= 1.0;
  const CcPiece before = piece;
  const TriangleMesh mesh = plane_below(piece, 0.8);
  const auto normals = geometry::vertex_normals(mesh);
  const auto operators = triangle_operators(mesh);
  const ScallopMap map = measure_scallop(mesh, normals, {{piece}}, radius_mm, scallop_mm);
  ASSERT_TRUE(mend_finished(piece, map, {mesh, normals, operators}, radius_mm, scallop_mm).has_value());
  const auto kept = [&](const CcPoint& q) {
    return std::any_of(piece.points.begin(), piece.points.end(),
                       [&](const CcPoint& p) { return p.point_P_mm == q.point_P_mm && p.normal_P == q.normal_P; });
  };
  int moved = 0;
  for (const CcPoint& q : before.points) {
    const bool far = q.point_P_mm.y() > (1.05 + 2.5 + 1.0) * interval_mm;
    if (q.turn <= 0.0 || far) {
      EXPECT_TRUE(kept(q)) << q.point_P_mm.transpose();
    } else {
      moved += kept(q) ? 0 : 1;
    }
  }
  EXPECT_GT(moved, 20);
  EXPECT_EQ(piece.points.front().point_P_mm, before.points.front().point_P_mm);
  EXPECT_EQ(piece.points.back().point_P_mm, before.points.back().point_P_mm);
}

// Triangles three intervals long: their nine samples say little of the crests between, the verdict looks at all.
TEST(EvenMend, TheVerdictSeesAndMendsWhatACoarseMeshHides) {
  const CcPiece piece = passes_apart({0.98, 0.98, 0.98, 1.08, 0.98, 0.98, 0.98});
  const TriangleMesh mesh = plane_below(piece, 3.0 * interval_mm);
  const auto normals = geometry::vertex_normals(mesh);
  const IntervalRule rule{.radius_mm = radius_mm, .scallop_mm = scallop_mm};
  const ScallopMap map = measure_scallop(mesh, normals, {{piece}}, radius_mm, scallop_mm);
  const auto mended = mended_closely(mesh, normals, {{piece}}, map, rule);
  ASSERT_TRUE(mended.has_value());
  EXPECT_TRUE(mended->moved);
  EXPECT_LE(mended->scallop.max_ratio, 1.05);
  EXPECT_NEAR(dense_ratio(mesh, mended->path.pieces.front()), mended->scallop.max_ratio, 0.02);
}

TEST(EvenMend, ThePathThatHoldsLeavesTheVerdictAsItIs) {
  const CcPiece piece = passes_apart({1.0, 1.04, 1.0});
  const TriangleMesh mesh = plane_below(piece, 3.0 * interval_mm);
  const auto normals = geometry::vertex_normals(mesh);
  const IntervalRule rule{.radius_mm = radius_mm, .scallop_mm = scallop_mm};
  const ScallopMap map = measure_scallop(mesh, normals, {{piece}}, radius_mm, scallop_mm);
  const auto seen = mended_closely(mesh, normals, {{piece}}, map, rule);
  ASSERT_TRUE(seen.has_value());
  EXPECT_NEAR(seen->scallop.max_ratio, 1.04 * 1.04, 0.01);
  ASSERT_FALSE(seen->moved);
  ASSERT_EQ(seen->path.pieces.front().points.size(), piece.points.size());
  for (std::size_t i = 0; i < piece.points.size(); ++i)
    EXPECT_EQ(seen->path.pieces.front().points[i].point_P_mm, piece.points[i].point_P_mm);
}

/// A roof along the passes, its ridge over the middle of a gap: triangles meet there at an angle of 2 `slope`.
TriangleMesh roof_below(const CcPiece& piece, double ridge_mm, double slope) {
  TriangleMesh mesh = plane_below(piece, 0.5);
  for (Vec3& v : mesh.vertices_mm) v.z() = -slope * std::abs(v.y() - ridge_mm);
  return mesh;
}

/// Each triangle with corners of its own: vertex normals are then those of the triangles.
TriangleMesh taken_apart(const TriangleMesh& mesh) {
  TriangleMesh out;
  for (const auto& t : mesh.triangles) {
    const auto first = static_cast<geometry::Index>(out.vertices_mm.size());
    for (geometry::Index v : t) out.vertices_mm.push_back(mesh.vertices_mm[static_cast<std::size_t>(v)]);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

// Beside a ridge the vertices' normals lean over and those of the triangles, along which a program is judged, do not:
// both hold.
TEST(EvenMend, BesideARidgeBothNormalsHold) {
  std::vector<double> gaps{0.96, 0.96, 0.96, 0.99, 0.96, 0.96, 0.96};
  CcPiece piece = passes_apart(gaps);
  const double ridge_mm = (3 * 0.96 + 0.5 * 0.99) * interval_mm, slope = 0.3;
  const TriangleMesh mesh = roof_below(piece, ridge_mm, slope);
  const auto normals = geometry::vertex_normals(mesh);
  const auto operators = triangle_operators(mesh);
  for (CcPoint& p : piece.points) {
    const double side = p.point_P_mm.y() - ridge_mm;
    p.point_P_mm.z() = -slope * std::abs(side);
    p.normal_P = Vec3(0.0, side > 0.0 ? slope : -slope, 1.0).normalized();
  }
  const IntervalRule rule{.radius_mm = radius_mm, .scallop_mm = scallop_mm};
  const ScallopMap map = measure_scallop(mesh, normals, {{piece}}, radius_mm, scallop_mm);
  const TriangleMesh apart = taken_apart(mesh);
  EXPECT_GT(dense_ratio(mesh, piece), 1.2);
  const auto mended = mended_closely(mesh, normals, {{piece}}, map, rule);
  ASSERT_TRUE(mended.has_value());
  EXPECT_LE(dense_ratio(mesh, mended->path.pieces.front()), 1.10);
  EXPECT_LE(dense_ratio(apart, mended->path.pieces.front()), 1.10);
}

}  // namespace
}  // namespace volute::planner
