// What is kept of a run, and the forward chain that it is kept by.
#include "sim/run_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "kinematics/model/control.hpp"

namespace volute::sim {
namespace {

using kinematics::Machine;

std::vector<Machine> all_machines() {
  std::vector<Machine> out;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines")) {
    if (entry.path().extension() != ".toml") continue;
    auto machine = kinematics::load_machine(entry.path());
    if (machine) out.push_back(std::move(*machine));
  }
  return out;
}

AxisVector random_state(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  AxisVector q;
  for (int i = 0; i < kinematics::axis_count; ++i) q[i] = unit(random) * (i < 3 ? 400.0 : 6.0);
  return q;
}

TEST(ToolMotion, AgreesWithTheProductOfTheChainForEveryMachine) {
  constexpr unsigned seed = 71;
  std::mt19937_64 random(seed);
  const auto machines = all_machines();
  ASSERT_GE(machines.size(), 6u);
  for (const Machine& machine : machines) {
    kinematics::Setup setup;
    setup.part_in_machine =
        Eigen::Translation3d(31.0, -7.0, 120.0) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized());
    const ToolMotion motion(machine, setup, 137.5);
    for (int i = 0; i < 2000; ++i) {
      const AxisVector q = random_state(random);
      const auto pose = motion.pose_P(q), expected = kinematics::tool_pose(machine, setup, 137.5, q);
      ASSERT_LT((pose.tip_P_mm - expected.tip_P_mm).norm(), 1e-11) << machine.name << " seed " << seed << " case " << i;
      ASSERT_LT((pose.axis_P - expected.axis_P).norm(), 1e-14) << machine.name << " seed " << seed << " case " << i;
    }
  }
}

/// A wavy run of all axes, with rapids in between.
std::vector<AxisSample> wavy_run(std::size_t count) {
  std::vector<AxisSample> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    AxisSample& s = out[i];
    s.time_s = 0.001 * static_cast<double>(i);
    s.position << 40.0 * std::sin(s.time_s), 30.0 * std::cos(1.3 * s.time_s), 5.0 * s.time_s, 0.4 * std::sin(s.time_s),
        0.2 * s.time_s;
    s.velocity << 40.0 * std::cos(s.time_s), -39.0 * std::sin(1.3 * s.time_s), 5.0, 0.4 * std::cos(s.time_s), 0.2;
    s.acceleration = -s.position;
    s.jerk = -s.velocity;
    s.actual = s.position;
    s.line = static_cast<std::int64_t>(i / 100);
    s.rapid = i / 3000 % 4 == 3;
    s.cutting = !s.rapid;
  }
  return out;
}

TEST(RunWatch, MachiningTimeIsFromTheFirstFeedMoveToTheLastWithTheRapidsBetween) {
  const Machine machine = all_machines().front();
  const kinematics::Setup setup;
  const kinematics::Tool tool;
  std::vector<AxisSample> run = wavy_run(10'000);  // rapid from 9.000 s on
  for (std::size_t i = 0; i < 1700; ++i) run[i].cutting = false;
  for (std::size_t portion : {1U, 777U, 20'000U}) {
    RunWatch watch(machine, setup, tool, {});
    for (std::size_t i = 0; i < run.size(); i += portion)
      watch.add(std::span(run).subspan(i, std::min(portion, run.size() - i)));
    watch.finish();
    ASSERT_TRUE(watch.machining_time_s());
    EXPECT_NEAR(*watch.machining_time_s(), 8.999 - 1.7, 1e-12) << portion;
  }
  for (AxisSample& sample : run) sample.cutting = false;
  RunWatch air(machine, setup, tool, {});
  air.add(run);
  air.finish();
  EXPECT_FALSE(air.machining_time_s()) << "nothing but rapids";
}

TEST(LimitPeaks, SayWhereAnAxisPassedWhichLimit) {
  const Machine machine = all_machines().front();
  LimitPeaks peaks(machine);
  std::vector<AxisSample> run = wavy_run(5000);
  run[1234].acceleration[2] = -1.25 * machine.axes[2].acceleration_max;
  run[1235].acceleration[2] = 1.25 * machine.axes[2].acceleration_max;  // as much: the first one counts
  run[4321].velocity[4] = 1.5 * machine.axes[4].velocity_max;
  run[777].jerk[4] = 3.0 * machine.axes[4].jerk_max;
  const std::span<const AxisSample> samples(run);
  peaks.add(samples.first(1234));
  peaks.add(samples.subspan(1234));
  const LimitPeak z = peaks.nearest_to(2, 1.25), c = peaks.nearest_to(4, 1.5), jerk = peaks.nearest_to(4, 3.0);
  EXPECT_STREQ(z.quantity, "acceleration");
  EXPECT_EQ(z.line, 12);
  EXPECT_DOUBLE_EQ(z.time_s, 1.234);
  EXPECT_NEAR(z.ratio, 1.25, 1e-12);
  EXPECT_STREQ(c.quantity, "velocity");  // a control that leaves the jerk alone has 1.5 as its greatest ratio
  EXPECT_EQ(c.line, 43);
  EXPECT_STREQ(jerk.quantity, "jerk");
  EXPECT_EQ(jerk.line, 7);
}

struct Kept {
  std::vector<SweptPose> moves;
  std::vector<MachineState> states;
  std::vector<AxisSample> trace;
  LoadsReport loads;
};

Kept watched(const Machine& machine, const std::vector<AxisSample>& samples, std::size_t portion) {
  const kinematics::Setup setup;
  kinematics::Tool tool;
  tool.cutter.length_mm = 20.0;
  RunWatch watch(machine, setup, tool, {0.0005, 0.005, 1000});
  for (std::size_t i = 0; i < samples.size(); i += portion)
    watch.add(std::span(samples).subspan(i, std::min(portion, samples.size() - i)));
  watch.finish();
  return {watch.moves(), watch.states(), watch.trace(), watch.loads()};
}

TEST(RunWatch, KeepsTheSameHoweverTheSamplesComeIn) {
  const auto machines = all_machines();
  const auto samples = wavy_run(20011);  // not a whole number of lots
  const Kept whole = watched(machines.front(), samples, samples.size());
  EXPECT_GT(whole.moves.size(), 200u);
  EXPECT_EQ(whole.moves.back().time_s, samples.back().time_s);
  EXPECT_EQ(whole.states.back().time_s, samples.back().time_s);
  EXPECT_EQ(whole.trace.back().time_s, samples.back().time_s);
  for (const std::size_t portion : {1u, 64u, 4097u}) {
    const Kept parts = watched(machines.front(), samples, portion);
    ASSERT_EQ(parts.moves.size(), whole.moves.size());
    for (std::size_t i = 0; i < parts.moves.size(); ++i) {
      ASSERT_EQ(parts.moves[i].time_s, whole.moves[i].time_s);
      ASSERT_EQ(parts.moves[i].pose.tip_P_mm, whole.moves[i].pose.tip_P_mm);
    }
    ASSERT_EQ(parts.states.size(), whole.states.size());
    for (std::size_t i = 0; i < parts.states.size(); ++i) ASSERT_EQ(parts.states[i].q, whole.states[i].q);
    ASSERT_EQ(parts.trace.size(), whole.trace.size());
    for (std::size_t i = 0; i < parts.loads.axes.size(); ++i) {
      EXPECT_EQ(parts.loads.axes[i].peak, whole.loads.axes[i].peak);
      EXPECT_EQ(parts.loads.axes[i].rms, whole.loads.axes[i].rms);
    }
  }
}

}  // namespace
}  // namespace volute::sim
