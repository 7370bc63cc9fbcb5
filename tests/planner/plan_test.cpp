#include "planner/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/planner/path/sample_surfaces.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

using kinematics::MoveKind;
using kinematics::ToolPathPoint;

/// A flat ring, R3, scallop 0.3: few points, so that everything from surface to leads takes a moment.
PlanRequest small_job() {
  PlanRequest request;
  request.surface = samples::ring(6.0, 16.0, 90, 12);
  request.tool = testing::ball_tool();
  request.scene.part = request.surface;
  request.machine = testing::ac_head();
  request.path.method = Method::periodic;
  request.path.scallop_mm = 0.3;
  request.orientation.smoothing = Smoothing::none;
  return request;
}

std::vector<ToolPathPoint> cuts_of(const PlanResult& result) {
  std::vector<ToolPathPoint> cuts;
  for (const auto& p : result.tool_path.points)
    if (p.move == MoveKind::cut || p.move == MoveKind::link) cuts.push_back(p);
  return cuts;
}

TEST(Plan, GivesOneToolPathFromRapidToRapidWithItsAxes) {
  std::vector<std::string> stages;
  PlanRequest request = small_job();
  request.progress = [&](std::string_view stage, double done) {
    EXPECT_TRUE(done >= 0.0 && done <= 1.0);
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
  };
  const auto result = plan(request);
  ASSERT_TRUE(result) << result.error().message;
  const auto& points = result->tool_path.points;
  EXPECT_EQ(points.front().move, MoveKind::rapid);
  EXPECT_EQ(points.back().move, MoveKind::rapid);
  EXPECT_EQ(stages, (std::vector<std::string>{"path", "interference trees", "orientation", "leads"}));
  for (const std::string& stage : stages) EXPECT_TRUE(result->timing_s.contains(stage)) << stage;
  EXPECT_EQ(result->rotaries_rad.size(), result->cc.path.pieces[0].points.size());
  EXPECT_EQ(result->orientation.interferences_after, 0);
}

TEST(Plan, EveryCutTouchesItsContactWithTheBall) {
  const auto result = plan(small_job());
  ASSERT_TRUE(result);
  for (const auto& p : cuts_of(*result)) {
    EXPECT_NEAR(((p.pose.tip_P_mm + 3.0 * p.pose.axis_P) - (p.contact_P_mm + 3.0 * p.normal_P)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(p.pose.axis_P.norm(), 1.0, 1e-12);
  }
}

TEST(Plan, TheAllowanceStaysOnTheSurface) {
  PlanRequest request = small_job();
  const auto bare = plan(request);
  request.path.allowance_mm = 0.4;
  const auto with_stock = plan(request);
  ASSERT_TRUE(bare && with_stock);
  const auto a = cuts_of(*bare), b = cuts_of(*with_stock);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 moved = (b[i].pose.tip_P_mm + 3.0 * b[i].pose.axis_P) - (a[i].pose.tip_P_mm + 3.0 * a[i].pose.axis_P);
    EXPECT_NEAR((moved - 0.4 * a[i].normal_P).norm(), 0.0, 1e-9) << i;
  }
}

TEST(Plan, OnlyThePartBetweenTwoTurnsIsCut) {
  PlanRequest request = small_job();
  request.path.from_turn = 1.0;
  request.path.to_turn = 2.0;
  const auto result = plan(request);
  ASSERT_TRUE(result) << result.error().message;
  const auto cuts = cuts_of(*result);
  double least_mm = 1e9, greatest_mm = 0.0;
  for (const auto& p : cuts) {
    least_mm = std::min(least_mm, p.contact_P_mm.norm());
    greatest_mm = std::max(greatest_mm, p.contact_P_mm.norm());
  }
  EXPECT_GT(least_mm, 6.5) << "the inner boundary is left alone";
  EXPECT_LT(greatest_mm, 15.5) << "and the outer one";
}

TEST(Plan, PiecesAreJoinedByRapidsThatKeepTheSafeDistance) {
  PlanRequest request = small_job();
  request.path.strategy = Strategy::iso_planar;
  const auto result = plan(request);
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_GT(result->cc.path.pieces.size(), 1U) << "the hole interrupts the planes";
  Scene apart = request.scene;
  apart.obstacles.push_back(request.surface);
  apart.clearance_mm = request.process.safe_distance_mm;
  const Interference beyond(apart, request.tool, nullptr, nullptr);
  int across = 0, low = 0;
  for (std::size_t i = 1; i < result->tool_path.points.size(); ++i) {
    const auto &p = result->tool_path.points[i - 1], &q = result->tool_path.points[i];
    if (p.move != MoveKind::rapid || q.move != MoveKind::rapid) continue;
    ++across;
    low += q.pose.tip_P_mm.z() < request.process.clearance_height_mm ? 1 : 0;
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vec3 axis = ((1.0 - t) * p.pose.axis_P + t * q.pose.axis_P).normalized();
      EXPECT_TRUE(beyond.is_free({(1.0 - t) * p.pose.tip_P_mm + t * q.pose.tip_P_mm, axis})) << i << ", " << t;
    }
  }
  EXPECT_GE(across, static_cast<int>(result->cc.path.pieces.size()) - 1);
  EXPECT_GT(low, 0) << "some pieces are near enough";
}

TEST(Plan, ErrorsOfEveryStageComeThrough) {
  PlanRequest request = small_job();
  request.path.scallop_mm = 5.0;
  EXPECT_EQ(plan(request).error().code, "path-scallop");
  request = small_job();
  request.scene.obstacles = {testing::box(Vec3(-30, -30, 12), Vec3(30, 30, 14))};  // a roof over everything
  request.scene.names = {"roof"};
  EXPECT_FALSE(plan(request)) << "a tool through the roof";
}

}  // namespace
}  // namespace volute::planner
