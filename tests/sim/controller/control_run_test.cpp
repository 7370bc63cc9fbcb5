#include "sim/controller/control_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/controller/test_machines.hpp"

namespace volute::sim {
namespace {

using namespace test;

/// The greatest ratio of sampled differences to limits, taken from positions alone.
double sampled_ratio(const kinematics::Machine& machine, const std::vector<AxisSample>& samples, double dt) {
  double ratio = 0.0;
  for (std::size_t k = 3; k < samples.size(); ++k)
    for (int i = 0; i < kinematics::axis_count; ++i) {
      const auto& axis = machine.axes[static_cast<std::size_t>(i)];
      const double a = samples[k].position[i], b = samples[k - 1].position[i], c = samples[k - 2].position[i],
                   d = samples[k - 3].position[i];
      ratio = std::max({ratio, std::abs(a - b) / dt / axis.velocity_max,
                        std::abs((a - b) - (b - c)) / dt / dt / axis.acceleration_max});
      ratio = std::max(ratio, std::abs((a - b) - 2 * (b - c) + (c - d)) / dt / dt / dt / axis.jerk_max);
    }
  return ratio;
}

TEST(ControlRun, StraightLineTakesTheClosedFormTime) {
  const auto machine = head_machine();
  const auto control = plain_control();
  const Ran run = run_blocks(machine, control, {line_to({100, 0, 0}, 50)});
  const double a = machine.axes[0].jerk_max;
  // Averaged trapezoid: length / F + F / a + T, with a = j T / 2 and T^3 = 24 e / j rounded up to whole cycles.
  const double T = std::ceil(std::cbrt(24 * 0.01 / 60000) / 0.001) * 0.001;
  const double acceleration = std::min(3000.0, 0.5 * a * T);
  EXPECT_NEAR(run.report.cycle_time_s, 100.0 / 50 + 50 / acceleration + T, 0.0021);
  EXPECT_NEAR(run.samples.back().position[0], 100.0, 1e-9);
  EXPECT_NEAR(run.report.axes[0].velocity_max, 50.0, 1e-9);
  EXPECT_LE(run.report.axes[0].limit_ratio_max, 1.0);
}

TEST(ControlRun, CornerStaysWithinTolerance) {
  const auto machine = head_machine();
  const auto control = plain_control();
  const Ran run =
      run_blocks(machine, control, {line_to({20, 0, 0}, 50), line_to({20, 20, 0}, 50), line_to({0, 0, 0}, 50)});
  double nearest = 1e9, off = 0.0;
  for (const AxisSample& sample : run.samples) {
    const Vec3 p = sample.position.head<3>() - kinematics::program_zero(machine, {}, 100.0).head<3>();
    nearest = std::min(nearest, (p - Vec3(20, 0, 0)).norm());
    const double sides = std::min({std::abs(p.y()), std::abs(p.x() - 20), std::abs(p.x() - p.y()) / std::sqrt(2.0)});
    off = std::max(off, sides);
  }
  EXPECT_LE(nearest, 0.0105);
  EXPECT_GE(nearest, 0.002);  // the corner is rounded, not stopped at
  EXPECT_LE(off, 0.01);
  EXPECT_GT(run.report.time_by_cause_s.at("corner"), 0.0);
}

/// Blocks of every kind and size, in axes or under TCP.
std::vector<MotionBlock> random_program(std::mt19937& random, bool tcp) {
  std::uniform_real_distribution<double> unit(-1, 1), positive(0, 1);
  std::vector<MotionBlock> blocks;
  Vec3 at(0, 0, 0);
  double a = 0, c = 0;
  double size = 1.0;
  for (int k = 0; k < 100; ++k) {
    if (positive(random) < 0.2) size = std::pow(10.0, 2.5 * positive(random) - 1.0);
    at += size * Vec3(unit(random), unit(random), unit(random));
    if (positive(random) < 0.6)
      a = std::clamp(a + 0.02 * size * unit(random), -1.2, 1.2), c += 0.04 * size * unit(random);
    MotionBlock block = line_to(at, 5 + 200 * positive(random), a, c, tcp);
    const double kind = positive(random);
    if (kind < 0.08) block.kind = MotionKind::rapid;
    if (kind > 0.95) block.kind = MotionKind::dwell, block.dwell_s = 0.02;
    if (kind > 0.5 && kind < 0.6) block.path_mode = PathMode::exact_stop;
    if (kind > 0.6 && kind < 0.65) block.path_mode = PathMode::exact_path;
    if (kind > 0.65 && kind < 0.75)
      block.feed_mode = FeedMode::inverse_time, block.feed = 1.0 / (0.01 + positive(random));
    if (kind > 0.75 && kind < 0.85) block.path_tolerance_mm = 0.1 * positive(random), block.rotary_tolerance_rad = 0.01;
    blocks.push_back(block);
  }
  return blocks;
}

/// Short blocks with axis vectors that wander about the pole and through it.
std::vector<MotionBlock> vector_program(std::mt19937& random) {
  std::normal_distribution<double> normal(0, 1);
  std::vector<MotionBlock> blocks;
  Vec3 at(0, 0, 0), lean(0, 0, 0);
  for (int k = 0; k < 60; ++k) {
    at += 0.7 * Vec3(normal(random), normal(random), normal(random));
    lean = 0.9 * lean + 0.02 * Vec3(normal(random), normal(random), 0);
    if (k % 20 == 10) lean.setZero();
    MotionBlock block = line_to(at, 30, 0, 0, true);
    block.axis_vector = (Vec3::UnitZ() + lean).normalized();
    blocks.push_back(block);
  }
  return blocks;
}

void expect_limits_held(const kinematics::Machine& machine, unsigned seed) {
  std::mt19937 random(seed);
  double worst = 0.0;
  for (int k = 0; k < cases(30); ++k) {
    kinematics::Control control = plain_control();
    control.look_ahead_blocks = k % 3 == 0 ? 5 : 100;
    control.servo_period_s = k % 4 == 0 ? 0.002 : 0.001;
    control.least_block_time_s = k % 5 == 0 ? 0.004 : 0.0;
    const Ran run = run_blocks(machine, control, random_program(random, k % 2 == 0));
    const double ratio = sampled_ratio(machine, run.samples, control.servo_period_s);
    EXPECT_LE(ratio, 1.0 + 1e-9) << "seed " << seed << " case " << k;
    for (const AxisPeaks& peaks : run.report.axes)
      EXPECT_LE(peaks.limit_ratio_max, 1.0 + 1e-9) << "seed " << seed << " case " << k;
    worst = std::max(worst, ratio);
  }
  EXPECT_GT(worst, 0.99) << "no program came near a limit: the property was not tried";
}

TEST(ControlRun, VectorsAboutThePoleKeepEveryLimit) {
  std::mt19937 random(603);
  for (int k = 0; k < cases(8); ++k) {
    kinematics::Control control = plain_control();
    if (k % 2 == 0) control.orientation_interpolation = kinematics::OrientationInterpolation::great_circle;
    const auto machine = k % 4 < 2 ? head_machine() : table_machine();
    const auto blocks = vector_program(random);
    const Ran run = run_blocks(machine, control, blocks);
    EXPECT_LE(sampled_ratio(machine, run.samples, control.servo_period_s), 1.0 + 1e-9) << "seed 603 case " << k;
    const Vec3 axis = kinematics::tool_pose(machine, {}, 100.0, run.samples.back().position).axis_P;
    EXPECT_LE((axis - *blocks.back().axis_vector).norm(), 1e-9) << "seed 603 case " << k;
  }
}

TEST(ControlRun, RandomProgramsKeepEveryLimitOfAHead) { expect_limits_held(head_machine(), 601); }
TEST(ControlRun, RandomProgramsKeepEveryLimitOfATable) { expect_limits_held(table_machine(), 602); }

}  // namespace
}  // namespace volute::sim
