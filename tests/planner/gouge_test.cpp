// Gouges of sharp, bull and taper-ball cutters where the depth is known in closed form.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "planner/contact.hpp"
#include "planner/interference.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

using geometry::Angle;
using kinematics::CutterShape;
using kinematics::ToolPose;

constexpr double tolerance_mm = 0.01;

kinematics::Tool bare(const kinematics::Cutter& cutter) {
  kinematics::Tool tool;
  tool.cutter = cutter;
  tool.stick_out_mm = cutter.length_mm;
  tool.shank_radius_mm = 0.0;
  return tool;
}

Scene with_part(geometry::TriangleMesh part) {
  Scene scene;
  scene.part = std::move(part);
  scene.gouge_tolerance_mm = tolerance_mm;
  return scene;
}

ToolPose sunk(ToolPose pose, const Vec3& normal, double depth_mm) {
  pose.tip_P_mm -= depth_mm * normal;
  return pose;
}

Vec3 leaning_along_y(Angle tilt) { return {0.0, sin(tilt), cos(tilt)}; }

class OnAPlane : public ::testing::TestWithParam<kinematics::Cutter> {};

// On a plane a cutter touches in its contact alone, whatever its tilt: sinking it by d is a gouge of d.
TEST_P(OnAPlane, GougeIsHowFarTheCutterSinks) {
  const Scene scene = with_part(testing::sheet(-20, 20, -20, 20, 0.7, [](double, double) { return 0.0; }));
  const Interference check(scene, bare(GetParam()), nullptr, nullptr);
  for (const double degrees : {0.0, 0.5, 5.0, 30.0, 60.0}) {
    const ToolPose pose =
        contact_pose(GetParam(), Vec3(0.13, 0.21, 0.0), Vec3::UnitZ(), leaning_along_y(Angle::degrees(degrees)));
    EXPECT_TRUE(check.is_free(pose)) << degrees;
    EXPECT_TRUE(check.is_free(sunk(pose, Vec3::UnitZ(), 0.5 * tolerance_mm))) << degrees;
    EXPECT_FALSE(check.is_free(sunk(pose, Vec3::UnitZ(), 2.0 * tolerance_mm))) << degrees;
  }
}

INSTANTIATE_TEST_SUITE_P(Cutters, OnAPlane,
                         ::testing::Values(kinematics::Cutter{CutterShape::ball, 3.0, 3.0, {}, 15.0, 2},
                                           kinematics::Cutter{CutterShape::flat, 5.0, 0.0, {}, 15.0, 2},
                                           kinematics::Cutter{CutterShape::bull, 6.0, 2.0, {}, 15.0, 2},
                                           kinematics::Cutter{CutterShape::taper_ball, 2.0, 2.0, Angle::degrees(5.0),
                                                              15.0, 2}));

/// A groove along y, round with radius R about the line (0, y, R).
Scene groove(double radius_mm) {
  return with_part(testing::sheet(-0.8 * radius_mm, 0.8 * radius_mm, -12, 12, 0.12, [&](double x, double) {
    return radius_mm - std::sqrt(radius_mm * radius_mm - x * x);
  }));
}

/// Feeding along the groove with the tool leaning along it, the end of the cutter is seen as an ellipse with half axes
/// a and a sin(tilt), grown by the corner radius: its radius at the bottom is corner + a / sin(tilt). It fits a groove
/// of radius R as long as that is no larger than R.
void expect_limit_in_groove(const kinematics::Cutter& cutter, double groove_radius_mm) {
  const double flat_mm = cutter.radius_mm - cutter.corner_radius_mm;
  const Angle limit = Angle::radians(std::asin(flat_mm / (groove_radius_mm - cutter.corner_radius_mm)));
  const Scene scene = groove(groove_radius_mm);
  const Interference check(scene, bare(cutter), nullptr, nullptr);
  const auto free_at = [&](Angle tilt) {
    return check.is_free(contact_pose(cutter, Vec3(0.0, 0.03, 0.0), Vec3::UnitZ(), leaning_along_y(tilt)));
  };
  EXPECT_TRUE(free_at(limit + Angle::degrees(1.0)));
  EXPECT_TRUE(free_at(limit + Angle::degrees(10.0)));
  // Just below the limit the ellipse dips into the groove by less than the tolerance.
  EXPECT_FALSE(free_at(limit - Angle::degrees(8.0)));
  EXPECT_FALSE(free_at(limit - Angle::degrees(12.0)));
}

TEST(Gouge, FlatEndInAGrooveHasItsTiltLimit) {
  expect_limit_in_groove({CutterShape::flat, 5.0, 0.0, {}, 15.0, 2}, 10.0);  // 30 degrees
  expect_limit_in_groove({CutterShape::flat, 3.0, 0.0, {}, 15.0, 2}, 8.0);
}

TEST(Gouge, BullNoseInAGrooveHasItsTiltLimit) {
  expect_limit_in_groove({CutterShape::bull, 6.0, 2.0, {}, 15.0, 2}, 12.0);  // 23.6 degrees
  expect_limit_in_groove({CutterShape::bull, 4.0, 0.5, {}, 15.0, 2}, 9.0);
}

/// A wall at x = 0 with the tool on its side x < 0.
Scene wall() {
  geometry::TriangleMesh mesh = testing::sheet(-30, 30, 0, 40, 0.9, [](double, double) { return 0.0; });
  for (Vec3& v : mesh.vertices_mm) v = Vec3(0.0, v.x(), v.y());
  return with_part(std::move(mesh));
}

TEST(Gouge, FlankOfASharpCutterAgainstAWall) {
  const kinematics::Cutter cutter{CutterShape::flat, 5.0, 0.0, {}, 15.0, 2};
  const Scene scene = wall();
  const Interference check(scene, bare(cutter), nullptr, nullptr);
  EXPECT_TRUE(check.is_free({Vec3(-5.0, 0.2, 5.0), Vec3::UnitZ()}));
  EXPECT_TRUE(check.is_free({Vec3(-5.0 + 0.5 * tolerance_mm, 0.2, 5.0), Vec3::UnitZ()}));
  EXPECT_FALSE(check.is_free({Vec3(-5.0 + 2.0 * tolerance_mm, 0.2, 5.0), Vec3::UnitZ()}));
  // Leaning towards the wall by t the upper rim goes L sin t + R cos t out.
  for (const double t : {0.02, 0.1, 0.3}) {
    const double out = 15.0 * std::sin(t) + 5.0 * std::cos(t);
    const Vec3 axis(std::sin(t), 0.0, std::cos(t));
    EXPECT_TRUE(check.is_free({Vec3(-out - 0.005, 0.2, 10.0), axis})) << t;
    EXPECT_FALSE(check.is_free({Vec3(-out + 0.03, 0.2, 10.0), axis})) << t;
  }
}

// A taper that leans by its own half angle stands with its flank parallel to the wall: only the ball's radius counts.
TEST(Gouge, FlankOfATaperAgainstAWall) {
  const Angle taper = Angle::degrees(10.0);
  const kinematics::Cutter cutter{CutterShape::taper_ball, 2.0, 2.0, taper, 20.0, 2};
  const Scene scene = wall();
  const Interference check(scene, bare(cutter), nullptr, nullptr);
  const auto pose = [&](double centre_to_wall_mm, Angle away) {
    const Vec3 axis(-sin(away), 0.0, cos(away));
    return ToolPose{Vec3(-centre_to_wall_mm, 0.2, 8.0) - 2.0 * axis, axis};
  };
  EXPECT_TRUE(check.is_free(pose(2.0, taper)));
  EXPECT_TRUE(check.is_free(pose(2.0, taper + Angle::degrees(3.0))));
  EXPECT_FALSE(check.is_free(pose(2.0 - 2.0 * tolerance_mm, taper)));
  // Two degrees less and the upper rim, 18 mm above the ball's centre, goes about 18 sin(2 degrees) = 0.63 into it.
  EXPECT_FALSE(check.is_free(pose(2.0, taper - Angle::degrees(2.0))));
  const double radius_at_top = 2.0 * cos(taper) + (20.0 - 2.0 * (1.0 - sin(taper))) * tan(taper);
  EXPECT_TRUE(check.is_free({Vec3(-radius_at_top - 0.005, 0.2, 5.0), Vec3::UnitZ()}));
  EXPECT_FALSE(check.is_free({Vec3(-radius_at_top + 0.02, 0.2, 5.0), Vec3::UnitZ()}));
}

}  // namespace
}  // namespace volute::planner
