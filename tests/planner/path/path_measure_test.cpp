#include "planner/path/path_measure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sample_surfaces.hpp"

namespace volute::planner {
namespace {

CcPiece polyline(const std::vector<Vec3>& corners, double step_mm) {
  CcPiece piece;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const int parts = static_cast<int>(std::ceil((corners[i + 1] - corners[i]).norm() / step_mm));
    for (int k = 0; k < parts; ++k)
      piece.points.push_back(
          {corners[i] + (corners[i + 1] - corners[i]) * (static_cast<double>(k) / parts), Vec3::UnitZ(), 0.0, false});
  }
  piece.points.push_back({corners.back(), Vec3::UnitZ(), 0.0, false});
  return piece;
}

std::vector<Vec3> square_spiral() {
  std::vector<Vec3> corners;
  for (int i = 0; i < 12; ++i) {
    const double half = 20.0 - 1.5 * (i / 4);
    corners.emplace_back((i % 4 == 0 || i % 4 == 3) ? -half : half, i % 4 < 2 ? -half : half, 0.0);
  }
  return corners;
}

TEST(PathMeasure, EveryCornerOfASquareSpiralCountsOnce) {
  const auto points = even_points(polyline(square_spiral(), 0.7), 0.1);
  const auto corners = corner_angles_rad(points, 0.1, 0.8, 0.6);
  ASSERT_EQ(corners.size(), 10U) << "12 corners with both ends";
  for (double angle : corners) EXPECT_NEAR(angle, std::numbers::pi / 2, 0.12);
}

TEST(PathMeasure, ACircleHasNoCornerUntilItIsTight) {
  std::vector<Vec3> circle;
  for (int i = 0; i <= 200; ++i) circle.emplace_back(std::cos(0.0314159 * i), std::sin(0.0314159 * i), 0.0);
  const auto points = even_points(polyline(circle, 1.0), 0.01);
  EXPECT_TRUE(corner_angles_rad(points, 0.01, 0.5, 0.6).empty()) << "chords of 0.5 mm on a 1 mm circle turn by 0.5";
  EXPECT_EQ(corner_angles_rad(points, 0.01, 0.8, 0.6).size(), 1U) << "one place without end";
}

TEST(PathMeasure, EvenPointsLieOnThePathAndKeepItsEnds) {
  const CcPiece piece = polyline({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}, 10.0);
  const auto points = even_points(piece, 0.7);
  ASSERT_EQ(points.size(), 11U);
  EXPECT_EQ(points.back(), Vec3(3, 4, 0));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double s = 0.7 * static_cast<double>(i);
    EXPECT_LT((points[i] - (s <= 3.0 ? Vec3(s, 0, 0) : Vec3(3, s - 3.0, 0))).norm(), 1e-12);
  }
}

TEST(PathMeasure, ParallelTurnsHaveTheIntervalTheyAreApart) {
  // Circles of a flat ring 1 mm apart, joined by links: the interval ratio is 1 mm over the allowed one.
  const TriangleMesh ring = samples::ring(4.0, 12.0, 120, 16);
  const IntervalField intervals(ring, interval_rule(kinematics::Cutter{}, 0.2, OrientationOptions{}));
  CcPath path;
  path.pieces.emplace_back();
  for (int i = 0; i <= 8 * 240; ++i) {
    const double turn = i / 240.0, radius = 12.0 - turn, angle = 2.0 * std::numbers::pi * turn;
    path.pieces[0].points.push_back(
        {{radius * std::cos(angle), radius * std::sin(angle), 0.0}, Vec3::UnitZ(), turn, false});
  }
  PathReport report;
  measure_path({ring, intervals, {}, true, true}, path, report);
  const double allowed = path_interval_mm(3.0, 0.2, 0.0);
  EXPECT_NEAR(report.interval_ratio_max.value(), 1.0 / allowed, 0.01);
  EXPECT_NEAR(report.length_mm, std::numbers::pi * 8.0 * (12.0 + 4.0), 1.5);
  EXPECT_NEAR(report.lower_bound_mm, std::numbers::pi * (144.0 - 16.0) / allowed, 1.0);
  EXPECT_LT(report.scallop_ratio_p9999.value(), 1.0);
  EXPECT_EQ(report.sharp_corners, 0);
  EXPECT_EQ(report.pieces, 1);
}

}  // namespace
}  // namespace volute::planner
