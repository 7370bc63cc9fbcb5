#include "planner/leads.hpp"

#include <gtest/gtest.h>

#include "geometry/mesh_measure.hpp"
#include "tests/planner/flat_cut.hpp"

namespace volute::planner {
namespace {

using geometry::Angle;
using kinematics::MoveKind;
using testing::clearance_z_mm;
using testing::FlatCut;
using testing::lead_radius_mm;
using testing::lowest_z_mm;
using testing::ToolPath;
using testing::ToolPathPoint;

/// The points before the first cut, from the surface outwards, as offsets of the tip from its place at the cut.
std::vector<Vec3> lead_in(const ToolPath& path) {
  std::size_t cut = 0;
  const auto touches = [](const ToolPathPoint& p) {
    return (p.pose.tip_P_mm + 3.0 * p.pose.axis_P - 3.0 * p.normal_P - p.contact_P_mm).norm() < 1e-9;
  };
  while (!touches(path.points[cut])) ++cut;
  std::vector<Vec3> offsets;
  for (std::size_t k = cut; k-- > 0;) offsets.push_back(path.points[k].pose.tip_P_mm - path.points[cut].pose.tip_P_mm);
  return offsets;
}

TEST(Leads, AnArcIsAQuarterCircleTangentToThePath) {
  const FlatCut job;
  const auto path = job.planned();
  ASSERT_TRUE(path) << path.error().message;
  const auto offsets = lead_in(*path);
  ASSERT_GT(offsets.size(), 5U);
  const Vec3 centre = lead_radius_mm * Vec3::UnitZ();
  for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
    EXPECT_NEAR((offsets[k] - centre).norm(), lead_radius_mm, 1e-12) << k;
    EXPECT_NEAR(offsets[k].y(), 0.0, 1e-12) << "in the plane of path and normal";
    EXPECT_LT(offsets[k].x(), 0.0) << "behind the first point";
  }
  EXPECT_LT(std::atan2(offsets[0].z(), -offsets[0].x()), 0.07) << "the last chord of 12 on a quarter circle: 3.75 deg";
  EXPECT_NEAR((offsets[offsets.size() - 2] - Vec3(-lead_radius_mm, 0, lead_radius_mm)).norm(), 0.0, 1e-12);
}

TEST(Leads, ARampStandsAtItsAngleToTheSurface) {
  FlatCut job;
  job.process.lead_shape = LeadShape::ramp;
  for (const double degrees : {5.0, 15.0, 40.0}) {
    job.process.ramp_angle = Angle::degrees(degrees);
    const auto path = job.planned();
    ASSERT_TRUE(path) << path.error().message;
    const auto offsets = lead_in(*path);
    ASSERT_EQ(offsets.size(), 2U) << "the ramp's top and the rapid above it";
    EXPECT_NEAR(std::atan2(offsets[0].z(), -offsets[0].x()), degrees * std::numbers::pi / 180.0, 1e-12);
    EXPECT_NEAR(offsets[0].z(), lead_radius_mm, 1e-12);
  }
}

TEST(Leads, MovesAreRapidThenApproachThenCutThenRetractThenRapid) {
  FlatCut job;
  job.process.approach_feed_mm_s = 3.0;
  job.process.feed_mm_s = 10.0;
  const auto path = job.planned();
  ASSERT_TRUE(path);
  const auto& p = path->points;
  EXPECT_EQ(p.front().move, MoveKind::rapid);
  EXPECT_EQ(p.back().move, MoveKind::rapid);
  std::string order;
  for (const auto& point : p) {
    const char letter = point.move == MoveKind::rapid      ? 'r'
                        : point.move == MoveKind::approach ? 'a'
                        : point.move == MoveKind::retract  ? 't'
                                                           : 'c';
    if (order.empty() || order.back() != letter) order += letter;
    const double feed_mm_s = letter == 'r' ? 0.0 : letter == 'a' ? 3.0 : 10.0;
    EXPECT_EQ(point.feed_mm_s, feed_mm_s) << letter;
  }
  EXPECT_EQ(order, "ractr");
  EXPECT_EQ(p.size() - job.cut().points.size(), 2U * 13U) << "12 points of an arc and one above, at both ends";
}

TEST(Leads, StandAboveTheClearanceHeightWithTheWholeAssembly) {
  for (const double degrees : {0.0, 30.0, 60.0}) {
    FlatCut job;
    job.tilt_rad = degrees * std::numbers::pi / 180.0;
    const auto path = job.planned();
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_GE(lowest_z_mm(job.tool, path->points.front().pose), clearance_z_mm - 1e-9) << degrees;
    EXPECT_GE(lowest_z_mm(job.tool, path->points.back().pose), clearance_z_mm - 1e-9) << degrees;
  }
}

/// The rapids before the first move at feed.
std::vector<ToolPathPoint> first_rapids(const ToolPath& path) {
  std::vector<ToolPathPoint> rapids;
  for (const ToolPathPoint& point : path.points) {
    if (point.move != MoveKind::rapid) break;
    rapids.push_back(point);
  }
  return rapids;
}

TEST(Leads, TheRapidDownEndsAtTheSafeDistance) {
  for (const double degrees : {0.0, 30.0, 60.0})
    for (const double safe_mm : {0.2, 5.0, 9.0}) {
      FlatCut job;
      job.tilt_rad = degrees * std::numbers::pi / 180.0;
      job.process.safe_distance_mm = safe_mm;
      const auto path = job.planned();
      ASSERT_TRUE(path) << path.error().message;
      const auto rapids = first_rapids(*path);
      ASSERT_GE(rapids.size(), 2U) << degrees << " deg, " << safe_mm;
      for (std::size_t i = 1; i < rapids.size(); ++i)
        for (double t = 0.0; t <= 1.0; t += 0.01) {
          kinematics::ToolPose pose = rapids[i].pose;
          pose.tip_P_mm = (1.0 - t) * rapids[i - 1].pose.tip_P_mm + t * pose.tip_P_mm;
          EXPECT_GE(lowest_z_mm(job.tool, pose), safe_mm - 1e-9) << degrees << " deg, " << t;
        }
      // Not higher than a step of the search above where the grown tool ends: its rim stands out by the distance along
      // the axis and across it. Never below the lead's beginning.
      const double end_mm = lowest_z_mm(job.tool, rapids.back().pose);
      const double grown_mm = safe_mm * (std::cos(job.tilt_rad) + std::sin(job.tilt_rad));
      EXPECT_LE(end_mm, std::max(grown_mm, lead_radius_mm) + 0.5 + 0.02 * safe_mm) << degrees << " deg";
      EXPECT_EQ(path->points[rapids.size()].move, MoveKind::approach);
    }
}

TEST(Leads, RapidsKeepOutOfTheStock) {
  FlatCut job;
  const double without_mm = lowest_z_mm(job.tool, first_rapids(*job.planned()).back().pose);
  EXPECT_LT(without_mm, lead_radius_mm + 1e-9) << "down to the lead itself, which begins above the safe distance";
  job.stock_P = testing::box(Vec3(-41, -21, -1), Vec3(41, 21, 12));
  const auto path = job.planned();
  ASSERT_TRUE(path) << path.error().message;
  const double end_mm = lowest_z_mm(job.tool, first_rapids(*path).back().pose);
  EXPECT_GE(end_mm, 12.0 + job.process.safe_distance_mm - 1e-9);
  EXPECT_LE(end_mm, 12.0 + job.process.safe_distance_mm + 0.7);
}

TEST(Leads, WithoutRoomForARapidDownTheToolComesAtFeed) {
  FlatCut job;
  job.process.safe_distance_mm = clearance_z_mm + 1.0;
  const auto path = job.planned();
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_EQ(first_rapids(*path).size(), 1U) << "the place at clearance height alone";
}

TEST(Leads, AnObstacleInTheArcsWayTurnsOrShortensIt) {
  FlatCut job;
  // Behind the first point: a wall where the arc with its cutter of radius 3 would pass.
  job.scene.obstacles = {testing::box(Vec3(-30, -10, 0), Vec3(-26, 10, 20))};
  job.scene.names = {"wall"};
  const auto path = job.planned();
  ASSERT_TRUE(path) << path.error().message;
  const Interference interference(job.scene, job.tool, nullptr, nullptr);
  for (const auto& offset : lead_in(*path)) EXPECT_GT(offset.x() - 20.0 - 3.0, -26.0) << "the cutter is clear of it";
  for (const auto& point : path->points) EXPECT_TRUE(interference.is_free_but_tip(point.pose));
  EXPECT_NE((lead_in(*path)[0] - lead_in(*FlatCut().planned())[0]).norm(), 0.0) << "another lead than without the wall";
}

TEST(Leads, TheTipCountsToo) {
  // A step of the part 4 mm behind the first point and 2.5 mm high: the arc of radius 4 would push the ball of radius 3
  // into its edge, while everything above the ball passes over it.
  FlatCut job;
  geometry::TriangleMesh step = testing::box(Vec3(-30, -10, -1), Vec3(-24, 10, 2.5));
  const auto shift = static_cast<geometry::Index>(job.scene.part.vertices_mm.size());
  for (const Vec3& v : step.vertices_mm) job.scene.part.vertices_mm.push_back(v);
  for (geometry::Triangle t : step.triangles)
    job.scene.part.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  const auto path = job.planned();
  ASSERT_TRUE(path) << path.error().message;
  for (const Vec3& offset : lead_in(*path)) {
    const Vec3 centre = Vec3(-20.0, 0.0, 3.0) + offset;
    const Vec3 nearest(std::min(centre.x(), -24.0), 0.0, std::min(centre.z(), 2.5));
    EXPECT_GT((centre - nearest).norm(), 3.0 - 0.02) << "ball into the step at offset " << offset.transpose();
  }
}

TEST(Leads, WhereNothingIsFreeThePieceAndThePlaceAreNamed) {
  FlatCut job;
  job.scene.obstacles = {testing::box(Vec3(-45, -25, 6), Vec3(-10, 25, 8))};  // a roof over the first point
  job.scene.names = {"roof"};
  const auto path = job.planned();
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().code, "lead-blocked");
  EXPECT_NE(path.error().message.find("piece 7"), std::string::npos);
  EXPECT_NE(path.error().message.find("(-20, 0, 0)"), std::string::npos) << path.error().message;
}

TEST(Leads, RapidsBetweenPiecesStayAboveTheClearanceWhileTheAxisTurns) {
  FlatCut one, other;
  one.tilt_rad = 0.9;
  other.tilt_rad = -0.9;
  const Interference interference(one.scene, one.tool, nullptr, nullptr);
  const Interference beyond(rapid_scene(one.scene, {}, one.process.safe_distance_mm), one.tool, nullptr, nullptr);
  const Leads leads(one.tool, interference, beyond, one.process, clearance_z_mm);
  ToolPath whole;
  leads.append(whole, leads.with_leads(one.cut(), 1).value());
  const std::size_t first = whole.points.size();
  leads.append(whole, leads.with_leads(other.cut(), 2).value());
  ASSERT_GT(whole.points.size(), first + 2);
  const auto &from = whole.points[first].pose, &to = whole.points[first + 1].pose;
  EXPECT_EQ(whole.points[first].move, MoveKind::rapid);
  EXPECT_EQ(whole.points[first + 1].move, MoveKind::rapid);
  for (int k = 0; k <= 50; ++k) {
    // The axis turns on the great circle from one to the other: through every lean between.
    const double t = k / 50.0, a = 0.9 - 1.8 * t;
    const kinematics::ToolPose pose{from.tip_P_mm + t * (to.tip_P_mm - from.tip_P_mm),
                                    Vec3(-std::sin(a), 0.0, std::cos(a))};
    EXPECT_GE(lowest_z_mm(one.tool, pose), clearance_z_mm - 1e-9) << k;
  }
}

TEST(Leads, TheHighestPointIsThatOfEverything) {
  Scene scene;
  EXPECT_EQ(highest_point_mm(scene), 0.0);
  scene.part = testing::box(Vec3(0, 0, -9), Vec3(1, 1, -5));
  EXPECT_EQ(highest_point_mm(scene), -5.0);
  scene.fixtures = {testing::box(Vec3(0, 0, -9), Vec3(1, 1, 12))};
  EXPECT_EQ(highest_point_mm(scene), 12.0);
}

}  // namespace
}  // namespace volute::planner
