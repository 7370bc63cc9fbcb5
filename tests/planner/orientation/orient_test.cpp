#include "planner/orientation/orient.hpp"

#include <array>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "planner/orientation/corridor.hpp"
#include "planner/orientation/exhaustive.hpp"
#include "planner/orientation/pin_loop.hpp"
#include "tests/cases.hpp"
#include "tests/planner/orientation/strip.hpp"

namespace volute::planner {
namespace {

using testing::AllowedStrip;
using testing::Strip;
using testing::wall_beside_the_middle;

/// Velocity, acceleration and jerk of both rotaries.
std::array<double, 6> peaks(const OrientationReport& report) {
  return {report.first.velocity_max,  report.first.acceleration_max,  report.first.jerk_max,
          report.second.velocity_max, report.second.acceleration_max, report.second.jerk_max};
}

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
  for (const Smoothing smoothing : {Smoothing::acceleration, Smoothing::corridor}) {
    const auto with_threads = [&](std::size_t threads) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      return strip.orient(smoothing);
    };
    const auto a = with_threads(1), b = with_threads(2);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->rotaries_rad, b->rotaries_rad);
  }
}

/// One to five boxes and posts (eight-sided) beside the pass, higher than the holder's face.
std::vector<geometry::TriangleMesh> random_obstacles(std::mt19937& random) {
  const auto uniform = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  std::vector<geometry::TriangleMesh> obstacles;
  const int count = std::uniform_int_distribution<int>(1, 5)(random);
  for (int k = 0; k < count; ++k) {
    const double side = uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0, gap = uniform(4.5, 14.0), x = uniform(5.0, 95.0);
    const double half_x = uniform(1.0, 10.0), deep = uniform(2.0, 10.0), height = uniform(30.0, 70.0);
    const double near = side * gap, far = side * (gap + deep);
    obstacles.push_back(
        testing::box(Vec3(x - half_x, std::min(near, far), -10.0), Vec3(x + half_x, std::max(near, far), height)));
  }
  return obstacles;
}

/// Ends with nothing touching and, in the corridor, no peak above those of `acceleration`; or names points at which the
/// exhaustive search finds nothing either, or says that no motion was found between points that all allow something.
TEST(Orient, RandomScenesEndFreeAndTheCorridorIsNeverAbove) {
  const unsigned seed = 77;
  std::mt19937 random(seed);
  for (int n = 0; n < cases(4); ++n) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " scene " + std::to_string(n));
    Strip strip(random_obstacles(random));
    const auto acceleration = strip.orient(Smoothing::acceleration), corridor = strip.orient(Smoothing::corridor);
    if (!corridor) {
      strip.options.smoothing = Smoothing::corridor;
      const AllowedStrip allowed(strip);
      const std::vector<Vec3> upright(allowed.stations.size(), Vec3::UnitZ());
      // Each message holds: points without an orientation, or none such and no motion between them.
      const bool empty = !stations_without_orientation(allowed.set, upright).empty();
      EXPECT_EQ(corridor.error().code, empty ? "orientation-none" : "orientation-unreached")
          << corridor.error().message;
      continue;
    }
    EXPECT_EQ(strip.touching(*corridor), 0);
    const AllowedStrip allowed(strip);
    const std::vector<char> bad = check_path(allowed.set, corridor->rotaries_rad, false);
    EXPECT_EQ(std::count(bad.begin(), bad.end(), 1), 0);
    if (!acceleration) continue;  // the loop of Fig. 8 may not end
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_LE(peaks(corridor->report)[k], peaks(acceleration->report)[k] * (1.0 + 1e-8) + 1e-6) << "peak " << k;
  }
}

TEST(Orient, KeysOfTheUserAreHeldByEveryMethod) {
  Strip strip({wall_beside_the_middle()});
  const std::vector<std::pair<double, Vec3>> keys = {{0.0, Vec3(0.05, -0.1, 1)},
                                                     {0.35, Vec3(0.05, -0.3, 1)},
                                                     {0.5, Vec3(0, -0.55, 1)},
                                                     {0.65, Vec3(0.05, -0.3, 1)},
                                                     {1.0, Vec3(0.05, -0.1, 1)}};
  for (const auto& [at, axis] : keys) strip.options.keys.push_back({at, {}, axis.normalized()});
  for (const Smoothing smoothing : {Smoothing::velocity, Smoothing::acceleration, Smoothing::corridor}) {
    const auto path = strip.orient(smoothing);
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(strip.touching(*path), 0);
    EXPECT_GE(path->report.pins, 5);
    const auto& points = path->tool_path.points;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      double turn = 10.0;  // the point nearest to the key's share of the length: within a step of it
      const auto i = static_cast<std::ptrdiff_t>(keys[k].first * 200.0);
      for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(i - 2, 0); j <= std::min<std::ptrdiff_t>(i + 2, 200); ++j)
        turn = std::min(turn, (points[static_cast<std::size_t>(j)].pose.axis_P - strip.options.keys[k].axis_P).norm());
      EXPECT_LT(turn, 1e-6) << "key " << k << " smoothing " << path->report.smoothing;
    }
  }
}

TEST(Orient, AKeyThatTouchesIsRefusedByName) {
  Strip strip({wall_beside_the_middle()});
  strip.options.keys = {{0.5, {}, Vec3(0.0, 0.3, 1.0).normalized()}};
  const auto path = strip.orient(Smoothing::acceleration);
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().code, "orientation-key-blocked");
  EXPECT_NE(path.error().message.find("CC point 101"), std::string::npos) << path.error().message;
}

/// The middle key stands at the pole: A is 0 there, and C goes straight from the first key's to the last one's.
TEST(Orient, AKeyAtThePoleFixesAAndLeavesCFree) {
  Strip strip({});
  const RotaryChart chart(strip.machine, strip.setup);
  strip.options.keys = {
      {0.0, {}, chart.axis_P({0.3, 0.2})}, {0.5, {}, Vec3::UnitZ()}, {1.0, {}, chart.axis_P({0.3, 0.8})}};
  for (const Smoothing smoothing : {Smoothing::velocity, Smoothing::acceleration}) {
    const auto path = strip.orient(smoothing);
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(path->report.pins, 3);
    const AllowedStrip allowed(strip);
    const auto& at = path->rotaries_rad;
    ASSERT_EQ(path->pins.size(), 3U);
    EXPECT_NEAR(at[static_cast<std::size_t>(path->pins[1])][0], 0.0, 1e-9);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double t = allowed.stations[i].s_mm / allowed.stations.back().s_mm;
      const double first = at.front()[1], last = at.back()[1];
      EXPECT_NEAR(at[i][1], first + t * (last - first), 1e-9) << i;
    }
    // Through the pole or back from it: either way C turns by no more than the keys ask for.
    EXPECT_LE(std::abs(at.back()[1] - at.front()[1]), 0.6 + 1e-9);
  }
}

TEST(Exhaustive, FindsTheOnlyWindow) {
  // Tilt limits leave a ring of half a degree: rings 2 degrees apart may miss it, rings half a degree apart do not.
  Strip strip({});
  strip.options.tilt_min = geometry::Angle::degrees(33.2);
  strip.options.tilt_max = geometry::Angle::degrees(33.75);
  const AllowedStrip allowed(strip);
  const auto axis = exhaustive_search(allowed.set, 100, exhaustive_step);
  ASSERT_TRUE(axis);
  EXPECT_EQ(allowed.set.blocked(100, *axis), Blocked::no);
  const std::vector<Vec3> upright(allowed.stations.size(), Vec3::UnitZ());
  EXPECT_TRUE(stations_without_orientation(allowed.set, upright).empty());
}

TEST(CriticalPoints, AreFirstLastEnteringInsideLeaving) {
  std::vector<char> blocked(100, 0);
  for (std::size_t i = 40; i <= 60; ++i) blocked[i] = 1;
  EXPECT_EQ(critical_points(100, blocked_areas(blocked)), (std::vector<int>{0, 39, 50, 61, 99}));
}

}  // namespace
}  // namespace volute::planner
