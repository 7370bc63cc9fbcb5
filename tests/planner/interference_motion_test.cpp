// The way between two poses, and the links of the machine.
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "planner/contact.hpp"
#include "planner/interference.hpp"
#include "tests/cases.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

using kinematics::ToolPose;

Scene posts_on_plane() {
  Scene scene;
  scene.part = testing::sheet(-50, 50, -50, 50, 2.0, [](double, double) { return 0.0; });
  scene.obstacles = {testing::box(Vec3(10, -5, 0), Vec3(20, 5, 60)),
                     testing::box(Vec3(-30, -30, 0), Vec3(-29, 30, 40))};
  return scene;
}

/// Where the spindle hangs 100 above the tip, the fork above it, and the pivot at 200.
kinematics::Machine forked_head() {
  kinematics::Machine machine = testing::ac_head();
  machine.gauge_at_zero_M.translation() = Vec3(0, 0, 100);
  for (const std::size_t k : {3u, 4u}) machine.axes[k].point_M_mm = Vec3(0, 0, 200);
  machine.shapes = {{3, "spindle", testing::box(Vec3(-30, -30, 100), Vec3(30, 30, 230))},
                    {4, "fork arm", testing::box(Vec3(35, -30, 150), Vec3(60, 30, 300))},
                    {2, "ram", testing::box(Vec3(-60, -60, 310), Vec3(60, 60, 500))},
                    {-1, "table", testing::box(Vec3(-300, -300, -100), Vec3(300, 300, -50))}};
  return machine;
}

TEST(InterferenceMotion, ThinWallBetweenFreePosesIsSeen) {
  Scene scene;
  scene.part = testing::sheet(-50, 50, -50, 50, 2.0, [](double, double) { return 0.0; });
  scene.obstacles = {testing::box(Vec3(-0.05, -20, 0), Vec3(0.05, 20, 60))};
  scene.names = {"foil"};
  const Interference check(scene, testing::ball_tool(), nullptr, nullptr);
  const ToolPose left{Vec3(-30, 0, 5), Vec3::UnitZ()}, right{Vec3(30, 0, 5), Vec3::UnitZ()};
  ASSERT_TRUE(check.is_free(left));
  ASSERT_TRUE(check.is_free(right));
  const auto hit = check.first_hit_on({left, right, std::nullopt});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->hit.scene_part, "foil");
  EXPECT_TRUE(check.motion_is_free({left, {Vec3(-30, 20, 5), Vec3::UnitZ()}, std::nullopt}));
}

// The holder (radius 15 + 1 mm clearance) passes a post's face at x = 10: free as long as its wall stays below.
TEST(InterferenceMotion, ClosedFormOfAGrazingPass) {
  const Interference check(posts_on_plane(), testing::ball_tool(), nullptr, nullptr);
  const auto pass = [&](double x) {
    return check.motion_is_free({{Vec3(x, -40, 10), Vec3::UnitZ()}, {Vec3(x, 40, 10), Vec3::UnitZ()}, std::nullopt});
  };
  EXPECT_TRUE(pass(10.0 - 16.0 - 1e-3));
  EXPECT_FALSE(pass(10.0 - 16.0 + 0.11));  // the motion tolerance may hide 0.1
}

TEST(InterferenceMotion, MotionAgreesWithDenseSampling) {
  const Scene scene = posts_on_plane();
  const kinematics::Machine machine = forked_head();
  const kinematics::Setup setup;
  const Interference check(scene, testing::ball_tool(), &machine, &setup);
  const unsigned seed = 17;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int free = 0, blocked = 0;
  for (int n = 0; n < cases(150); ++n) {
    const auto axis = [](const RotaryPair& at) {
      return Vec3(std::sin(at[1]) * std::sin(at[0]), -std::cos(at[1]) * std::sin(at[0]), std::cos(at[0]));
    };
    const RotaryPair from = {0.6 * any(random), 3.0 * any(random)};
    const RotaryPair to = {from[0] + 0.1 * any(random), from[1] + 0.2 * any(random)};
    const Vec3 tip(30 * any(random), 30 * any(random), 15 + 15 * any(random));
    const ToolMotion motion{
        {tip, axis(from)}, {tip + 5 * Vec3(any(random), any(random), any(random)), axis(to)}, std::array{from, to}};
    bool all_free = true;
    for (int k = 0; k <= 400 && all_free; ++k) {
      const double t = k / 400.0;
      const ToolPose pose{motion.from.tip_P_mm + t * (motion.to.tip_P_mm - motion.from.tip_P_mm),
                          axis({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])})};
      all_free = check.is_free_but_tip(pose) &&
                 check.links_are_free(pose, {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
    }
    const auto hit = check.first_hit_on(motion);
    (all_free ? free : blocked)++;
    // What touches for one sample alone may be a graze within the tolerance: a scene grown by it decides.
    if (all_free) {
      ASSERT_FALSE(hit) << "seed " << seed << " case " << n << ": " << hit->hit.tool_part << " against "
                        << hit->hit.scene_part;
    }
    if (!hit && !all_free) {
      Scene thinner = scene;
      thinner.clearance_mm -= 2.0 * scene.motion_tolerance_mm;
      thinner.gouge_tolerance_mm += 2.0 * scene.motion_tolerance_mm;
      const Interference smaller(thinner, testing::ball_tool(), &machine, &setup);
      for (int k = 0; k <= 400; ++k) {
        const double t = k / 400.0;
        const RotaryPair at = {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])};
        const ToolPose pose{motion.from.tip_P_mm + t * (motion.to.tip_P_mm - motion.from.tip_P_mm), axis(at)};
        ASSERT_TRUE(smaller.is_free_but_tip(pose) && smaller.links_are_free(pose, at))
            << "seed " << seed << " case " << n << " at " << t;
      }
    }
  }
  EXPECT_GE(free, cases(150) / 15);
  EXPECT_GE(blocked, cases(150) / 15);
}

TEST(InterferenceLinks, LinksKeepTheClearance) {
  const kinematics::Machine machine = forked_head();
  const kinematics::Setup setup;
  Scene scene;
  scene.obstacles = {testing::box(Vec3(100, -50, 0), Vec3(120, 50, 350))};
  scene.names = {"pillar"};
  kinematics::Tool tool = testing::ball_tool();
  tool.holder.clear();
  const Interference check(scene, tool, &machine, &setup);
  ASSERT_TRUE(check.has_machine());
  // The tip at (x, 0, 10): the fork arm's face stands at x + 60, the pillar's at 100, the clearance is 1.
  const RotaryPair zero = {0.0, 0.0};
  EXPECT_TRUE(check.links_are_free({Vec3(38.9, 0, 10), Vec3::UnitZ()}, zero));
  const auto hit = check.first_link_hit({Vec3(39.1, 0, 10), Vec3::UnitZ()}, zero);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->tool_part, "fork arm");
  EXPECT_EQ(hit->scene_part, "pillar");
  // Turned by half a turn the arm hangs on the other side, and the spindle's face at x + 30 decides (ram: 60, above).
  const RotaryPair turned = {0.0, std::numbers::pi};
  EXPECT_TRUE(check.links_are_free({Vec3(38.9, 0, 10), Vec3::UnitZ()}, turned));
  Scene low = scene;
  low.obstacles = {testing::box(Vec3(100, -50, 0), Vec3(120, 50, 300))};
  const Interference below(low, tool, &machine, &setup);
  EXPECT_TRUE(below.links_are_free({Vec3(68.9, 0, 10), Vec3::UnitZ()}, turned));
  EXPECT_FALSE(below.links_are_free({Vec3(69.1, 0, 10), Vec3::UnitZ()}, turned));
}

TEST(InterferenceLinks, ToolAgainstTableAndJoints) {
  kinematics::Machine machine = forked_head();
  const kinematics::Setup setup;
  const Interference check(Scene{}, testing::ball_tool(), &machine, &setup);
  // The table's top is at -50; the cutter keeps 1 mm.
  EXPECT_TRUE(check.links_are_free({Vec3(0, 0, -48.9), Vec3::UnitZ()}, {0, 0}));
  const auto hit = check.first_link_hit({Vec3(0, 0, -49.1), Vec3::UnitZ()}, {0, 0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->tool_part, "cutter");
  EXPECT_EQ(hit->scene_part, "table");
  // Spindle against ram: two axes apart. Leaning by 90 degrees the spindle's box stays below 230, the ram begins at
  // 310; a taller spindle swings into it: its corner at distance hypot(30, 130) from the pivot at 200 reaches 330.
  EXPECT_TRUE(check.links_are_free({Vec3(0, 0, 100), Vec3::UnitZ()}, {1.5, 0}));
  machine.shapes[0].mesh_M = testing::box(Vec3(-30, -30, 70), Vec3(30, 30, 230));
  const Interference taller(Scene{}, testing::ball_tool(), &machine, &setup);
  const double lean = 2.9;
  const ToolPose pose{Vec3(0, 0, 100), Vec3(0, -std::sin(lean), std::cos(lean))};
  const auto met = taller.first_link_hit(pose, {lean, 0});
  ASSERT_TRUE(met);
  EXPECT_EQ(met->tool_part + " " + met->scene_part, "spindle ram");
  // Where they touch with all axes at zero they are joined.
  machine.shapes[0].mesh_M = testing::box(Vec3(-30, -30, 70), Vec3(30, 30, 320));
  const Interference joined(Scene{}, testing::ball_tool(), &machine, &setup);
  EXPECT_TRUE(joined.links_are_free({Vec3(0, 0, 100), Vec3::UnitZ()}, {0, 0}));
}

// A rotary table turns the part under a head that stands still: the motion of the head relative to the part is seen.
TEST(InterferenceLinks, TurningTableCarriesTheFixtureIntoTheSpindle) {
  kinematics::Machine machine = testing::ac_head();
  machine.chain = {4, 3, 0, 1, 2};
  machine.table_axes = 2;
  machine.gauge_at_zero_M.translation() = Vec3(0, 0, 100);
  machine.shapes = {{2, "spindle", testing::box(Vec3(-30, -30, 100), Vec3(30, 30, 200))}};
  Scene scene;
  scene.fixtures = {testing::box(Vec3(60, -5, 0), Vec3(80, 5, 160))};
  scene.names = {"clamp"};
  kinematics::Tool tool = testing::ball_tool();
  tool.holder.clear();
  tool.gauge_length_mm = 100.0;
  const kinematics::Setup setup;
  const Interference check(scene, tool, &machine, &setup);
  // The tip goes round the origin 50 away from it, on the part; C turns so that the spindle's corner does not help it.
  const auto at = [](double angle) {
    return ToolPose{Vec3(50 * std::cos(angle), 50 * std::sin(angle), 0), Vec3::UnitZ()};
  };
  EXPECT_FALSE(check.links_are_free(at(0.0), {0, 0}));
  EXPECT_TRUE(check.links_are_free(at(2.0), {0, 0}));
  EXPECT_TRUE(check.links_are_free(at(-2.0), {0, 0}));
  // Straight from -2 to 2 rad the tip crosses far from the clamp, but not when it makes the way by the front.
  EXPECT_TRUE(check.motion_is_free({at(-2.0), at(2.0), std::array<RotaryPair, 2>{{{0, 0}, {0, 0}}}}));
  const auto hit = check.first_hit_on({at(-0.9), at(0.9), std::array<RotaryPair, 2>{{{0, 0}, {0, 0}}}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->hit.tool_part, "spindle");
  EXPECT_EQ(hit->hit.scene_part, "clamp");
}

}  // namespace
}  // namespace volute::planner
