#include "sim/controller/speed_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/controller/fastest_profile.hpp"
#include "tests/sim/controller/test_machines.hpp"

namespace volute::sim {
namespace {

using namespace test;

MotionLimits random_limits(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.3, 1.0);
  MotionLimits limits;
  for (std::size_t i = 0; i < limits.velocity.size(); ++i) {
    limits.velocity[i] = (i < 3 ? 200.0 : 2.0) * unit(random);
    limits.acceleration[i] = (i < 3 ? 2000.0 : 20.0) * unit(random);
  }
  return limits;
}

/// A wavy path through 25 points of all axes with corners of all sizes.
std::vector<PathCell> random_path(std::mt19937& random, const MotionLimits& limits, BlockInfo& block) {
  std::normal_distribution<double> normal(0.0, 1.0);
  CornerRounder rounder(limits, limits, AxisVector::Zero());
  std::vector<PathCell> cells;
  AxisVector q = AxisVector::Zero(), way = AxisVector::Zero();
  const double keep = std::uniform_real_distribution<double>(0.5, 0.97)(random);
  for (int k = 0; k < 25; ++k) {
    for (int i = 0; i < kinematics::axis_count; ++i)
      way[i] = keep * way[i] + (1.0 - keep) * normal(random) * (i < 3 ? 10.0 : 0.1);
    q += way;
    PathPoint point;
    point.q = q;
    point.length = way.head<3>().norm();
    point.tip_rates.leftCols<3>().setIdentity();
    point.corner_tolerance_mm = 0.5;
    point.block = &block;
    rounder.add(point, cells);
  }
  rounder.finish(cells);
  return cells;
}

double planned_time(const std::vector<PathCell>& cells, int look_ahead) {
  SpeedProfile profile(look_ahead);
  std::vector<TimedCell> timed;
  for (const PathCell& cell : cells) profile.add_block({cell}, timed);
  profile.finish(timed);
  double time_s = 0.0;
  for (const TimedCell& cell : timed)
    for (int i = 0; i < cell.phase_count; ++i) {
      const Phase& phase = cell.phases[static_cast<std::size_t>(i)];
      time_s += 2.0 * (phase.to - phase.from) / (phase.speed_from + phase.speed_to);
    }
  return time_s;
}

// Property 2, against a convex program on a grid 2 to 25 times as fine, solved by an interior-point method.
TEST(SpeedProfile, IsWithinTwoPercentOfTheFastest) {
  const unsigned seed = 801;
  std::mt19937 random(seed);
  double worst = 0.0;
  for (int k = 0; k < cases(20); ++k) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " case " + std::to_string(k));
    BlockInfo block;
    const MotionLimits limits = random_limits(random);
    const auto cells = random_path(random, limits, block);
    const double fastest_s = fastest_time(cells, 2, 25);
    const double time_s = planned_time(cells, 1000);
    EXPECT_LE(time_s, 1.02 * fastest_s);
    EXPECT_GE(time_s, 0.995 * fastest_s);
    worst = std::max(worst, time_s / fastest_s);
  }
  RecordProperty("worst_ratio", std::to_string(worst));
  std::printf("slowest against the optimum: %.5f\n", worst);
}

// Property 3.
TEST(SpeedProfile, MoreLookAheadIsNeverSlower) {
  std::mt19937 random(802);
  for (int k = 0; k < cases(50); ++k) {
    BlockInfo block;
    const MotionLimits limits = random_limits(random);
    const auto cells = random_path(random, limits, block);
    double before = no_limit;
    for (const int look_ahead : {1, 4, 16, 64}) {
      const double time_s = planned_time(cells, look_ahead);
      EXPECT_LE(time_s, before * (1.0 + 1e-12)) << "seed 802 case " << k << " look-ahead " << look_ahead;
      before = time_s;
    }
  }
}

// A straight line from rest to rest: the trapezoid of school.
TEST(SpeedProfile, StraightLineIsTheTrapezoid) {
  BlockInfo block;
  MotionLimits limits;
  limits.velocity.fill(100.0);
  limits.acceleration.fill(500.0);
  CornerRounder rounder(limits, limits, AxisVector::Zero());
  std::vector<PathCell> cells;
  PathPoint point;
  point.q[0] = 30.0;
  point.q[1] = 40.0;
  point.length = 50.0;
  point.speed_max = 80.0;
  point.block = &block;
  rounder.add(point, cells);
  rounder.finish(cells);
  const double acceleration = 500.0 / 0.8;
  EXPECT_NEAR(planned_time(cells, 10), 50.0 / 80.0 + 80.0 / acceleration, 1e-12);
}

}  // namespace
}  // namespace volute::sim
