#include "sim/controller/cycle_sampler.hpp"

#include <cmath>

#include "geometry/check.hpp"
#include "sim/controller/lanes.hpp"

namespace volute::sim {

CycleSampler::CycleSampler(const kinematics::Machine& machine, const kinematics::Control& control,
                           const AxisVector& start, const SampleSink& sink, RunStatistics& statistics)
    : period_s_(control.servo_period_s),
      servo_(machine, control),
      exact_servo_(servo_.exact()),
      sink_(sink),
      statistics_(statistics),
      at_(start) {
  filter_.rest(1, period_s_, at_);
  marks_.assign(1, Mark{});
}

void CycleSampler::start_filter(const MotionLimits& limits) {
  if (limits_ == &limits) return;
  limits_ = &limits;
  filter_.rest(limits.filter_samples, period_s_, at_);
  marks_.assign(static_cast<std::size_t>(limits.filter_samples / 2) + 1, Mark{});
  next_mark_ = 0;
}

void CycleSampler::add(const TimedCell& timed) {
  if (timed.cell.hold) return hold(timed);
  start_filter(*timed.cell.limits);
  tip_rates_ = &timed.cell.tip_rates;
  for (int i = 0; i < timed.phase_count; ++i) play(timed.cell, timed.phases[static_cast<std::size_t>(i)]);
  at_ = timed.cell.start + timed.cell.length * (timed.cell.rate + 0.5 * timed.cell.length * timed.cell.curvature);
}

void CycleSampler::play(const PathCell& cell, const Phase& phase) {
  const double length = phase.to - phase.from;
  const double duration_s = 2.0 * length / (phase.speed_from + phase.speed_to);
  statistics_.add_time(*cell.block, phase.limit, phase.axis, duration_s);
  const double change = 0.5 * (phase.speed_to - phase.speed_from) / duration_s;
  Mark mark{cell.block->line,  0.0F,
            phase.limit,       static_cast<std::int8_t>(phase.axis),
            cell.block->rapid, cell.block->cutting,
            !cell.block->rapid};
  double t = wait_s_;
  for (; t <= duration_s; t += period_s_) {
    const double s = phase.from + t * (phase.speed_from + t * change);
    mark.tip_speed_mm_s = static_cast<float>(cell.tip_rate * (phase.speed_from + 2.0 * t * change));
    AxisVector q;
    for_lanes([&]<int first, int count>() {
      q.segment<count>(first) = cell.start.segment<count>(first) + s * cell.rate.segment<count>(first) +
                                (0.5 * s * s) * cell.curvature.segment<count>(first);
    });
    push(q, mark);
  }
  wait_s_ = t - duration_s;
}

void CycleSampler::push(const AxisVector& q, const Mark& mark) {
  marks_[next_mark_] = mark;
  if (++next_mark_ == marks_.size()) next_mark_ = 0;
  const Mark& middle = marks_[next_mark_];
  AxisSample& sample = chunk_[filled_++];
  filter_.push(q, sample);
  sample.time_s = static_cast<double>(cycle_++) * period_s_;
  const AxisVector& error = servo_.step(sample.velocity);
  sample.actual = sample.position - error;
  sample.line = middle.line;
  sample.tip_speed_mm_s = static_cast<double>(middle.tip_speed_mm_s);
  sample.limit = middle.limit;
  sample.limiting_axis = middle.axis;
  sample.rapid = middle.rapid;
  sample.cutting = middle.cutting;
  if (tip_rates_ && !exact_servo_) statistics_.add_contour_error(sample, error, *tip_rates_);
  if (filled_ == chunk_.size()) flush();
}

// The axes rest when the average has taken in nothing but the last position.
void CycleSampler::drain(Mark mark) {
  for (int i = 0; i < filter_.length(); ++i) push(at_, mark);
  filter_.rest(filter_.length(), period_s_, at_);
  wait_s_ = period_s_;
}

void CycleSampler::hold(const TimedCell& timed) {
  const BlockInfo& block = *timed.cell.block;
  Mark mark{block.line, 0.0F, Limit::stop, -1, block.rapid, false, false};
  statistics_.add_stop(static_cast<double>(filter_.length()) * period_s_);
  drain(mark);
  mark.limit = Limit::dwell;
  const auto cycles = static_cast<std::int64_t>(std::llround(timed.cell.dwell_s / period_s_));
  statistics_.add_dwell(static_cast<double>(cycles) * period_s_);
  for (std::int64_t i = 0; i < cycles; ++i) push(at_, mark);
}

void CycleSampler::finish() {
  statistics_.add_stop(static_cast<double>(filter_.length()) * period_s_);
  drain(Mark{});
  flush();
}

void CycleSampler::flush() {
  statistics_.add_samples(std::span<const AxisSample>(chunk_.data(), filled_));
  if (filled_ > 0 && sink_) sink_(std::span<const AxisSample>(chunk_.data(), filled_));
  filled_ = 0;
}

}  // namespace volute::sim
