// The virtual control against real time: how many seconds of machining one second of one core simulates.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <numbers>

#include "sim/controller/control_run.hpp"

namespace {

using namespace volute;
using namespace volute::sim;

kinematics::Machine machine() {
  kinematics::Machine machine;
  machine.name = "bench-head";
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    kinematics::Axis& axis = machine.axes[i];
    const bool rotary = i >= 3;
    axis.letter = "XYZAC"[i];
    axis.kind = rotary ? kinematics::AxisKind::rotary : kinematics::AxisKind::linear;
    axis.direction_M = i == 1 ? Vec3::UnitY() : i == 2 || i == 4 ? Vec3::UnitZ() : Vec3::UnitX();
    axis.point_M_mm = rotary ? Vec3(0, 0, 250) : Vec3(Vec3::Zero());
    axis.velocity_max = rotary ? 3.14 : 333;
    axis.acceleration_max = rotary ? 10 : 3000;
    axis.jerk_max = rotary ? 100 : 30000;
    axis.position_gain_per_s = 33.3;
    axis.velocity_feed_forward = 1.0;
  }
  machine.chain = {0, 1, 2, 4, 3};
  return machine;
}

/// What every run has: that head, an S-curve control, a tool of 100 mm.
struct Bench {
  kinematics::Machine head = machine();
  kinematics::Control control;
  ControlSetup setup;

  Bench() {
    control.acceleration_profile = kinematics::AccelerationProfile::s_curve;
    setup.machine = &head;
    setup.control = &control;
    setup.tool_length_mm = 100.0;
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;
};

/// A five-axis spiral under TCP, `blocks` of `step_mm` at `feed_mm_s`.
MotionSource spiral(std::int64_t blocks, double step_mm, double feed_mm_s) {
  return [=, phi = 0.0, k = std::int64_t{0}, block = MotionBlock()]() mutable -> Result<std::optional<MotionBlock>> {
    if (k == blocks) return std::optional<MotionBlock>();
    const double r = 25.0 + 15.0 * std::cos(phi / 400.0);
    phi += step_mm / r;
    block.line = ++k;
    block.tcp = block.tool_length_active = block.spindle_on = true;
    block.xyz_mm = Vec3(r * std::cos(phi), r * std::sin(phi), 5.0 * std::cos(r * std::cos(phi) / 10.0));
    block.xyz_programmed = block.xyz_known = {true, true, true};
    block.rotary_rad = {0.35 + 0.17 * std::sin(phi), phi};
    block.rotary_programmed = block.rotary_known = {true, true};
    block.feed = feed_mm_s;
    return std::optional<MotionBlock>(block);
  };
}

/// Rapids under TCP that turn both rotaries, each a long way.
std::vector<MotionBlock> turning_rapids(std::size_t count) {
  std::vector<MotionBlock> blocks(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = static_cast<double>(k);
    blocks[k].kind = MotionKind::rapid;
    blocks[k].line = static_cast<std::int64_t>(k) + 1;
    blocks[k].tcp = blocks[k].tool_length_active = true;
    blocks[k].xyz_mm = Vec3(60.0 * std::sin(2.1 * at), 60.0 * std::cos(1.3 * at), 20.0);
    blocks[k].xyz_programmed = blocks[k].xyz_known = {true, true, true};
    blocks[k].rotary_rad = {0.3 + 0.2 * std::sin(1.7 * at), 1.5 * std::sin(2.9 * at)};
    blocks[k].rotary_programmed = blocks[k].rotary_known = {true, true};
  }
  return blocks;
}

/// Nothing but rapids: what the search of their S-curves costs.
void TurningRapids(benchmark::State& state) {
  const Bench bench;
  const std::vector<MotionBlock> blocks = turning_rapids(500);
  double simulated_s = 0.0;
  for (auto _ : state) {
    std::size_t next = 0;
    const MotionSource source = [&]() -> Result<std::optional<MotionBlock>> {
      return next == blocks.size() ? std::nullopt : std::make_optional(blocks[next++]);
    };
    simulated_s += run_motions(source, bench.setup, {})->cycle_time_s;
  }
  state.counters["times_real_time"] = benchmark::Counter(simulated_s, benchmark::Counter::kIsRate);
}

void run(benchmark::State& state, double step_mm, double feed_mm_s, std::int64_t blocks) {
  const Bench bench;
  double simulated_s = 0.0;
  std::int64_t done = 0;
  for (auto _ : state) {
    const auto report = run_motions(spiral(blocks, step_mm, feed_mm_s), bench.setup, {});
    simulated_s += report->cycle_time_s;
    done += report->blocks;
  }
  state.counters["times_real_time"] = benchmark::Counter(simulated_s, benchmark::Counter::kIsRate);
  state.counters["blocks"] = benchmark::Counter(static_cast<double>(done), benchmark::Counter::kIsRate);
}

// One hour and a tenth of it: the ratio to real time stays, so the cost is linear in length.
void OneHour(benchmark::State& state) { run(state, 0.3, 250.0 / 60.0, 50'000); }
void SixMinutes(benchmark::State& state) { run(state, 0.3, 250.0 / 60.0, 5'000); }
// Short blocks at 3000 mm/min: the blocks, not the samples, are the work.
void FastShortBlocks(benchmark::State& state) { run(state, 0.1, 50.0, 50'000); }

// The same for programs of any length: time a block and memory stay.
void Length(benchmark::State& state) {
  run(state, 0.1, 50.0, state.range(0));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_rss_mb"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

BENCHMARK(OneHour)->Unit(benchmark::kMillisecond);
BENCHMARK(TurningRapids)->Unit(benchmark::kMillisecond);
BENCHMARK(SixMinutes)->Unit(benchmark::kMillisecond);
BENCHMARK(FastShortBlocks)->Unit(benchmark::kMillisecond);
BENCHMARK(Length)->Arg(100'000)->Arg(1'000'000)->Arg(10'000'000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
