#include "sim/run_watch.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

namespace volute::sim {
namespace {

/// How far from the rotaries the machine's parts reach, for judging chords: generous, since it only costs states.
constexpr double link_reach_mm = 500.0;

}  // namespace

RunWatch::RunWatch(const kinematics::Machine& machine, const kinematics::Setup& setup, const kinematics::Tool& tool,
                   const Bounds& bounds)
    : machine_(&machine),
      setup_(&setup),
      tool_(&tool),
      moves_(bounds.move_chord_mm, tool.cutter.length_mm),
      states_(bounds.state_chord_mm, StatePlace{link_reach_mm}),
      loads_(machine),
      trace_(machine, bounds.trace_samples_max) {}

void RunWatch::add(std::span<const AxisSample> samples) {
  poses_.resize(samples.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, samples.size(), 512), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      poses_[i] = kinematics::tool_pose(*machine_, *setup_, tool_->gauge_length_mm, samples[i].actual);
    }
  });
  const auto keep_moves = [&] {
    for (std::size_t i = 0; i < samples.size(); ++i)
      moves_.add({poses_[i], samples[i].line, samples[i].time_s, samples[i].rapid});
  };
  const auto keep_states = [&] {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const AxisSample& s = samples[i];
      states_.add({s.actual, poses_[i], s.line, s.time_s, s.rapid, s.cutting});
    }
  };
  // Each keeps its own order, so the result does not depend on who runs where.
  tbb::parallel_invoke(
      keep_moves, keep_states, [&] { loads_.add(samples); }, [&] { trace_.add(samples); });
}

}  // namespace volute::sim
