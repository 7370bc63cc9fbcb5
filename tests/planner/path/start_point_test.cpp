#include "planner/path/start_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sample_surfaces.hpp"

namespace volute::planner {
namespace {

using geometry::MeshTopology;

/// Half a turn on the outer circle from angle 0 on, then straight in, then once around the inner circle.
CcPiece inward_piece(Sense sense) {
  const double sign = sense == Sense::counter_clockwise ? 1.0 : -1.0;
  CcPiece piece;
  const auto add = [&](double radius, double angle, double turn) {
    piece.points.push_back(
        {{radius * std::cos(angle), sign * radius * std::sin(angle), 0.0}, Vec3::UnitZ(), turn, false});
  };
  for (int i = 0; i <= 60; ++i) add(20.0, std::numbers::pi * i / 60.0, 0.0);
  for (int i = 1; i < 10; ++i) add(20.0 - 1.5 * i, std::numbers::pi, 0.1 * i);
  for (int i = 0; i <= 120; ++i) add(5.0, std::numbers::pi * (1.0 + i / 60.0), 1.0);
  piece.points.back() = piece.points[piece.points.size() - 121];
  return piece;
}

TEST(StartPoint, LeadsAlongTheOuterBoundaryTheWayThePathRuns) {
  const TriangleMesh ring = samples::ring(5.0, 20.0, 120, 20);
  const auto topology = MeshTopology::build(ring).value();
  for (Sense sense : {Sense::counter_clockwise, Sense::clockwise}) {
    const CcPiece before = inward_piece(sense);
    CcPiece piece = before;
    const Vec3 start(0.0, 25.0, 3.0);  // a quarter turn ahead, or three quarters behind
    const double added = begin_at(piece, ring, topology, start, Direction::inward, sense);
    EXPECT_NEAR((piece.points.front().point_P_mm - Vec3(0.0, 20.0, 0.0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(added, (sense == Sense::counter_clockwise ? 0.75 : 0.25) * 2.0 * std::numbers::pi * 20.0, 0.05);
    const std::size_t more = piece.points.size() - before.points.size();
    for (std::size_t i = 0; i < before.points.size(); ++i)
      ASSERT_EQ(piece.points[more + i].point_P_mm, before.points[i].point_P_mm);
    for (std::size_t i = 1; i <= more; ++i)
      EXPECT_LT((piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm).norm(), 1.1) << "one edge at a time";
  }
}

TEST(StartPoint, GoesAroundTheClosingLoopAgainForAnOutwardPath) {
  const TriangleMesh ring = samples::ring(5.0, 20.0, 120, 20);
  const auto topology = MeshTopology::build(ring).value();
  const CcPiece before = inward_piece(Sense::counter_clockwise);
  CcPiece piece = before;
  const double added = begin_at(piece, ring, topology, {9.0, 0.0, 0.0}, Direction::outward, Sense::counter_clockwise);
  EXPECT_NEAR((piece.points.back().point_P_mm - Vec3(5.0, 0.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(added, std::numbers::pi * 5.0, 0.01) << "from the far side half way round";
  for (std::size_t i = 0; i < before.points.size(); ++i)
    ASSERT_EQ(piece.points[i].point_P_mm, before.points[i].point_P_mm);
}

TEST(StartPoint, AddsNothingWhereThePathBeginsThereAlready) {
  const TriangleMesh ring = samples::ring(5.0, 20.0, 120, 20);
  const auto topology = MeshTopology::build(ring).value();
  for (Direction direction : {Direction::inward, Direction::outward}) {
    CcPiece piece = inward_piece(Sense::counter_clockwise);
    const Vec3 at = direction == Direction::inward ? piece.points.front().point_P_mm : piece.points.back().point_P_mm;
    const std::size_t count = piece.points.size();
    EXPECT_EQ(begin_at(piece, ring, topology, at, direction, Sense::counter_clockwise), 0.0);
    EXPECT_EQ(piece.points.size(), count);
  }
}

TEST(StartPoint, TheEvenSpiralBeginsWhereItIsAskedToAndSaysWhatItCosts) {
  const TriangleMesh ring = samples::ring(6.0, 20.0, 90, 14);
  PathOptions options;
  options.scallop_mm = 0.3;
  const auto plain = plan_cc_path(ring, {}, options, {});
  ASSERT_TRUE(plain) << plain.error().message;
  options.start_P_mm = Vec3(-3.0, -30.0, 1.0);
  const auto asked = plan_cc_path(ring, {}, options, {});
  ASSERT_TRUE(asked) << asked.error().message;
  const double angle = std::atan2(-30.0, -3.0);
  EXPECT_LT(
      (asked->path.pieces[0].points.front().point_P_mm - 20.0 * Vec3(std::cos(angle), std::sin(angle), 0.0)).norm(),
      1.5);
  const double more_mm = asked->report.length_mm - plain->report.length_mm;
  EXPECT_GT(more_mm, 0.0);
  EXPECT_LT(more_mm, 2.0 * std::numbers::pi * 20.0);
  ASSERT_FALSE(asked->report.notes.empty());
  EXPECT_NE(asked->report.notes.front().find("path.start_mm"), std::string::npos);
}

}  // namespace
}  // namespace volute::planner
