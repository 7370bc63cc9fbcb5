#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/path/cc_path.hpp"
#include "planner/path/surface_locator.hpp"
#include "sample_surfaces.hpp"

namespace volute::planner {
namespace {

using geometry::TriangleMesh;

PathOptions asked(Strategy strategy, Method method, double scallop_mm = 0.1) {
  PathOptions options;
  options.strategy = strategy;
  options.method = method;
  options.scallop_mm = scallop_mm;
  return options;
}

Result<CcPathResult> planned(const TriangleMesh& surface, const PathOptions& options) {
  return plan_cc_path(surface, kinematics::Cutter{}, options, OrientationOptions{});
}

TriangleMesh flat_ring() { return samples::ring(6.0, 26.0, 160, 32); }

TriangleMesh two_holes() {
  samples::PlateOptions o;
  o.columns = o.rows = 60;
  o.holes = {{-9.0, -3.0, 4.0}, {8.0, 5.0, 5.0}};
  o.height = [](double x, double y) { return 0.01 * (x * x - y * y); };
  return samples::plate(o);
}

/// Angle that the path winds around the origin, in turns; positive counter-clockwise.
double winding(const CcPiece& piece) {
  double turns = 0.0;
  for (std::size_t i = 1; i < piece.points.size(); ++i) {
    const Vec3 &a = piece.points[i - 1].point_P_mm, &b = piece.points[i].point_P_mm;
    turns += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y()) / (2.0 * std::numbers::pi);
  }
  return turns;
}

TEST(GuidedPath, OnAFlatRingTheSpiralIsNearlyAsShortAsCanBe) {
  for (Method method : {Method::periodic, Method::paper}) {
    const auto result = planned(flat_ring(), asked(Strategy::spiral, method));
    ASSERT_TRUE(result) << result.error().message;
    const PathReport& report = result->report;
    EXPECT_EQ(report.pieces, 1);
    EXPECT_EQ(report.rapid_traversals, 0);
    EXPECT_EQ(report.liftings, 2);
    // Logarithmic height: one increment for the whole ring pays for the narrow inner turns everywhere.
    EXPECT_LT(report.length_ratio, method == Method::periodic ? 1.15 : 2.2);
    EXPECT_GT(report.length_ratio, 1.0);
    EXPECT_LT(report.scallop_ratio_max.value(), 1.02);
    EXPECT_LT(report.interval_ratio_max.value(), 1.03);
    EXPECT_TRUE(method == Method::paper || report.sharp_corners == 0);
    EXPECT_GT(report.seam_kink_max_deg.value(), method == Method::paper ? 15.0 : 0.0) << "a fixed seam bends the path";
    EXPECT_LT(report.seam_kink_max_deg.value(), method == Method::paper ? 60.0 : 15.0);
    EXPECT_EQ(result->surface.map_flips.value(), 0);
  }
}

TEST(GuidedPath, TurnsGrowByOneATurnAndHalfTurnsRunAlongBothBoundaries) {
  const auto result = planned(flat_ring(), asked(Strategy::spiral, Method::periodic));
  ASSERT_TRUE(result);
  const auto& points = result->path.pieces[0].points;
  EXPECT_NEAR(points.front().point_P_mm.norm(), 26.0, 0.02);
  EXPECT_NEAR(points.back().point_P_mm.norm(), 6.0, 0.02);
  EXPECT_NEAR(winding(result->path.pieces[0]), points.back().turn + 1.0, 0.05);
  double on_outer_mm = 0.0;
  for (std::size_t i = 1; i < points.size() && points[i].turn < 1e-3; ++i)
    on_outer_mm += (points[i].point_P_mm - points[i - 1].point_P_mm).norm();
  EXPECT_NEAR(on_outer_mm, std::numbers::pi * 26.0, 2.0);
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_GE(points[i].turn, points[i - 1].turn - 1e-3);
}

TEST(GuidedPath, TwoHolesNeedNoRetractAndKeepTheScallop) {
  for (Method method : {Method::periodic, Method::paper}) {
    const auto result = planned(two_holes(), asked(Strategy::spiral, method));
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->report.pieces, 1);
    EXPECT_EQ(result->map.bridges_P.size(), 2U);
    EXPECT_FALSE(result->map.guide_lines.empty());
    EXPECT_TRUE(method == Method::paper || result->report.scallop_ratio_p9999.value() < 1.05);
    EXPECT_EQ(result->report.notes.size(), method == Method::paper ? 1U : 0U)
        << "one increment degenerates with two holes: said";
  }
}

/// flat_ring from other triangles: every second ring of vertices turned by half a cell (bricks), cells that grow
/// `density` times from the inner rim to the outer one.
TriangleMesh ring_of(int around, int across, bool bricks, double density) {
  TriangleMesh mesh = samples::ring(1.0, 2.0, around, across);
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
    Vec3& p = mesh.vertices_mm[v];
    const std::size_t row = v / static_cast<std::size_t>(around);
    const double share = static_cast<double>(row) / across;
    const double grown = density > 1.0 ? (std::pow(density, share) - 1.0) / (density - 1.0) : share;
    const double angle = std::atan2(p.y(), p.x()) + (bricks && row % 2 == 1 ? std::numbers::pi / around : 0.0);
    p = (6.0 + 20.0 * grown) * Vec3(std::cos(angle), std::sin(angle), 0.0);
  }
  return mesh;
}

TEST(GuidedPath, StretchedTrianglesAndUnevenDensityChangeThePathLittle) {
  // Bricks at the outer rim: 2.55 mm long and 0.11 mm high, angles 5 to 170 degrees. Graded: 0.05 to 1 mm.
  const TriangleMesh bricks = ring_of(64, 180, true, 1.0), graded = ring_of(120, 60, true, 20.0);
  for (Method method : {Method::periodic, Method::paper}) {
    const auto reference = planned(flat_ring(), asked(Strategy::spiral, method));
    ASSERT_TRUE(reference);
    for (const TriangleMesh* mesh : {&bricks, &graded}) {
      const auto result = planned(*mesh, asked(Strategy::spiral, method));
      ASSERT_TRUE(result) << result.error().message;
      EXPECT_EQ(result->report.pieces, 1);
      EXPECT_EQ(result->surface.map_flips.value(), 0);
      EXPECT_LT(result->report.scallop_ratio_p9999.value(), 1.05);
      EXPECT_NEAR(result->report.length_ratio / reference->report.length_ratio, 1.0, 0.05)
          << (mesh == &bricks ? "bricks" : "graded");
    }
  }
}

TEST(GuidedPath, StartsAtTheBoundaryNearestToAPlace) {
  double angle = 0.3;  // another one for every combination
  for (Method method : {Method::periodic, Method::paper})
    for (Strategy strategy : {Strategy::spiral, Strategy::contour_parallel})
      for (Direction direction : {Direction::inward, Direction::outward})
        for (CutDirection cut : {CutDirection::climb, CutDirection::conventional}) {
          angle += 1.7;
          PathOptions options = asked(strategy, method);
          options.direction = direction;
          options.cut_direction = cut;
          options.start_P_mm = 40.0 * Vec3(std::cos(angle), std::sin(angle), 0.0);
          const auto result = planned(flat_ring(), options);
          ASSERT_TRUE(result) << result.error().message;
          const double radius = direction == Direction::inward ? 26.0 : 6.0,
                       edge = 2.0 * std::numbers::pi * radius / 160;
          const Vec3& first = result->path.pieces[0].points.front().point_P_mm;
          EXPECT_LT((first - radius * Vec3(std::cos(angle), std::sin(angle), 0.0)).norm(), 2.0 * edge)
              << static_cast<int>(method) << static_cast<int>(strategy) << static_cast<int>(direction)
              << static_cast<int>(cut) << " angle " << angle;
          EXPECT_LT(result->report.scallop_ratio_max.value(), 1.02);
        }
}

TEST(GuidedPath, TheFirstHoleIsTheNearestOrTheFarthest) {
  samples::PlateOptions o;
  o.columns = o.rows = 60;
  o.holes = {{-13.0, 0.0, 4.0}, {2.0, 0.0, 4.0}};
  const TriangleMesh surface = samples::plate(o);
  for (RootChild child : {RootChild::nearest, RootChild::farthest}) {
    PathOptions options = asked(Strategy::spiral, Method::periodic);
    options.root_child = child;
    const auto result = planned(surface, options);
    ASSERT_TRUE(result) << result.error().message;
    const Vec3 end = result->map.bridges_P[0].back();  // the bridge from the outer boundary
    const double hole_x = child == RootChild::nearest ? -13.0 : 2.0;
    EXPECT_NEAR(std::hypot(end.x() - hole_x, end.y()), 4.0, 0.4);
  }
}

TEST(GuidedPath, ADiskEndsInItsMiddle) {
  samples::PlateOptions o;
  o.columns = o.rows = 50;
  const auto result = planned(samples::plate(o), asked(Strategy::spiral, Method::periodic));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->report.pieces, 1);
  EXPECT_LT(result->path.pieces[0].points.back().point_P_mm.norm(), 3.0);
  EXPECT_LT(result->report.scallop_ratio_p9999.value(), 1.05);
  EXPECT_LT(result->report.length_ratio, 2.0);
}

TEST(GuidedPath, DirectionAndClimbTurnThePathRound) {
  PathOptions options = asked(Strategy::spiral, Method::periodic);
  const auto sense = [&](Direction direction, CutDirection cut) {
    options.direction = direction;
    options.cut_direction = cut;
    const auto result = planned(flat_ring(), options);
    EXPECT_TRUE(result);
    const bool starts_outside = result->path.pieces[0].points.front().point_P_mm.norm() > 25.0;
    EXPECT_EQ(starts_outside, direction == Direction::inward);
    return winding(result->path.pieces[0]) > 0.0;
  };
  EXPECT_TRUE(sense(Direction::inward, CutDirection::conventional));
  EXPECT_FALSE(sense(Direction::inward, CutDirection::climb)) << "clockwise inward: the material is on the right";
  EXPECT_TRUE(sense(Direction::outward, CutDirection::climb));
  EXPECT_FALSE(sense(Direction::outward, CutDirection::conventional));
}

TEST(GuidedPath, APartBetweenTwoTurns) {
  PathOptions options = asked(Strategy::spiral, Method::periodic);
  options.from_turn = 2.0;
  options.to_turn = 4.0;
  const auto result = planned(flat_ring(), options);
  ASSERT_TRUE(result);
  EXPECT_NEAR(winding(result->path.pieces[0]), 2.0, 0.1);
  for (const CcPoint& p : result->path.pieces[0].points) {
    EXPECT_GT(p.turn, 1.9);
    EXPECT_LT(p.turn, 4.1);
  }
  options.from_turn = 400.0;
  options.to_turn = 500.0;
  EXPECT_EQ(planned(flat_ring(), options).error().code, "path-turns");
}

TEST(GuidedPath, ContoursAreClosedPassesWithOneLinkBetween) {
  const auto result = planned(flat_ring(), asked(Strategy::contour_parallel, Method::periodic));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->report.pieces, 1);
  const auto& points = result->path.pieces[0].points;
  EXPECT_EQ(result->report.linkings, static_cast<int>(std::lround(winding(result->path.pieces[0]))) - 1);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_GT((points[i].point_P_mm - points[i - 1].point_P_mm).norm(), 1e-3);
  EXPECT_LT(result->report.scallop_ratio_max.value(), 1.02);
}

TEST(GuidedPath, TheSameInputGivesTheSamePoints) {
  const auto a = planned(two_holes(), asked(Strategy::spiral, Method::periodic)),
             b = planned(two_holes(), asked(Strategy::spiral, Method::periodic));
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->path.pieces[0].points.size(), b->path.pieces[0].points.size());
  for (std::size_t i = 0; i < a->path.pieces[0].points.size(); ++i)
    ASSERT_EQ(a->path.pieces[0].points[i].point_P_mm, b->path.pieces[0].points[i].point_P_mm);
}

TEST(GuidedPath, OnACoarseMeshThePathStaysOnTheMeshAndSaysSo) {
  // A ball of radius 20 from edges of 5 mm: their curves (eq. 15) bulge by 0.16 mm, more than the scallop.
  const TriangleMesh dome = samples::dome(20.0, 0.4, 24, 8);
  const auto result = planned(dome, asked(Strategy::spiral, Method::periodic));
  ASSERT_TRUE(result) << result.error().message;
  std::vector<Vec3> normals;
  for (const Vec3& v : dome.vertices_mm) normals.push_back(v.normalized());
  const SurfaceLocator locator(dome, normals);
  double farthest = 0.0;
  for (const CcPoint& p : result->path.pieces[0].points) {
    const auto hit = locator.nearest(p.point_P_mm, 1.0);
    ASSERT_TRUE(hit);
    farthest = std::max(farthest, (hit->point_mm - p.point_P_mm).norm());
  }
  EXPECT_LT(farthest, 0.1) << "the scallop; 0.32 with the edges' curves and a spline through edge crossings alone";
  ASSERT_FALSE(result->report.notes.empty());
  EXPECT_NE(result->report.notes.back().find("1.5 intervals"), std::string::npos) << result->report.notes.back();
}

TEST(PlanCcPath, SaysWhatIsWrongWithTheJob) {
  EXPECT_EQ(planned(flat_ring(), asked(Strategy::spiral, Method::periodic, 0.0)).error().code, "path-scallop");
  EXPECT_EQ(planned(flat_ring(), asked(Strategy::spiral, Method::periodic, 3.0)).error().code, "path-scallop");
  PathOptions options = asked(Strategy::spiral, Method::periodic);
  options.tolerance_mm = -1.0;
  EXPECT_EQ(planned(flat_ring(), options).error().code, "path-tolerance");
  options.tolerance_mm = 0.01;
  options.start_P_mm = Vec3::Zero();
  options.to_turn = 2.0;
  EXPECT_EQ(planned(flat_ring(), options).error().code, "path-start");
  options.to_turn.reset();
  options.strategy = Strategy::iso_planar;
  EXPECT_EQ(planned(flat_ring(), options).error().code, "path-start");
  const TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_EQ(planned(tetrahedron, asked(Strategy::iso_planar, Method::paper)).error().code, "surface-closed");
}

}  // namespace
}  // namespace volute::planner
