// Passes moved towards single places that they leave too high.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "planner/path/even_nudge.hpp"
#include "planner/path/path_interval.hpp"

namespace volute::planner {
namespace {

constexpr double apart_mm = 2.0;

/// Straight passes along x at y = 0, 2, 4, joined at their ends; turn 1 to 3.
CcPiece three_passes() {
  CcPiece piece;
  for (int pass = 0; pass < 3; ++pass) {
    for (int i = 0; i <= 40; ++i) {
      const double x = pass % 2 == 0 ? i : 40 - i;
      piece.points.push_back({Vec3(x, apart_mm * pass, 0.0), Vec3::UnitZ(), 1.0 + pass, false});
    }
  }
  return piece;
}

double nearest_mm(const CcPiece& piece, const Vec3& place) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
    const Vec3 a = piece.points[i].point_P_mm, along = piece.points[i + 1].point_P_mm - a;
    const double share = std::clamp((place - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
    least = std::min(least, (a + share * along - place).norm());
  }
  return least;
}

TEST(EvenNudge, WithoutPlacesNothingChanges) {
  CcPiece piece = three_passes();
  const CcPiece before = piece;
  for (char moved : nudge(piece, {}, apart_mm)) EXPECT_EQ(moved, 0);
  ASSERT_EQ(piece.points.size(), before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i)
    EXPECT_EQ((piece.points[i].point_P_mm - before.points[i].point_P_mm).norm(), 0.0);
}

// Closed form: heights grow with the square of the distance, so 1.44 times the height needs 1 / 1.2 of the distance.
TEST(EvenNudge, ThePassBesideABoundaryPlaceComesNearEnough) {
  CcPiece piece = three_passes();
  const Vec3 place(20.0, -1.2, 0.0);
  const std::vector<HighPlace> places{{place, 1.44}};
  nudge(piece, places, apart_mm);
  EXPECT_NEAR(nearest_mm(piece, place), 1.0, 2e-3);
  EXPECT_NEAR(nearest_mm(piece, Vec3(14.0, 0.0, 0.0)), 0.0, 1e-12);  // beyond the window: where it was
  EXPECT_NEAR(nearest_mm(piece, Vec3(20.0, 2.0, 0.0)), 0.0, 1e-12);  // the pass behind stays
}

// A place midway between two passes moves both, each by the whole share.
TEST(EvenNudge, BothPassesBesideACrestMove) {
  CcPiece piece = three_passes();
  const Vec3 place(20.0, 1.0, 0.0);
  const std::vector<HighPlace> places{{place, 1.21}};
  const CcPiece before = piece;
  const auto moved = nudge(piece, places, apart_mm);
  ASSERT_EQ(moved.size(), piece.points.size());
  const double share = 1.0 - 1.0 / 1.1;
  EXPECT_NEAR(nearest_mm(piece, Vec3(20.0, share, 0.0)), 0.0, 2e-3);
  EXPECT_NEAR(nearest_mm(piece, Vec3(20.0, 2.0 - share, 0.0)), 0.0, 2e-3);
  EXPECT_EQ((piece.points.front().point_P_mm - before.points.front().point_P_mm).norm(), 0.0);
  EXPECT_EQ((piece.points.back().point_P_mm - before.points.back().point_P_mm).norm(), 0.0);
  for (const CcPoint& p : piece.points) {
    const double pass = std::round(p.point_P_mm.y() / apart_mm) * apart_mm;
    EXPECT_LE(std::abs(p.point_P_mm.y() - pass), share + 1e-12);
  }
}

TEST(EvenNudge, TheRunAlongTheOuterBoundaryStays) {
  CcPiece piece = three_passes();
  for (CcPoint& p : piece.points) p.turn -= 1.0;  // the first pass is turn 0
  const std::vector<HighPlace> places{{Vec3(20.0, 1.0, 0.0), 1.21}};
  nudge(piece, places, apart_mm);
  for (const CcPoint& p : piece.points) {
    if (p.turn <= 0.0) {
      EXPECT_EQ(p.point_P_mm.y(), 0.0);
    }
  }
  EXPECT_LT(nearest_mm(piece, Vec3(20.0, 1.0, 0.0)), 1.0 - 0.05);
}

/// A plane of two triangles under the three passes.
TriangleMesh plane_below() {
  TriangleMesh mesh;
  mesh.vertices_mm = {{-10, -10, 0}, {50, -10, 0}, {50, 20, 0}, {-10, 20, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// A finished path stands beside the mesh (here 0.03 mm above it, normals a little off): what moves keeps that, what
// does not move stays bit by bit, and so does the run along the boundary, whose turns the spline leaves near 0.
TEST(EvenNudge, AFinishedPieceKeepsItsDistanceFromTheMesh) {
  const TriangleMesh mesh = plane_below();
  const std::vector<Vec3> normals(4, Vec3::UnitZ());
  const auto operators = triangle_operators(mesh);
  CcPiece piece = three_passes();
  const Vec3 normal = Vec3(0.01, 0.0, 1.0).normalized();
  for (CcPoint& p : piece.points) {
    p.point_P_mm.z() = 0.03;
    p.normal_P = normal;
    p.turn = p.turn <= 1.0 ? 0.01 : p.turn;
  }
  const CcPiece before = piece;
  const std::vector<HighPlace> places{{Vec3(20.0, 1.0, 0.0), 1.21}};
  nudge_finished(piece, places, apart_mm, mesh, normals, operators);
  std::size_t same = 0, moved = 0;
  for (const CcPoint& p : piece.points) {
    EXPECT_NEAR(p.point_P_mm.z(), 0.03, 1e-12);
    EXPECT_NEAR((p.normal_P - normal).norm(), 0.0, 1e-12);
    if (p.turn == 0.01) {
      EXPECT_EQ(p.point_P_mm.y(), 0.0);
    }
    moved += std::abs(std::remainder(p.point_P_mm.y(), apart_mm)) > 1e-9 ? 1 : 0;
    same += std::any_of(before.points.begin(), before.points.end(),
                        [&](const CcPoint& q) { return q.point_P_mm == p.point_P_mm; })
                ? 1
                : 0;
  }
  EXPECT_GT(moved, 5U);
  EXPECT_GT(same, before.points.size() - 12);
  // Taken down to 1.03: the share of its distance (1 mm) that the height, growing with its square, asks for.
  const double share = 1.0 - std::sqrt(1.03 / 1.21);
  EXPECT_NEAR(nearest_mm(piece, Vec3(20.0, 2.0 - share, 0.03)), 0.0, 2e-3);
}

}  // namespace
}  // namespace volute::planner
