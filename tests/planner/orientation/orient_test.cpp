#include "planner/orientation/orient.hpp"

#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "planner/orientation/pin_loop.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

using geometry::Angle;

/// A straight pass along x over a gently wavy sheet, with boxes beside it.
struct Strip {
  Scene scene;
  CcPiece piece;
  kinematics::Tool tool = testing::ball_tool();
  kinematics::Machine machine = testing::ac_head();
  kinematics::Setup setup;
  OrientationOptions options;

  explicit Strip(std::vector<geometry::TriangleMesh> obstacles) {
    const auto height = [](double x, double) { return 2.0 * std::sin(0.05 * x); };
    scene.part = testing::sheet(-5, 105, -15, 15, 1.0, height);
    scene.obstacles = std::move(obstacles);
    for (double x = 0.0; x <= 100.0; x += 0.5) {
      CcPoint point;
      point.point_P_mm = Vec3(x, 0.0, height(x, 0.0));
      point.normal_P = Vec3(-0.1 * std::cos(0.05 * x), 0.0, 1.0).normalized();
      piece.points.push_back(point);
    }
    options.tilt = Angle::degrees(10.0);
  }
  [[nodiscard]] Result<OrientedPath> orient(Smoothing smoothing) {
    options.smoothing = smoothing;
    const Interference interference(scene, tool, nullptr, nullptr);
    return planner::orient(piece, tool, machine, setup, interference, options, 500.0 / 60.0);
  }
  [[nodiscard]] int touching(const OrientedPath& path) const {
    const Interference interference(scene, tool, nullptr, nullptr);
    int count = 0;
    for (const auto& point : path.tool_path.points) count += interference.is_free_but_tip(point.pose) ? 0 : 1;
    return count;
  }
};

geometry::TriangleMesh wall_beside_the_middle() { return testing::box(Vec3(40, 6, 0), Vec3(60, 12, 70)); }

TEST(Orient, WithoutObstaclesAStraightPassKeepsItsLean) {
  Strip strip({});
  const auto path = strip.orient(Smoothing::acceleration);
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_EQ(path->report.interferences_before, 0);
  EXPECT_EQ(path->tool_path.points.size(), strip.piece.points.size());
  for (const auto& point : path->tool_path.points) EXPECT_GT(point.pose.axis_P.dot(point.normal_P), std::cos(0.35));
}

TEST(Orient, EveryMethodDodgesTheWall) {
  Strip strip({wall_beside_the_middle()});
  for (const Smoothing smoothing :
       {Smoothing::none, Smoothing::velocity, Smoothing::acceleration, Smoothing::corridor}) {
    const auto path = strip.orient(smoothing);
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_GT(path->report.interferences_before, 10);
    EXPECT_EQ(strip.touching(*path), 0);
    if (smoothing != Smoothing::none) {
      EXPECT_EQ(path->report.interferences_after, 0);
    }
  }
}

TEST(Orient, SmoothingLowersThePeaks) {
  Strip strip({wall_beside_the_middle()});
  const auto traditional = strip.orient(Smoothing::none), velocity = strip.orient(Smoothing::velocity),
             acceleration = strip.orient(Smoothing::acceleration);
  ASSERT_TRUE(traditional && velocity && acceleration);
  EXPECT_LT(velocity->report.first.velocity_max, traditional->report.first.velocity_max);
  EXPECT_LT(acceleration->report.first.acceleration_max, traditional->report.first.acceleration_max);
  EXPECT_LT(acceleration->report.first.acceleration_max, velocity->report.first.acceleration_max);
}

TEST(Orient, NamesThePointsWhereNothingIsAllowed) {
  Strip strip({testing::box(Vec3(49, -20, 20), Vec3(51, 20, 90)), testing::box(Vec3(45, -3, 3.5), Vec3(55, 3, 15))});
  const auto path = strip.orient(Smoothing::acceleration);
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().code, "orientation-none");
  EXPECT_NE(path.error().message.find("obstacle"), std::string::npos) << path.error().message;
}

TEST(Orient, SameBytesWhateverTheThreads) {
  Strip strip({wall_beside_the_middle()});
  const auto with_threads = [&strip](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return strip.orient(Smoothing::acceleration);
  };
  const auto a = with_threads(1), b = with_threads(2);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->rotaries_rad, b->rotaries_rad);
}

TEST(CriticalPoints, AreFirstLastEnteringInsideLeaving) {
  std::vector<char> blocked(100, 0);
  for (std::size_t i = 40; i <= 60; ++i) blocked[i] = 1;
  EXPECT_EQ(critical_points(100, blocked_areas(blocked)), (std::vector<int>{0, 39, 50, 61, 99}));
}

}  // namespace
}  // namespace volute::planner
