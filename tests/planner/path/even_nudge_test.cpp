// Passes moved towards single places that they leave too high.
#include <algorithm>
#include <cmath>

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

}  // namespace
}  // namespace volute::planner
