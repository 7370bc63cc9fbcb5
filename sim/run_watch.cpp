#include "sim/run_watch.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>

namespace volute::sim {
namespace {

/// How far from the rotaries the machine's parts reach, for judging chords: generous, since it only costs states.
constexpr double link_reach_mm = 500.0;
/// Samples looked at together: enough that handing them over costs nothing, few enough to stay in the cache.
constexpr std::size_t lot_samples = 4096;

}  // namespace

RunWatch::RunWatch(const kinematics::Machine& machine, const kinematics::Setup& setup, const kinematics::Tool& tool,
                   const Bounds& bounds)
    : motion_(machine, setup, tool.gauge_length_mm),
      moves_(bounds.move_chord_mm, tool.cutter.length_mm),
      states_(bounds.state_chord_mm, StatePlace{link_reach_mm}),
      limit_peaks_(machine),
      loads_(machine),
      trace_(machine, bounds.trace_samples_max) {
  filling_.reserve(lot_samples);
  seen_.reserve(lot_samples);
}

RunWatch::~RunWatch() { looking_.wait(); }

void RunWatch::add(std::span<const AxisSample> samples) {
  while (!samples.empty()) {
    const std::size_t count = std::min(samples.size(), lot_samples - filling_.size());
    filling_.insert(filling_.end(), samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count));
    samples = samples.subspan(count);
    if (filling_.size() == lot_samples) hand_over();
  }
}

void RunWatch::finish() {
  hand_over();
  looking_.wait();
}

void RunWatch::hand_over() {
  looking_.wait();
  std::swap(filling_, seen_);
  filling_.clear();
  looking_.run([this] { look_at(seen_); });
}

void MachiningSpan::add(std::span<const AxisSample> samples) {
  for (const AxisSample& sample : samples) {
    if (!sample.cutting) continue;
    if (!begin_s_) begin_s_ = sample.time_s;
    end_s_ = sample.time_s;
  }
}

std::optional<double> MachiningSpan::time_s() const {
  if (!begin_s_) return std::nullopt;
  return *end_s_ - *begin_s_;
}

void RunWatch::look_at(std::span<const AxisSample> samples) {
  poses_.resize(samples.size());
  const auto find_poses = [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, samples.size(), 512), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) poses_[i] = motion_.pose_P(samples[i].actual);
    });
  };
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
  tbb::parallel_invoke([&] { loads_.add(samples); },
                       [&] {
                         trace_.add(samples);
                         limit_peaks_.add(samples);
                         machining_.add(samples);
                       },
                       [&] {
                         find_poses();
                         tbb::parallel_invoke(keep_moves, keep_states);
                       });
}

}  // namespace volute::sim
