// Five axes together: what stays on the path, what the report says, what the servo leaves behind.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/number_text.hpp"
#include "tests/sim/controller/test_machines.hpp"

namespace volute::sim {
namespace {

using namespace test;

double rounded(double value, int decimals) { return *geometry::parse_number(geometry::fixed_text(value, decimals)); }

/// A spiral over a wavy surface with tilting tool, its words rounded as a post rounds them.
std::vector<MotionBlock> finishing_program(int blocks, double step_mm, double feed_mm_s) {
  std::vector<MotionBlock> program;
  double phi = 0.0;
  for (int k = 0; k < blocks; ++k) {
    const double r = 30.0 - 5.0 * k / blocks;
    phi += step_mm / r;
    const double x = r * std::cos(phi), y = r * std::sin(phi), z = 4.0 * std::cos(x / 10.0) * std::cos(y / 12.0);
    const double a = 20.0 + 10.0 * std::sin(x / 15.0), c = phi / degree + 12.0 * std::sin(y / 10.0);
    program.push_back(line_to({rounded(x, 3), rounded(y, 3), rounded(z, 3)}, feed_mm_s, rounded(a, 4) * degree,
                              rounded(c, 4) * degree, true));
    program.back().spindle_on = true;
  }
  return program;
}

double distance_to(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 way = b - a;
  const double share = way.squaredNorm() > 0.0 ? std::clamp(way.dot(p - a) / way.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - a - share * way).norm();
}

/// The greatest distance of the tip from the programmed polygon; the search moves along with the samples.
double greatest_stray(const kinematics::Machine& machine, const std::vector<MotionBlock>& blocks,
                      const std::vector<AxisSample>& samples) {
  double greatest = 0.0;
  std::size_t near = 1;
  for (const AxisSample& sample : samples) {
    if (sample.line < 2) continue;
    const Vec3 tip = kinematics::tool_pose(machine, {}, 100.0, sample.position).tip_P_mm;
    double best = 1e9;
    std::size_t best_at = near;
    for (std::size_t k = near > 12 ? near - 12 : 1; k < std::min(blocks.size(), near + 12); ++k) {
      const double d = distance_to(blocks[k - 1].xyz_mm, blocks[k].xyz_mm, tip);
      if (d < best) best = d, best_at = k;
    }
    near = best_at;
    greatest = std::max(greatest, best);
  }
  return greatest;
}

void expect_tip_on_path(const kinematics::Machine& machine) {
  const auto control = plain_control();
  for (const double feed : {5.0, 40.0}) {
    const auto blocks = finishing_program(800, 0.3, feed);
    const Ran run = run_blocks(machine, control, blocks);
    EXPECT_LE(greatest_stray(machine, blocks, run.samples), 1.05 * control.corner_tolerance_mm) << "feed " << feed;
  }
}

TEST(FiveAxis, TipStaysWithinToleranceOnAHead) { expect_tip_on_path(head_machine()); }
TEST(FiveAxis, TipStaysWithinToleranceOnATable) { expect_tip_on_path(table_machine()); }

// Blocks of 0.3 mm at 250 mm/min: the axes have time, so next to nothing is lost ([Sun2016] Table 2 reports 0.37 %).
TEST(FiveAxis, ShortBlocksRunAtTheProgrammedFeed) {
  const Ran run = run_blocks(head_machine(), plain_control(), finishing_program(3000, 0.3, 250.0 / 60.0));
  EXPECT_NEAR(run.report.programmed_feed_mm_s, 250.0 / 60.0, 1e-9);
  EXPECT_LE(run.report.feed_loss_percent, 0.0);
  EXPECT_GE(run.report.feed_loss_percent, -0.37);
}

TEST(FiveAxis, StraightTcpBlockKeepsTheTipStraightWhileTheToolTurns) {
  const auto machine = table_machine();
  const std::vector<MotionBlock> blocks{line_to({0, 0, 0}, 20, 0, 0, true), line_to({30, 10, -5}, 20, 0.6, 1.2, true)};
  const Ran run = run_blocks(machine, plain_control(), blocks);
  double off = 0.0;
  for (const AxisSample& sample : run.samples)
    if (sample.line == 2)
      off = std::max(off, distance_to({0, 0, 0}, {30, 10, -5},
                                      kinematics::tool_pose(machine, {}, 100.0, sample.position).tip_P_mm));
  EXPECT_LE(off, 0.0105);
  EXPECT_NEAR(run.samples.back().position[3], 0.6, 1e-9);
  EXPECT_NEAR(run.samples.back().position[4], 1.2, 1e-9);
}

// A rapid under TCP keeps the tip on its line too, and is as quick about it as a feed move whose F asks for everything.
TEST(FiveAxis, ARapidThatTurnsTheToolIsNoSlowerThanTheSameFeedMove) {
  const auto machine = head_machine();
  double time_s[2];
  for (const bool rapid : {true, false}) {
    auto blocks = std::vector<MotionBlock>{
        line_to({40, 0, 30}, machine.rapid_mm_s > 0.0 ? machine.rapid_mm_s : 300.0, -1.2, -1.4, true),
        line_to({-40, 5, 30}, 300.0, -1.2, 1.5, true)};
    for (MotionBlock& block : blocks) block.kind = rapid ? MotionKind::rapid : MotionKind::line;
    const Ran run = run_blocks(machine, plain_control(), blocks);
    time_s[rapid ? 0 : 1] = run.report.cycle_time_s;
  }
  EXPECT_LT(time_s[0], 1.02 * time_s[1]);
  EXPECT_GT(time_s[0], 0.5 * time_s[1]);
}

TEST(FiveAxis, VectorsTurnOnTheGreatCircle) {
  const auto machine = head_machine();
  auto control = plain_control();
  control.orientation_interpolation = kinematics::OrientationInterpolation::great_circle;
  const Vec3 from = Vec3(0.3, -0.2, 1).normalized(), to = Vec3(-0.4, -0.5, 1).normalized();
  std::vector<MotionBlock> blocks{line_to({0, 0, 0}, 20, 0, 0, true), line_to({5, 0, 0}, 20, 0, 0, true)};
  blocks[0].axis_vector = from;
  blocks[1].axis_vector = to;
  const Ran run = run_blocks(machine, control, blocks);
  const Vec3 normal = from.cross(to).normalized();
  double off = 0.0;
  for (const AxisSample& sample : run.samples)
    if (sample.line == 2)
      off = std::max(off, std::abs(kinematics::tool_pose(machine, {}, 100.0, sample.position).axis_P.dot(normal)));
  EXPECT_LE(off, 2e-3);
  EXPECT_LE((kinematics::tool_pose(machine, {}, 100.0, run.samples.back().position).axis_P - to).norm(), 1e-9);
}

/// How far the tool axis leaves the great circle between the ends of the second block.
double off_great_circle(const kinematics::Control& control, const std::vector<MotionBlock>& blocks, AxisVector& end) {
  const auto machine = head_machine();
  const Ran run = run_blocks(machine, control, blocks);
  const auto axis_at = [&](const AxisVector& q) { return kinematics::tool_pose(machine, {}, 100.0, q).axis_P; };
  Vec3 from = Vec3::UnitZ();
  for (const AxisSample& sample : run.samples)
    if (sample.line == 1) from = axis_at(sample.position);
  end = run.samples.back().position;
  const Vec3 normal = from.cross(axis_at(end)).normalized();
  double off = 0.0;
  for (const AxisSample& sample : run.samples)
    if (sample.line == 2) off = std::max(off, std::abs(axis_at(sample.position).dot(normal)));
  return off;
}

// ORIVECT and ORIAXES, PATHCTRL VECTOR and AXIS: what the program says wins over what the control does by itself.
TEST(FiveAxis, TheProgramsOwnInterpolationWins) {
  using kinematics::OrientationInterpolation;
  kinematics::Control axes = plain_control(), circle = plain_control();
  circle.orientation_interpolation = OrientationInterpolation::great_circle;
  std::vector<MotionBlock> words{line_to({0, 0, 0}, 20, 0.5, 0.2, true), line_to({5, 0, 0}, 20, 0.4, 1.4, true)};
  for (MotionBlock& block : words) block.path_mode = PathMode::exact_stop;
  AxisVector end;
  EXPECT_GT(off_great_circle(axes, words, end), 0.03);
  for (MotionBlock& block : words) block.orientation_interpolation = OrientationInterpolation::great_circle;
  EXPECT_LT(off_great_circle(axes, words, end), 2e-3);
  EXPECT_NEAR(end[3], 0.4, 1e-9);
  EXPECT_NEAR(end[4], 1.4, 1e-9);
  std::vector<MotionBlock> vectors = words;
  const auto machine = head_machine();
  for (MotionBlock& block : vectors) {
    AxisVector q = AxisVector::Zero();
    q.tail<2>() = Eigen::Vector2d(block.rotary_rad[0], block.rotary_rad[1]);
    block.axis_vector = kinematics::tool_pose(machine, {}, 100.0, q).axis_P;
  }
  EXPECT_LT(off_great_circle(axes, vectors, end), 2e-3);
  for (MotionBlock& block : vectors) block.orientation_interpolation = OrientationInterpolation::axes;
  EXPECT_GT(off_great_circle(circle, vectors, end), 0.03);
}

TEST(FiveAxis, VectorThatNoRotaryReachesIsRefused) {
  auto machine = head_machine();
  machine.axes[4].direction_M = Vec3(0, 0.6, 0.8);  // a head whose C line leans: not every direction is within reach
  machine.axes[3].direction_M = Vec3(0, 0.8, 0.6);
  auto blocks = std::vector<MotionBlock>{line_to({0, 0, 0}, 20, 0, 0, true)};
  blocks[0].axis_vector = -Vec3::UnitZ();
  blocks[0].line = 17;
  const auto control = plain_control();
  ControlSetup setup;
  setup.machine = &machine;
  setup.control = &control;
  setup.tool_length_mm = 100.0;
  const auto report = run_motions(source_of(blocks), setup, {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, "pose-unreachable");
  EXPECT_NE(report.error().message.find("line 17"), std::string::npos);
}

TEST(FiveAxis, CausesAddUpToTheCycleTime) {
  auto blocks = finishing_program(300, 0.3, 20.0);
  blocks[100].kind = MotionKind::rapid;
  blocks[200].kind = MotionKind::dwell;
  blocks[200].dwell_s = 0.25;
  const Ran run = run_blocks(head_machine(), plain_control(), blocks);
  double sum = 0.0;
  for (const auto& [cause, time_s] : run.report.time_by_cause_s) sum += time_s;
  EXPECT_NEAR(sum, run.report.cycle_time_s, 0.01);
  EXPECT_NEAR(run.report.time_by_cause_s.at("dwell"), 0.25, 1e-9);
  EXPECT_EQ(run.report.samples, static_cast<std::int64_t>(run.samples.size()));
  EXPECT_EQ(run.report.blocks, 300);
  EXPECT_LE(run.report.worst_blocks.size(), 20U);
}

// A control that cannot run a block in less than 10 ms: 0.1 mm blocks go at 10 mm/s at most.
TEST(FiveAxis, LeastBlockTimeCapsTheFeed) {
  auto control = plain_control();
  control.least_block_time_s = 0.01;
  const Ran run = run_blocks(head_machine(), control, finishing_program(1000, 0.1, 50.0));
  double fastest = 0.0;
  for (const AxisSample& sample : run.samples)
    if (sample.line > 3) fastest = std::max(fastest, sample.tip_speed_mm_s);
  EXPECT_LE(fastest, 10.6);  // the waves make blocks a little longer than 0.1 mm
  EXPECT_GE(fastest, 9.0);
  EXPECT_GT(run.report.time_by_cause_s.at("block_time"), 0.5 * run.report.cycle_time_s);
}

// Following error of a ramp: (1 - f) v / Kv.
TEST(FiveAxis, ServoLagsByVelocityOverGain) {
  auto machine = head_machine();
  machine.axes[0].position_gain_per_s = 25.0;
  machine.axes[0].velocity_feed_forward = 0.6;
  auto control = plain_control();
  Ran run = run_blocks(machine, control, {line_to({100, 0, 0}, 50)});
  EXPECT_NEAR(run.report.axes[0].following_error_max, 0.4 * 50.0 / 25.0, 1e-6);
  EXPECT_NEAR(run.report.contour_error_max_mm, 0.0, 1e-9);  // one axis alone lags along the path
  control.feed_forward = false;
  run = run_blocks(machine, control, {line_to({100, 0, 0}, 50)});
  EXPECT_NEAR(run.report.axes[0].following_error_max, 50.0 / 25.0, 1e-6);
  // X lags by 1.2 mm (60 mm/s at Kv 25, f 0.6 -> 0.96), Y not at all: the tip leaves the diagonal by 0.96 sin 45.
  control.feed_forward = true;
  run = run_blocks(machine, control, {line_to({100, 100, 0}, 60 * std::sqrt(2.0))});
  EXPECT_NEAR(run.report.contour_error_max_mm, 0.4 * 60.0 / 25.0 * std::sqrt(0.5), 2e-3);
}

TEST(FiveAxis, LeavingTheTravelIsReportedOnceForEachEnd) {
  auto machine = head_machine();
  machine.axes[0].travel_max = 40.0;
  machine.axes[0].travel_min = -10.0;
  const Ran run =
      run_blocks(machine, plain_control(),
                 {line_to({50, 0, 0}, 50), line_to({0, 0, 0}, 50), line_to({60, 0, 0}, 50), line_to({-20, 9, 0}, 50)});
  ASSERT_EQ(run.report.out_of_travel.size(), 2U);
  const TravelExcess &high = run.report.out_of_travel[0], &low = run.report.out_of_travel[1];
  EXPECT_EQ(high.first_line, 1);
  EXPECT_EQ(high.axis, 0);
  EXPECT_EQ(high.limit, 40.0);
  EXPECT_EQ(high.times, 2);
  EXPECT_NEAR(high.farthest, 60.0, 0.02);
  EXPECT_GE(high.farthest_line, 3);
  EXPECT_EQ(low.limit, -10.0);
  EXPECT_EQ(low.times, 1);
  EXPECT_EQ(low.first_line, 4);
  EXPECT_NEAR(low.farthest, -20.0, 0.02);
  EXPECT_EQ(run.report.axes[0].position_max, high.farthest);
}

TEST(FiveAxis, SameProgramGivesTheSameSamples) {
  const auto blocks = finishing_program(200, 0.2, 30.0);
  const Ran one = run_blocks(table_machine(), plain_control(), blocks),
            two = run_blocks(table_machine(), plain_control(), blocks);
  ASSERT_EQ(one.samples.size(), two.samples.size());
  for (std::size_t k = 0; k < one.samples.size(); ++k) EXPECT_EQ(one.samples[k].position, two.samples[k].position);
}

}  // namespace
}  // namespace volute::sim
