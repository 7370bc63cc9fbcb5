// What the control file's acceleration_profile means.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/controller/ring.hpp"
#include "tests/sim/controller/test_machines.hpp"

namespace volute::sim {
namespace {

using namespace test;

kinematics::Control trapezoid_control() {
  kinematics::Control control = plain_control();
  control.acceleration_profile = kinematics::AccelerationProfile::trapezoid;
  return control;
}

// The trapezoid of school: length / F + F / a, with all of the axis's acceleration at once.
TEST(AccelerationProfile, TrapezoidTakesTheClosedFormTime) {
  const auto machine = head_machine();
  const Ran run = run_blocks(machine, trapezoid_control(), {line_to({100, 0, 0}, 50)});
  EXPECT_NEAR(run.report.cycle_time_s, 100.0 / 50 + 50.0 / 3000.0, 0.0021);
  EXPECT_NEAR(run.report.axes[0].acceleration_max, 3000.0, 1.0);
  EXPECT_LE(run.report.axes[0].limit_ratio_max, 1.0 + 1e-9);
}

// It limits no jerk, and says so; the s-curve holds it, and takes longer.
TEST(AccelerationProfile, OnlyTheSCurveHoldsJerk) {
  const std::vector<MotionBlock> blocks{line_to({60, 0, 0}, 80), line_to({60, 40, 0}, 80), line_to({0, 0, 5}, 80)};
  const Ran steps = run_blocks(head_machine(), trapezoid_control(), blocks),
            smooth = run_blocks(head_machine(), plain_control(), blocks);
  EXPECT_GT(steps.report.axes[0].jerk_max, 10.0 * 60000);
  ASSERT_FALSE(steps.report.warnings.empty());
  EXPECT_NE(steps.report.warnings[0].find("limits no jerk: axis X"), std::string::npos);
  EXPECT_LE(smooth.report.axes[0].jerk_max, 60000 * (1 + 1e-9));
  EXPECT_TRUE(smooth.report.warnings.empty());
  EXPECT_LT(steps.report.cycle_time_s, smooth.report.cycle_time_s);
}

// A filter after interpolation bounds the trapezoid's jerk by 2 a / T.
TEST(AccelerationProfile, AFilterRoundsTheTrapezoid) {
  kinematics::Control control = trapezoid_control();
  control.filter_time_s = 0.02;
  const Ran run = run_blocks(head_machine(), control, {line_to({60, 0, 0}, 80), line_to({0, 0, 0}, 80)});
  EXPECT_LE(run.report.axes[0].jerk_max, 2.0 * 3000.0 / 0.02 * (1 + 1e-9));
  EXPECT_LE(run.report.axes[0].limit_ratio_max, 1.0 + 1e-9);
}

TEST(AccelerationProfile, TrapezoidsKeepVelocityAndAcceleration) {
  std::mt19937 random(612);
  std::uniform_real_distribution<double> unit(-1, 1), positive(0, 1);
  for (int k = 0; k < cases(20); ++k) {
    std::vector<MotionBlock> blocks;
    Vec3 at(0, 0, 0);
    double a = 0.0, c = 0.0;
    for (int i = 0; i < 100; ++i) {
      at += std::pow(10.0, positive(random)) * Vec3(unit(random), unit(random), unit(random));
      a = std::clamp(a + 0.1 * unit(random), -1.2, 1.2);
      c += 0.2 * unit(random);
      blocks.push_back(line_to(at, 5 + 200 * positive(random), a, c, k % 2 == 0));
    }
    const Ran run = run_blocks(k % 4 < 2 ? head_machine() : table_machine(), trapezoid_control(), blocks);
    for (const AxisPeaks& peaks : run.report.axes)
      EXPECT_LE(peaks.limit_ratio_max, 1.0 + 1e-9) << "seed 612 case " << k;
  }
}

TEST(Ring, GivesBackInOrderWhileItGrows) {
  Ring<int> ring;
  int in = 0, out = 0;
  for (int round = 1; round < 60; ++round) {
    for (int k = 0; k < round; ++k) ring.put() = in++;
    for (int k = 0; k < round / 2; ++k) {
      ASSERT_EQ(ring.front(), out++);
      ring.drop_front();
    }
    ASSERT_EQ(ring.size(), static_cast<std::size_t>(in - out));
    ASSERT_EQ(ring.back(), in - 1);
    ASSERT_EQ(ring[0], out);
  }
}

}  // namespace
}  // namespace volute::sim
