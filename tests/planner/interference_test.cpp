#include "planner/interference.hpp"

#include <random>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <gtest/gtest.h>

#include "geometry/turn.hpp"
#include "planner/contact.hpp"
#include "planner/interference_shapes.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

using kinematics::ToolPose;

Scene plane_scene() {
  Scene scene;
  scene.part = testing::sheet(-50, 50, -50, 50, 2.0, [](double, double) { return 0.0; });
  return scene;
}

TEST(Interference, CutterMayTouchButNotGouge) {
  const Interference check(plane_scene(), testing::ball_tool(), nullptr, nullptr);
  EXPECT_TRUE(check.is_free({Vec3(0.3, 0.2, 0.0), Vec3::UnitZ()}));
  EXPECT_TRUE(check.is_free({Vec3(0.3, 0.2, -0.009), Vec3::UnitZ()}));
  EXPECT_FALSE(check.is_free({Vec3(0.3, 0.2, -0.011), Vec3::UnitZ()}));
  EXPECT_TRUE(check.is_free_but_tip({Vec3(0.3, 0.2, -0.5), Vec3::UnitZ()}));
  EXPECT_NEAR(check.tip_depth_mm({Vec3(0.3, 0.2, -0.5), Vec3::UnitZ()}), 0.5, 1e-12);
}

TEST(Interference, HolderKeepsTheClearance) {
  const Interference check(plane_scene(), testing::ball_tool(), nullptr, nullptr);
  // Leaning by t the holder's lower rim stands at 40 cos t - 15 sin t above a tip ball's contact.
  const auto height = [](double t) { return 3.0 - 3.0 * std::cos(t) + 40.0 * std::cos(t) - 15.0 * std::sin(t); };
  const auto pose = [](double t) {
    return contact_pose(testing::ball_tool().cutter, Vec3(0.3, 0.2, 0.0), Vec3::UnitZ(),
                        Vec3(std::sin(t), 0.0, std::cos(t)));
  };
  for (double t = 1.0; t < 1.4; t += 0.01) {
    const auto hit = check.first_hit(pose(t));
    if (height(t) > 1.5) {  // square rim of the grown cylinder: up to 0.42 mm early
      EXPECT_FALSE(hit) << t;
    }
    if (height(t) < 1.0) {
      ASSERT_TRUE(hit) << t;
      EXPECT_EQ(hit->tool_part, "holder");
      EXPECT_EQ(hit->scene_part, "part");
    }
  }
}

TEST(Interference, ObstacleIsNamedAndKeptClear) {
  Scene scene = plane_scene();
  scene.obstacles = {testing::box(Vec3(10, -5, 0), Vec3(20, 5, 30))};
  scene.names = {"post.stl"};
  const Interference check(scene, testing::ball_tool(), nullptr, nullptr);
  EXPECT_TRUE(check.is_free({Vec3(-16.0 + 10.0 - 0.01, 0.0, 0.0), Vec3::UnitZ()}));
  const auto hit = check.first_hit({Vec3(6.05, 0.0, 0.0), Vec3::UnitZ()});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->scene_part, "post.stl");
  EXPECT_EQ(hit->tool_part, "cutter");
}

TEST(Interference, WhollyInsideAClosedSolidIsAHit) {
  Scene scene;
  scene.obstacles = {testing::box(Vec3(-200, -200, -200), Vec3(200, 200, 200))};
  const Interference check(scene, testing::ball_tool(), nullptr, nullptr);
  EXPECT_FALSE(check.is_free({Vec3::Zero(), Vec3::UnitZ()}));
  EXPECT_EQ(check.clearance_mm({Vec3::Zero(), Vec3::UnitZ()}, 5.0), 0.0);
  EXPECT_TRUE(check.is_free({Vec3(0, 0, 210), Vec3::UnitZ()}));
}

TEST(Interference, ClearanceBoundsMotion) {
  Scene scene = plane_scene();
  scene.obstacles = {testing::box(Vec3(10, -5, 0), Vec3(20, 5, 60))};
  const Interference check(scene, testing::ball_tool(), nullptr, nullptr);
  const unsigned seed = 11;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int tried = 0;
  for (int n = 0; n < 400; ++n) {
    const ToolPose pose{Vec3(30 * any(random), 30 * any(random), 20 + 20 * any(random)),
                        Vec3(any(random), any(random), 1.0).normalized()};
    const double clear = check.clearance_mm(pose, 5.0);
    if (clear <= 0.0) continue;
    ++tried;
    ASSERT_TRUE(check.is_free_but_tip(pose)) << "seed " << seed << " case " << n;
    for (int k = 0; k < 5; ++k) {
      const Vec3 shift = 0.999 * clear * Vec3(any(random), any(random), any(random)).normalized();
      ASSERT_TRUE(check.is_free_but_tip({pose.tip_P_mm + shift, pose.axis_P})) << "seed " << seed << " case " << n;
    }
  }
  EXPECT_GT(tried, 30);
}

kinematics::Tool end_mill(kinematics::CutterShape shape, double radius_mm, double corner_mm) {
  kinematics::Tool tool = testing::ball_tool();
  tool.cutter = {shape, radius_mm, corner_mm, {}, 20.0, 2};
  return tool;
}

/// A valley that the cutters stand in, with a post beside it.
Scene valley_scene() {
  Scene scene;
  scene.part = testing::sheet(-30, 30, -30, 30, 1.5, [](double x, double y) { return 0.008 * x * x + 0.004 * x * y; });
  scene.obstacles = {testing::box(Vec3(10, -5, 0), Vec3(20, 5, 60))};
  return scene;
}

struct Turns {
  int free = 0, blocked = 0;
};

/// Orientations round (tilt, yaw) at the bottom of the valley, both within `most_rad`: the tool turns about the
/// contact.
struct Orientations {
  double tilt_rad, yaw_rad, most_rad;

  [[nodiscard]] static ToolPose pose(const kinematics::Tool& tool, double t, double y) {
    const Vec3 axis(std::sin(t) * std::cos(y), std::sin(t) * std::sin(y), std::cos(t));
    return contact_pose(tool.cutter, Vec3::Zero(), Vec3::UnitZ(), axis);
  }
  [[nodiscard]] ToolPose middle(const kinematics::Tool& tool) const { return pose(tool, tilt_rad, yaw_rad); }
  [[nodiscard]] TurnBound turn(const kinematics::Tool& tool, double tube_mm) const {
    TurnBound turn{Vec3(0, 0, tube_mm), 2.0 * most_rad, 1e9, 0.0, Vec3::Zero(), 0.0, 0.0};
    if (const double circle_mm = tool.cutter.radius_mm - tube_mm; circle_mm > 0.0) {
      turn.ball_radius_mm = circle_mm / std::sin(tilt_rad - most_rad) + tube_mm;
      turn.ball_centre_mm = turn.ball_radius_mm * Vec3::UnitZ();
      turn.within_mm = 2.0 * circle_mm / std::tan(tilt_rad + most_rad) - tube_mm;
    }
    return turn;
  }
};

Orientations random_orientations(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const double tilt_rad = 0.7 + 0.6 * any(random), yaw_rad = 3.14 * any(random);
  return {tilt_rad, yaw_rad, 0.02 * (1.0 + any(random))};
}

/// What is told free or blocked for all turns up to a bound has to be so at every one of them.
Turns try_turns(const kinematics::Tool& tool, double tube_mm) {
  const Interference check(valley_scene(), tool, nullptr, nullptr);
  const unsigned seed = 77;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Turns found;
  for (int n = 0; n < 1500; ++n) {
    const Orientations all = random_orientations(random);
    const ToolPose middle = all.middle(tool);
    const TurnBound turn = all.turn(tool, tube_mm);
    const bool free = check.stays_free(middle, turn), blocked = check.stays_blocked(middle, turn);
    found.free += free ? 1 : 0;
    found.blocked += blocked ? 1 : 0;
    for (int k = 0; k < 8 && (free || blocked); ++k) {
      const ToolPose turned =
          Orientations::pose(tool, all.tilt_rad + all.most_rad * any(random), all.yaw_rad + all.most_rad * any(random));
      EXPECT_EQ(check.is_free_but_tip(turned), free) << "seed " << seed << " case " << n;
    }
  }
  return found;
}

/// A verdict from scratch, and one that only asks what a wider turn left open, against the questions one by one.
TEST(Interference, VerdictsAreThoseOfTheSingleQuestions) {
  const kinematics::Tool tool = end_mill(kinematics::CutterShape::bull, 5.0, 1.0);
  const Interference check(valley_scene(), tool, nullptr, nullptr);
  const unsigned seed = 78;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-0.5, 0.5);
  int free = 0, blocked = 0, hits = 0, fewer = 0;
  const auto agree = [&](const TurnVerdict& verdict, const ToolPose& pose, const TurnBound& turn) {
    const auto hit = check.first_hit_but_tip(pose), open = check.first_open_hit(pose, verdict.open);
    ASSERT_EQ(open.has_value(), hit.has_value());
    if (hit) {
      EXPECT_EQ(open->tool_part + open->scene_part, hit->tool_part + hit->scene_part);
    }
    EXPECT_TRUE(verdict.free || !check.stays_free(pose, turn));
    EXPECT_TRUE(verdict.open.surely_blocked || !check.stays_blocked(pose, turn));
    hits += hit ? 1 : 0;
  };
  for (int n = 0; n < 500; ++n) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " case " + std::to_string(n));
    const Orientations wide = random_orientations(random);
    const TurnVerdict first = check.verdict(wide.middle(tool), wide.turn(tool, 1.0), check.open_pairs());
    agree(first, wide.middle(tool), wide.turn(tool, 1.0));
    EXPECT_EQ(first.free, check.stays_free(wide.middle(tool), wide.turn(tool, 1.0)));
    EXPECT_EQ(first.open.surely_blocked, check.stays_blocked(wide.middle(tool), wide.turn(tool, 1.0)));
    const Orientations part{wide.tilt_rad + wide.most_rad * any(random), wide.yaw_rad + wide.most_rad * any(random),
                            0.5 * wide.most_rad};
    agree(check.verdict(part.middle(tool), part.turn(tool, 1.0), first.open), part.middle(tool), part.turn(tool, 1.0));
    free += first.free ? 1 : 0;
    blocked += first.open.surely_blocked ? 1 : 0;
    fewer += first.open.pairs.size() < check.open_pairs().pairs.size() ? 1 : 0;
  }
  EXPECT_GT(free, 50);
  EXPECT_GT(blocked, 30);
  EXPECT_GT(hits, 100);
  EXPECT_GT(fewer, 200);
}

TEST(Interference, StaysFreeHoldsForEveryTurn) {
  using kinematics::CutterShape;
  EXPECT_GT(try_turns(end_mill(CutterShape::ball, 3.0, 3.0), 3.0).free, 300);
  EXPECT_GT(try_turns(end_mill(CutterShape::flat, 4.0, 0.0), 0.0).free, 300);
  EXPECT_GT(try_turns(end_mill(CutterShape::bull, 5.0, 1.0), 1.0).free, 300);
}

TEST(Interference, StaysBlockedHoldsForEveryTurn) {
  using kinematics::CutterShape;
  EXPECT_GT(try_turns(end_mill(CutterShape::ball, 3.0, 3.0), 3.0).blocked, 100);
  EXPECT_GT(try_turns(end_mill(CutterShape::flat, 4.0, 0.0), 0.0).blocked, 100);
  EXPECT_GT(try_turns(end_mill(CutterShape::bull, 5.0, 1.0), 1.0).blocked, 100);
}

/// Plain FCL: every shape against the whole mesh, through a bounding volume whose fit to a Convex is sound.
bool plain_fcl_is_free(const Scene& scene, const kinematics::Tool& tool, const ToolPose& pose) {
  const auto model_of = [](const geometry::TriangleMesh& mesh) {
    std::vector<fcl::Vector3d> points(mesh.vertices_mm.begin(), mesh.vertices_mm.end());
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles) {
      triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                             static_cast<std::size_t>(t[2]));
    }
    auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
    model->beginModel();
    model->addSubModel(points, triangles);
    model->endModel();
    return model;
  };
  static const auto part = model_of(scene.part), post = model_of(scene.obstacles.front());
  for (const ToolPiece& piece : tool_pieces(tool)) {
    const double at_part = piece.part == "cutter" ? -scene.gouge_tolerance_mm : scene.clearance_mm;
    for (const auto& [growth, model] : {std::pair(at_part, part), std::pair(scene.clearance_mm, post)}) {
      const PlacedShape shape = placed_shape(piece, growth);
      fcl::Transform3d X = fcl::Transform3d::Identity();
      X.linear() = geometry::turn_from_z(pose.axis_P).toRotationMatrix();
      X.translation() = pose.tip_P_mm + shape.centre_z_mm * pose.axis_P;
      fcl::CollisionRequestd request;
      fcl::CollisionResultd result;
      if (fcl::collide(shape.shape.get(), X, model.get(), fcl::Transform3d::Identity(), request, result) > 0)
        return false;
    }
  }
  return true;
}

TEST(Interference, AgreesWithPlainFclOnTaperedHolders) {
  Scene scene;
  scene.part =
      testing::sheet(-40, 40, -40, 40, 1.5, [](double x, double y) { return 3.0 * std::sin(0.1 * x + 0.07 * y); });
  scene.obstacles = {testing::box(Vec3(10, -15, -5), Vec3(18, 15, 45))};
  kinematics::Tool tool = testing::ball_tool();
  tool.cutter = {kinematics::CutterShape::taper_ball, 2.0, 2.0, geometry::Angle::degrees(4.0), 20.0, 2};
  tool.holder = {{6.0, 14.0, 40.0, 25.0}, {14.0, 10.0, 65.0, 20.0}};
  const Interference check(scene, tool, nullptr, nullptr);
  const unsigned seed = 41;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int free = 0, blocked = 0;
  for (int n = 0; n < 1500; ++n) {
    const double x = 35 * any(random), y = 35 * any(random);
    const ToolPose pose{Vec3(x, y, 3.0 * std::sin(0.1 * x + 0.07 * y) + 1.0 + 2.0 * any(random)),
                        Vec3(any(random), any(random), 1.2 + any(random)).normalized()};
    const bool expected = plain_fcl_is_free(scene, tool, pose);
    (expected ? free : blocked)++;
    ASSERT_EQ(check.is_free(pose), expected) << "seed " << seed << " case " << n;
  }
  EXPECT_GT(free, 200);
  EXPECT_GT(blocked, 200);
}

TEST(PlacedShape, GrownShapesHoldTheTrueOnesAndShrunkOnesAreInside) {
  kinematics::Tool tool = testing::ball_tool();
  tool.cutter = {kinematics::CutterShape::bull, 6.0, 1.5, {}, 20.0, 2};
  tool.holder = {{10.0, 20.0, 40.0, 30.0}};
  for (const ToolPiece& piece : tool_pieces(tool)) {
    const PlacedShape grown = placed_shape(piece, 1.0), shrunk = placed_shape(piece, -0.01);
    EXPECT_GE(grown.radius_mm(), std::max(piece.bottom_radius_mm, piece.top_radius_mm) + 1.0);
    EXPECT_LE(grown.z_min_mm, piece.z_min_mm - 1.0 + 1e-9);
    EXPECT_LT(shrunk.radius_mm(), std::max(piece.bottom_radius_mm, piece.top_radius_mm));
    EXPECT_GE(shrunk.z_min_mm, piece.z_min_mm);
  }
}

}  // namespace
}  // namespace volute::planner
