// Slits that branch and grow out of holes, the collar around them, the way into them, and the rounding of corners.
#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/mesh_measure.hpp"
#include "planner/path/even_collar.hpp"
#include "planner/path/even_domain.hpp"
#include "planner/path/even_ending.hpp"
#include "planner/path/even_ridge.hpp"
#include "planner/path/even_rounding.hpp"
#include "tests/planner/path/sample_surfaces.hpp"

namespace volute::planner {
namespace {

Index vertex_at(const EvenSurface& surface, double x_mm, double y_mm) {
  Index best = 0;
  for (Index v = 0; v < static_cast<Index>(surface.mesh.vertices_mm.size()); ++v) {
    const auto off = [&](Index i) {
      return (surface.mesh.vertices_mm[static_cast<std::size_t>(i)] - Vec3(x_mm, y_mm, 0.0)).norm();
    };
    if (off(v) < off(best)) best = v;
  }
  return best;
}

double loop_mm(const EvenDomain& domain) { return domain.centre.length_mm; }

EvenSurface flat_plate(std::vector<samples::Hole> holes) {
  samples::PlateOptions options;
  options.holes = std::move(holes);
  return *EvenSurface::build(samples::plate(options));
}

// Closed form: the loop around a tree of slits is twice its length, whatever its shape.
TEST(EvenCentre, ATreeOfThreeArmsIsOneLoopOfTwiceItsLength) {
  const EvenSurface surface = flat_plate({});
  const Index middle = vertex_at(surface, 0, 0);
  const Centre centre{
      geometry::no_index,
      {{middle, vertex_at(surface, 10, 0)}, {middle, vertex_at(surface, -6, 6)}, {middle, vertex_at(surface, -5, -9)}}};
  const auto domain = even_domain(surface, centre);
  ASSERT_TRUE(domain.has_value()) << domain.error().message;
  EXPECT_EQ(domain->topology.boundary_loops().size(), 2u);
  EXPECT_EQ(domain->slits.size(), 3u);
  EXPECT_NEAR(loop_mm(*domain), 2.0 * (10.0 + std::hypot(6.0, 6.0) + std::hypot(5.0, 9.0)), 0.2);
  EXPECT_TRUE(slit_line(*domain).empty());
}

TEST(EvenCentre, AnArmOutOfAHoleJoinsItsLoop) {
  const EvenSurface surface = flat_plate({{-5.0, 0.0, 5.0}});
  const auto& hole = surface.topology.boundary_loops()[1];
  Index from = hole.vertices.front();
  for (Index v : hole.vertices) {
    if (surface.mesh.vertices_mm[static_cast<std::size_t>(v)].x() >
        surface.mesh.vertices_mm[static_cast<std::size_t>(from)].x())
      from = v;
  }
  const double start_mm = surface.mesh.vertices_mm[static_cast<std::size_t>(from)].x();
  const auto domain = even_domain(surface, Centre{Index{1}, {{from, vertex_at(surface, 12, 0)}}});
  ASSERT_TRUE(domain.has_value()) << domain.error().message;
  EXPECT_EQ(domain->topology.boundary_loops().size(), 2u);
  EXPECT_NEAR(loop_mm(*domain), hole.length_mm + 2.0 * (12.0 - start_mm), 0.1);
  EXPECT_TRUE(slit_line(*domain).empty());
}

// Closed form: holes joined by a cut are one loop, as long as both and the cut's two sides. Neither floats any more.
TEST(EvenCentre, AnArmBetweenTwoHolesJoinsThem) {
  const EvenSurface surface = flat_plate({{-9.0, 0.0, 4.0}, {9.0, 0.0, 5.0}});
  const auto& loops = surface.topology.boundary_loops();
  ASSERT_EQ(loops.size(), 3u);
  const Index from = vertex_at(surface, 4.0, 0.0), to = vertex_at(surface, -5.0, 0.0);
  const double gap_mm = (surface.mesh.vertices_mm[static_cast<std::size_t>(from)] -
                         surface.mesh.vertices_mm[static_cast<std::size_t>(to)])
                            .norm();
  // The second arm to the same hole would close a ring around a part of the plate: it is left out.
  const Centre centre{Index{1}, {{from, to}, {from, vertex_at(surface, -9.0, 4.0)}}};
  const auto domain = even_domain(surface, centre);
  ASSERT_TRUE(domain.has_value()) << domain.error().message;
  EXPECT_EQ(domain->topology.boundary_loops().size(), 2u);
  EXPECT_EQ(domain->topology.components().size(), 1u);
  EXPECT_TRUE(domain->floating.empty());
  EXPECT_NEAR(loop_mm(*domain), loops[1].length_mm + loops[2].length_mm + 2.0 * gap_mm, 0.05);
  for (Index v : domain->centre.vertices) EXPECT_NEAR(domain->harmonic[static_cast<std::size_t>(v)], 1.0, 1e-12);
}

// Closed form: along the edges of a grid the way between two vertices of a row is its length.
TEST(EvenRidge, DistancesFollowTheEdges) {
  const EvenSurface surface = flat_plate({});
  const RidgeWays ways(surface.mesh);
  const Index from = vertex_at(surface, -10.0, 3.0);
  const auto distance = ways.distance_mm({from});
  EXPECT_EQ(distance[static_cast<std::size_t>(from)], 0.0);
  for (double x : {-9.0, 0.0, 7.0, 20.0})
    EXPECT_NEAR(distance[static_cast<std::size_t>(vertex_at(surface, x, 3.0))], x + 10.0, 1e-9);
}

// In a ring the ridge is the circle midway; the shortest way would hug the hole.
TEST(EvenRidge, AWayRoundARingKeepsToTheMiddle) {
  const auto ring = EvenSurface::build(samples::ring(10.0, 20.0, 120, 12));
  ASSERT_TRUE(ring.has_value());
  const RidgeWays ways(ring->mesh);
  std::vector<Index> boundary;
  for (const auto& loop : ring->topology.boundary_loops())
    boundary.insert(boundary.end(), loop.vertices.begin(), loop.vertices.end());
  const auto room = ways.distance_mm(boundary);
  const Index from = vertex_at(*ring, 15.0, 0.0), to = vertex_at(*ring, -15.0, 0.5);
  const auto way = ways.way({from}, to, room, 0.0);
  ASSERT_GT(way.size(), 20u);
  EXPECT_EQ(way.front(), from);
  EXPECT_EQ(way.back(), to);
  for (Index v : way) EXPECT_NEAR(ring->mesh.vertices_mm[static_cast<std::size_t>(v)].norm(), 15.0, 1.5);
  const auto straighter = ways.way({from}, to, room, 2.0);
  EXPECT_LT(straighter.size(), 8u);
  EXPECT_GE(straighter.size(), 3u);
  EXPECT_TRUE(ways.way({}, to, room, 0.0).empty());
}

// The second arm would cross the first one, and starts on it instead: still one loop, no ring, no loose triangle.
TEST(EvenCentre, AnArmThatCrossesAnotherStartsWhereItLeavesIt) {
  const EvenSurface surface = flat_plate({});
  const Index a = vertex_at(surface, -8, 0), b = vertex_at(surface, 8, 0.0), c = vertex_at(surface, 4, 9);
  const Centre centre{geometry::no_index, {{a, b}, {a, c}, {c, vertex_at(surface, 4, -9)}}};
  const auto domain = even_domain(surface, centre);
  ASSERT_TRUE(domain.has_value()) << domain.error().message;
  EXPECT_EQ(domain->topology.components().size(), 1u);
  EXPECT_EQ(domain->topology.boundary_loops().size(), 2u);
  // 16 along, the arm up to (4, 9), and only the part of the last arm below the first.
  EXPECT_NEAR(loop_mm(*domain), 2.0 * (16.0 + std::hypot(12.0, 9.0) + 9.0), 2.0);
}

TEST(EvenCentre, TheCollarFallsByOneTurnAnInterval) {
  const EvenSurface surface = flat_plate({});
  const auto domain =
      even_domain(surface, Centre{geometry::no_index, {{vertex_at(surface, -6, 0), vertex_at(surface, 6, 0)}}});
  ASSERT_TRUE(domain.has_value());
  const IntervalRule rule{3.0, 0.2, 5.0};
  const auto collar = slit_collar(*domain, rule);
  std::size_t within = 0;
  for (std::size_t v = 0; v < domain->mesh.vertices_mm.size(); ++v) {
    const Vec3& p = domain->mesh.vertices_mm[v];
    const double off_mm = std::hypot(std::max(0.0, std::abs(p.x()) - 6.0), p.y());
    if (off_mm > 1e-6 && off_mm <= 1.3 * rule.interval_mm(0.0)) ++within;
  }
  EXPECT_EQ(collar.size(), within);
  EXPECT_GT(collar.size(), 50u);
  for (const CollarVertex& c : collar) {
    const Vec3& p = domain->mesh.vertices_mm[static_cast<std::size_t>(c.vertex)];
    const double off_mm = std::hypot(std::max(0.0, std::abs(p.x()) - 6.0), p.y());
    EXPECT_NEAR(c.turns_before, off_mm / rule.interval_mm(0.0), 1e-9);
  }
}

/// A stadium around the x axis from -5 to 5, counter-clockwise, so that the slit lies on the left.
LastTurn stadium(double radius_mm) {
  LastTurn turn;
  for (int i = 0; i < 40; ++i) turn.points_mm.emplace_back(-5.0 + 0.25 * i, -radius_mm, 0.0);
  for (int i = 0; i < 40; ++i) {
    const double angle = std::numbers::pi * (i / 40.0 - 0.5);
    turn.points_mm.emplace_back(5.0 + radius_mm * std::cos(angle), radius_mm * std::sin(angle), 0.0);
  }
  for (int i = 0; i < 40; ++i) turn.points_mm.emplace_back(5.0 - 0.25 * i, radius_mm, 0.0);
  for (int i = 0; i < 40; ++i) {
    const double angle = std::numbers::pi * (i / 40.0 + 0.5);
    turn.points_mm.emplace_back(-5.0 + radius_mm * std::cos(angle), radius_mm * std::sin(angle), 0.0);
  }
  return turn;
}

TEST(EvenCentre, TheWayIntoASlitGoesOnceAroundAndNeverBack) {
  const double interval_mm = 2.0;
  std::vector<Vec3> slit;
  for (int i = 0; i <= 20; ++i) slit.emplace_back(-5.0 + 0.5 * i, 0.0, 0.0);
  LastTurn turn = stadium(interval_mm);
  for (std::size_t begin : {0u, 30u, 77u, 120u, 159u}) {
    turn.begin = begin;
    const SlitEnding ending = slit_ending(slit, turn, interval_mm);
    ASSERT_FALSE(ending.points_mm.empty()) << begin;
    EXPECT_GE(ending.steps, turn.points_mm.size()) << begin;
    EXPECT_NEAR(std::abs(ending.points_mm.back().x()), 5.0, 1e-12);
    Vec3 before = turn.points_mm[(begin + ending.steps - 1) % 160], here = turn.points_mm[(begin + ending.steps) % 160];
    for (const Vec3& next : ending.points_mm) {
      if ((next - here).norm() < 1e-9) continue;
      EXPECT_GT((here - before).normalized().dot((next - here).normalized()), 0.5);
      before = here;
      here = next;
    }
  }
}

CcPiece bent(double angle_rad, double step_mm) {
  CcPiece piece;
  for (int i = -40; i <= 40; ++i) {
    const double s = i * step_mm;
    const Vec3 p = s < 0.0 ? Vec3(s, 0.0, 0.0) : Vec3(s * std::cos(angle_rad), s * std::sin(angle_rad), 0.0);
    piece.points.push_back({p, Vec3::UnitZ(), 3.0, false});
  }
  return piece;
}

TEST(EvenRounding, ACornerIsRoundedAndMovesLittle) {
  for (double degrees : {65.0, 75.0, 85.0}) {
    CcPiece piece = bent(degrees * std::numbers::pi / 180.0, 0.3);
    const auto moved = round_corners(piece, 2.0);
    ASSERT_EQ(moved.size(), piece.points.size());
    double nearest_mm = 1e9;
    for (const CcPoint& p : piece.points) nearest_mm = std::min(nearest_mm, p.point_P_mm.norm());
    EXPECT_GT(nearest_mm, 0.02) << degrees;
    EXPECT_LT(nearest_mm, 0.2 * 2.0) << degrees;
    EXPECT_EQ((piece.points.back().point_P_mm - bent(degrees * std::numbers::pi / 180.0, 0.3).points.back().point_P_mm)
                  .norm(),
              0.0);
    const auto far = std::count(moved.begin(), moved.end(), 0);
    EXPECT_GT(far, 40) << degrees;
  }
}

TEST(EvenRounding, WhatIsNotSharpStaysBitByBit) {
  for (double turn : {3.0, 0.0}) {
    CcPiece piece = bent(turn > 0.0 ? 0.9 : 1.4, 0.3);  // the run along the boundary, turn 0, stays however sharp
    for (CcPoint& p : piece.points) p.turn = turn;
    const CcPiece before = piece;
    const auto moved = round_corners(piece, 2.0);
    ASSERT_EQ(piece.points.size(), before.points.size());
    EXPECT_EQ(std::count(moved.begin(), moved.end(), 1), 0);
    for (std::size_t i = 0; i < before.points.size(); ++i) {
      EXPECT_EQ(std::memcmp(piece.points[i].point_P_mm.data(), before.points[i].point_P_mm.data(), 3 * sizeof(double)),
                0);
    }
  }
}

// Properties 1 and 2: the points added lie on the chords beside the bend, a tenth of an interval apart, and nowhere
// else.
TEST(EvenRounding, BendsAreFilledAlongTheirChords) {
  const double interval_mm = 2.0, step_mm = 0.7;
  CcPiece piece = bent(0.5, step_mm);
  const CcPiece before = piece;
  fill_bends(piece, interval_mm);
  const int added_a_chord = static_cast<int>(std::ceil(step_mm / (0.1 * interval_mm))) - 1;
  ASSERT_EQ(piece.points.size(), before.points.size() + static_cast<std::size_t>(2 * added_a_chord));
  double length_mm = 0.0, length_before_mm = 0.0;
  for (std::size_t i = 1; i < piece.points.size(); ++i)
    length_mm += (piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm).norm();
  for (std::size_t i = 1; i < before.points.size(); ++i)
    length_before_mm += (before.points[i].point_P_mm - before.points[i - 1].point_P_mm).norm();
  EXPECT_NEAR(length_mm, length_before_mm, 1e-9);
  CcPiece straight = bent(0.1, step_mm);
  fill_bends(straight, interval_mm);
  EXPECT_EQ(straight.points.size(), before.points.size());
}

TEST(EvenRounding, SharpPlacesStandAtTheCorner) {
  const CcPiece piece = bent(1.3, 0.1);
  const auto places = sharp_places_mm(piece, 2.0, std::numbers::pi / 3.0);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_LT(places[0].norm(), 2.0 / 16.0);
  EXPECT_TRUE(sharp_places_mm(bent(0.9, 0.1), 2.0, std::numbers::pi / 3.0).empty());
}

}  // namespace
}  // namespace volute::planner
