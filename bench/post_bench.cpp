// Blocks written per second, beside the bare conversion of as many numbers by the standard library: the ratio is what
// the writer adds.
#include <benchmark/benchmark.h>

#include <array>
#include <charconv>

#include "post/cl_data.hpp"
#include "post/program.hpp"
#include "tests/post/sample_paths.hpp"

namespace {

using namespace volute;

constexpr int turns = 50, points_per_turn = 2000;

const post::PostRequest& request() {
  static const post::PostRequest made = post::testing::request_for(post::testing::dome_spiral(turns, points_per_turn));
  return made;
}

void write_blocks(benchmark::State& state, const char* profile_name) {
  const kinematics::Profile profile = post::testing::profile_named(profile_name);
  const kinematics::AxisPath path = post::post(request(), profile)->axis_path;
  std::int64_t blocks = 0;
  for (auto _ : state) {
    post::Program program(request(), profile, path);
    program.begin();
    program.enter(path.points.front());
    program.motion();
    program.leave();
    program.end();
    blocks += program.finish()->blocks;
  }
  state.SetItemsProcessed(blocks);
}
BENCHMARK_CAPTURE(write_blocks, fanuc, "ac-head-fanuc");
BENCHMARK_CAPTURE(write_blocks, linuxcnc, "ac-head-linuxcnc");
BENCHMARK_CAPTURE(write_blocks, siemens_vector, "ac-head-siemens-vector");

// The whole of it: inverse kinematics, linearization, text.
void post_program(benchmark::State& state, const char* profile_name) {
  const kinematics::Profile profile = post::testing::profile_named(profile_name);
  std::int64_t blocks = 0;
  for (auto _ : state) blocks += post::post(request(), profile)->blocks;
  state.SetItemsProcessed(blocks);
}
BENCHMARK_CAPTURE(post_program, fanuc, "ac-head-fanuc");
BENCHMARK_CAPTURE(post_program, linuxcnc, "ac-head-linuxcnc");
BENCHMARK_CAPTURE(post_program, siemens_vector, "ac-head-siemens-vector");

// The peer: five numbers a block by std::to_chars and nothing else.
void bare_numbers(benchmark::State& state) {
  std::int64_t blocks = 0;
  std::string text;
  for (auto _ : state) {
    text.clear();
    for (const kinematics::ToolPathPoint& point : request().path.points) {
      for (const double value : {point.pose.tip_P_mm.x(), point.pose.tip_P_mm.y(), point.pose.tip_P_mm.z(),
                                 point.pose.axis_P.x(), point.pose.axis_P.y()}) {
        std::array<char, 64> digits;
        text.append(
            digits.data(),
            std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, 3).ptr);
      }
      ++blocks;
    }
    benchmark::DoNotOptimize(text.data());
  }
  state.SetItemsProcessed(blocks);
}
BENCHMARK(bare_numbers);

void solve_path(benchmark::State& state, bool tcp) {
  const kinematics::Profile profile = post::testing::profile_named("ac-head-fanuc");
  std::int64_t points = 0;
  for (auto _ : state) {
    kinematics::AxisPathOptions options;
    options.control_keeps_tip = tcp;
    points += static_cast<std::int64_t>(
        kinematics::solve_path(profile.machine, request().setup, request().tool, request().path, options)
            ->path.points.size());
  }
  state.SetItemsProcessed(points);
}
BENCHMARK_CAPTURE(solve_path, with_tcp, true);
BENCHMARK_CAPTURE(solve_path, without_tcp, false);

}  // namespace
