#include "sim/collision.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <random>

#include "sim/collision_shapes.hpp"

namespace volute::sim {
namespace {

using geometry::TriangleMesh;
using kinematics::ConeSegment;
using kinematics::Machine;

TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices_mm.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

CollisionBody single(std::unique_ptr<ConvexPiece> piece) {
  std::vector<std::unique_ptr<ConvexPiece>> pieces;
  pieces.push_back(std::move(piece));
  return {"piece", std::move(pieces)};
}

kinematics::Cutter ball(double r, double length) { return {kinematics::CutterShape::ball, r, r, {}, length, 2}; }

TEST(BodyDistance, BallOverATriangleIsTheHeightLessTheRadius) {
  const auto cutter = single(cutter_piece(ball(3.0, 20.0), 0.0));
  const auto plate = single(triangle_piece(Vec3(-50, -50, 0), Vec3(50, -50, 0), Vec3(0, 80, 0)));
  std::int64_t pairs = 0;
  for (const double height : {0.001, 0.5, 7.0}) {
    geometry::Transform X = geometry::Transform::Identity();
    X.linear() = Eigen::AngleAxisd(0.6, Vec3::UnitX()).toRotationMatrix();
    X.translation() = Vec3(1, 2, height + 3.0) - 3.0 * X.linear().col(2);
    EXPECT_NEAR(body_distance_mm(cutter, plate, X, 100.0, pairs), height, 1e-5);
    EXPECT_EQ(body_distance_mm(cutter, plate, X, 0.5 * height, pairs), 0.5 * height);  // no more than asked
  }
  EXPECT_GT(pairs, 0);
}

TEST(BodyDistance, SinksInMeansNegative) {
  const auto cutter = single(cutter_piece(ball(3.0, 20.0), 0.0));
  const auto plate = single(triangle_piece(Vec3(-50, -50, 0), Vec3(50, -50, 0), Vec3(0, 80, 0)));
  std::int64_t pairs = 0;
  geometry::Transform X = geometry::Transform::Identity();
  X.translation() = Vec3(0, 0, -0.01);
  EXPECT_LT(body_distance_mm(cutter, plate, X, 1.0, pairs), 0.0);
  X.translation() = Vec3(0, 0, 0.01);
  EXPECT_NEAR(body_distance_mm(cutter, plate, X, 1.0, pairs), 0.01, 1e-6);
}

TEST(BodyDistance, InsetCutterIsSmallerByTheInset) {
  const auto plate = single(triangle_piece(Vec3(-50, -50, 0), Vec3(50, -50, 0), Vec3(0, 80, 0)));
  std::int64_t pairs = 0;
  for (const auto& cutter : {ball(3.0, 20.0), kinematics::Cutter{kinematics::CutterShape::flat, 5, 0, {}, 20, 2},
                             kinematics::Cutter{kinematics::CutterShape::bull, 5, 1, {}, 20, 2}}) {
    geometry::Transform X = geometry::Transform::Identity();
    EXPECT_NEAR(body_distance_mm(single(cutter_piece(cutter, 0.02)), plate, X, 1.0, pairs), 0.02, 1e-6);
  }
}

TEST(BodyDistance, FrustumBesideAWallIsExact) {
  // Half angle atan(1/4): the nearest point to a wall x = 10 is the bottom or top rim.
  const auto cone = single(frustum_piece({4.0, 6.0, 5.0, 8.0}));
  const auto wall = single(triangle_piece(Vec3(10, -50, -50), Vec3(10, 50, -50), Vec3(10, 0, 90)));
  std::int64_t pairs = 0;
  EXPECT_NEAR(body_distance_mm(cone, wall, geometry::Transform::Identity(), 100.0, pairs), 4.0, 1e-6);
}

TEST(BodyDistance, TreeGivesWhatEveryPairGives) {
  std::mt19937_64 random(61);
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  TriangleMesh soup;
  for (int i = 0; i < 200; ++i) {
    const Vec3 at = 30.0 * Vec3(uniform(random), uniform(random), uniform(random));
    for (int k = 0; k < 3; ++k)
      soup.vertices_mm.push_back(at + 3.0 * Vec3(uniform(random), uniform(random), uniform(random)));
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto body = CollisionBody::of_triangles("soup", soup);
  const auto tool = single(frustum_piece({2.0, 4.0, 0.0, 10.0}));
  std::int64_t quick = 0, all = 0;
  for (int i = 0; i < 100; ++i) {
    geometry::Transform X = geometry::Transform::Identity();
    X.linear() = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
    X.translation() = 40.0 * Vec3(uniform(random), uniform(random), uniform(random));
    double least = 1000.0;
    for (const auto& t : soup.triangles) {
      const auto v = [&](int k) { return soup.vertices_mm[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
      least = std::min(least, body_distance_mm(tool, single(triangle_piece(v(0), v(1), v(2))), X, 1000.0, all));
    }
    const double found = body_distance_mm(tool, body, X, 1000.0, quick);
    if (least > 0.0) {
      EXPECT_NEAR(found, least, 1e-5);
    } else {
      EXPECT_LE(found, 0.0);
    }
  }
  EXPECT_LT(quick, all / 5);
}

/// EPA's shortest way out, known in closed form; over all pieces the greatest.
TEST(BodyDepth, IsTheShortestWayOutOfTheDeepestPiece) {
  const auto block = CollisionBody::of_components("block", box(Vec3(-30, -30, -20), Vec3(30, 30, 0)));
  ASSERT_EQ(block.piece_count(), 1u);
  geometry::Transform X = geometry::Transform::Identity();
  for (const double deep : {0.01, 1.5, 7.0}) {
    X.translation() = Vec3(3, -4, -deep);
    EXPECT_NEAR(body_depth_mm(single(frustum_piece({6.0, 9.0, 0.0, 40.0})), block, X), deep, 1e-4);
    EXPECT_NEAR(body_depth_mm(block, single(frustum_piece({6.0, 9.0, 0.0, 40.0})), X.inverse()), deep, 1e-4);
  }
  X.translation() = Vec3(0, 0, 0.5);
  EXPECT_EQ(body_depth_mm(single(frustum_piece({6.0, 9.0, 0.0, 40.0})), block, X), 0.0);
  TriangleMesh two = box(Vec3(-30, -30, -20), Vec3(-2, 30, -1));  // one top lies 1 mm lower than the other
  const TriangleMesh other = box(Vec3(2, -30, -20), Vec3(30, 30, 0));
  for (const auto& t : other.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  two.vertices_mm.insert(two.vertices_mm.end(), other.vertices_mm.begin(), other.vertices_mm.end());
  X.translation() = Vec3(0, 0, -3.0);
  EXPECT_NEAR(body_depth_mm(single(frustum_piece({9.0, 9.0, 0.0, 40.0})), CollisionBody::of_components("two", two), X),
              3.0, 1e-4);
}

TEST(CollisionBody, ConvexComponentsBecomeHullsOthersStayTriangles) {
  TriangleMesh two = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const TriangleMesh other = box(Vec3(5, 0, 0), Vec3(6, 1, 1));
  for (const auto& t : other.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  two.vertices_mm.insert(two.vertices_mm.end(), other.vertices_mm.begin(), other.vertices_mm.end());
  EXPECT_EQ(CollisionBody::of_components("two boxes", two).piece_count(), 2u);
  TriangleMesh dented = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  dented.vertices_mm[7] = Vec3(0.4, 0.4, 0.4);
  EXPECT_EQ(CollisionBody::of_components("dented", dented).piece_count(), 12u);
}

/// The gantry head of the repository with the part's origin at M's.
struct Workshop {
  Machine machine;
  kinematics::Setup setup;
  CollisionScene scene;
  Workshop() {
    auto loaded = kinematics::load_machine(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines" / "ac-head.toml");
    EXPECT_TRUE(loaded) << loaded.error().message;
    machine = loaded.value_or(Machine{});
    scene.tool.cutter = ball(3.0, 20.0);
    scene.tool.shank_radius_mm = 3.0;
    scene.tool.stick_out_mm = 40.0;
    scene.tool.holder = {ConeSegment{20, 20, 40, 30}, ConeSegment{25, 30, 70, 30}};
    scene.tool.gauge_length_mm = 100.0;
    scene.part_P = box(Vec3(-50, -50, -20), Vec3(50, 50, 0));
  }
  /// Upright tool with its tip at a point of the part.
  [[nodiscard]] MachineState at(const Vec3& tip, std::int64_t line, bool rapid) const {
    MachineState s;
    s.q = kinematics::program_zero(machine, setup, scene.tool.gauge_length_mm);
    s.q.head<3>() += tip;
    s.pose_P = kinematics::tool_pose(machine, setup, scene.tool.gauge_length_mm, s.q);
    s.line = line;
    s.time_s = 0.1 * static_cast<double>(line);
    s.rapid = rapid;
    s.cutting = !rapid;
    return s;
  }
  [[nodiscard]] CollisionReport check(const std::vector<MachineState>& states, double step = 0.5) const {
    return check_collisions(scene, machine, setup, states, step);
  }
};

TEST(CheckCollisions, CuttingAlongTheSurfaceIsFree) {
  const Workshop shop;
  const auto report = shop.check({shop.at({0, 0, 50}, 1, true), shop.at({0, 0, 0}, 2, false),
                                  shop.at({40, 10, 0}, 3, false), shop.at({40, 10, 50}, 4, true)});
  EXPECT_EQ(report.sim_hits, 0);
  EXPECT_TRUE(report.findings.empty());
  EXPECT_GT(report.pairs_checked, 0);
  EXPECT_NEAR(report.closest_mm, 20.0, 1.0);  // the shank begins 20 mm over the tip
  EXPECT_EQ(report.closest_pair, "shank-part");
}

TEST(CheckCollisions, TooDeepIsFoundOnRapidsAndCuts) {
  const Workshop shop;
  for (const bool rapid : {false, true}) {
    const auto report = shop.check({shop.at({0, 0, 50}, 1, true), shop.at({0, 0, 5}, 2, true),
                                    shop.at({10, 0, -0.05}, 3, rapid), shop.at({10, 0, 50}, 4, true)});
    ASSERT_FALSE(report.findings.empty());
    EXPECT_EQ(report.findings[0].kind, "collision");
    EXPECT_EQ(report.findings[0].axis_or_pair, "cutter-part");
    EXPECT_EQ(report.findings[0].line, 3);
  }
}

TEST(CheckCollisions, PlantedHolderAndFixtureInARapid) {
  Workshop shop;
  shop.scene.obstacles_P = {box(Vec3(10, -5, 0), Vec3(14, 5, 60))};
  shop.scene.obstacle_names = {"clamp"};
  // Crosses the clamp with the holder only: its face stands 40 mm over the tip, tip at z = 15 keeps 15 + 40 < 60.
  const auto report = shop.check({shop.at({-60, 40, 15}, 1, true), shop.at({-60, 16, 15}, 2, true),
                                  shop.at({60, 16, 15}, 7, true), shop.at({60, 16, 80}, 8, true)});
  ASSERT_EQ(report.sim_hits, 1);
  EXPECT_EQ(report.findings[0].kind, "collision");
  EXPECT_EQ(report.findings[0].line, 7);
  EXPECT_EQ(report.findings[0].axis_or_pair, "holder-clamp");
  EXPECT_NE(report.findings[0].text.find("line 7"), std::string::npos);
  // Time and pose: the holder's face has radius 20 and passes 11 from the clamp's side, so it touches
  // sqrt(20^2 - 11^2) before the edge.
  const double x = 10.0 - std::sqrt(400.0 - 121.0), share = (x + 60.0) / 120.0;
  EXPECT_NEAR(report.findings[0].time_s, 0.2 + share * 0.5, 0.5 / 120.0 * 0.5 + 1e-9);
  ASSERT_TRUE(report.findings[0].pose_P && report.findings[0].axes);
  const Vec3& tip = report.findings[0].pose_P->tip_P_mm;
  EXPECT_NEAR(tip.x(), x + 0.25, 0.26);
  EXPECT_NEAR(tip.y(), 16.0, 1e-9);
  EXPECT_NEAR(tip.z(), 15.0, 1e-9);
  // Depth: the face lies 5 mm under the clamp's top, and 9 mm would part them sideways.
  EXPECT_NEAR(report.findings[0].value, 5.0, 1e-4);
  // High enough it passes.
  EXPECT_EQ(shop.check({shop.at({-60, 20, 25}, 1, true), shop.at({60, 20, 25}, 2, true)}).sim_hits, 0);
}

/// The spindle drives into the blank: the links are held against the stock, the tool is not (the run through the stock
/// does that).
TEST(CheckCollisions, LinksAreHeldAgainstTheBlankTheToolIsNot) {
  Workshop shop;
  shop.scene.part_P = {};
  shop.scene.stock_P = box(Vec3(-60, -60, -20), Vec3(60, 60, 30));
  EXPECT_EQ(shop.check({shop.at({0, 0, 60}, 1, true), shop.at({0, 0, 5}, 2, false)}).sim_hits, 0);
  const auto report = shop.check({shop.at({0, 0, 60}, 1, true), shop.at({0, 0, -120}, 2, false)});
  ASSERT_GE(report.sim_hits, 1);
  for (const auto& f : report.findings) {
    EXPECT_NE(f.axis_or_pair.find("stock"), std::string::npos) << f.axis_or_pair;
    EXPECT_EQ(f.axis_or_pair.find("holder"), std::string::npos) << f.axis_or_pair;
    EXPECT_EQ(f.axis_or_pair.find("cutter"), std::string::npos) << f.axis_or_pair;
  }
}

TEST(CheckCollisions, ClearanceIsAFindingOfItsOwn) {
  Workshop shop;
  shop.scene.obstacles_P = {box(Vec3(10, -5, 0), Vec3(14, 5, 60))};
  shop.scene.obstacle_names = {"clamp"};
  shop.scene.clearance_mm = 1.0;
  const auto report = shop.check({shop.at({-60, 25.4, 15}, 1, true), shop.at({60, 25.4, 15}, 7, true)}, 0.1);
  EXPECT_EQ(report.sim_hits, 0);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].kind, "clearance");
  EXPECT_NEAR(report.findings[0].value, 0.4, 0.1);
  EXPECT_NEAR(report.closest_mm, 0.4, 0.1);
}

TEST(CheckCollisions, AThinPlateIsNotJumpedOver) {
  Workshop shop;
  shop.scene.obstacles_P = {box(Vec3(0, -30, 10), Vec3(0.2, 30, 60))};
  const auto report = shop.check({shop.at({-300, 0, 20}, 1, true), shop.at({300, 0, 20}, 2, true)});
  EXPECT_GE(report.sim_hits, 1);
}

TEST(CheckCollisions, DoesNotDependOnTheNumberOfThreads) {
  Workshop shop;
  shop.scene.obstacles_P = {box(Vec3(10, -5, 0), Vec3(14, 5, 60))};
  shop.scene.clearance_mm = 2.0;
  std::vector<MachineState> states;
  std::mt19937_64 random(62);
  std::uniform_real_distribution<> uniform(-40.0, 40.0);
  for (int i = 0; i < 1500; ++i)
    states.push_back(shop.at({uniform(random), uniform(random), 30.0 + 0.4 * uniform(random)}, i + 1, true));
  const auto many = shop.check(states, 4.0);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single_thread = shop.check(states, 4.0);
  EXPECT_EQ(many.sim_hits, single_thread.sim_hits);
  EXPECT_GT(many.sim_hits, 0);
  EXPECT_EQ(many.closest_mm, single_thread.closest_mm);
  EXPECT_EQ(many.pairs_checked, single_thread.pairs_checked);
  ASSERT_EQ(many.findings.size(), single_thread.findings.size());
  for (std::size_t i = 0; i < many.findings.size(); ++i)
    EXPECT_EQ(many.findings[i].text, single_thread.findings[i].text);
}

TEST(CheckCollisions, NoStatesNothingFound) {
  const Workshop shop;
  EXPECT_EQ(shop.check({}).pairs_checked, 0);
}

}  // namespace
}  // namespace volute::sim
