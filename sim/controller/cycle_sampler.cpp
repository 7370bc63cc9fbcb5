#include "sim/controller/cycle_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "sim/controller/column_kernels.hpp"
#include "sim/controller/rest_move.hpp"

namespace volute::sim {

CycleSampler::CycleSampler(const kinematics::Machine& machine, const kinematics::Control& control,
                           const AxisVector& start, const SampleSink& sink, RunStatistics& statistics)
    : period_s_(control.servo_period_s),
      servo_(machine, control),
      exact_servo_(servo_.exact()),
      sink_(sink),
      statistics_(statistics),
      at_(start) {
  for (auto& column : columns_.error) column.setZero();
  rest(1);
  forget_marks(0);
}

/// The axes have rested where they are for as long as the filter reaches back.
void CycleSampler::rest(int filter_cycles) {
  flush();
  filter_.rest(filter_cycles, period_s_, at_);
}

void CycleSampler::start_filter(const MotionLimits& limits) {
  if (limits_ == &limits) return;
  limits_ = &limits;
  rest(limits.filter_samples);
  forget_marks(limits.filter_samples / 2);
}

void CycleSampler::forget_marks(int half) {
  half_ = static_cast<std::size_t>(half);
  marks_.assign(half_ + lot, Mark{});
  tip_speeds_.assign(half_ + lot, 0.0);
}

void CycleSampler::add(const TimedCell& timed) {
  if (timed.cell.hold) return hold(timed);
  start_filter(*timed.cell.limits);
  if (!exact_servo_) tip_rates_.push_back(timed.cell.tip_rates);
  for (int i = 0; i < timed.phase_count; ++i) play(timed.cell, timed.phases[static_cast<std::size_t>(i)]);
  at_ = timed.cell.start + timed.cell.length * (timed.cell.rate + 0.5 * timed.cell.length * timed.cell.curvature);
}

void CycleSampler::play(const PathCell& cell, const Phase& phase) {
  const double length = phase.to - phase.from;
  const double duration_s = 2.0 * length / (phase.speed_from + phase.speed_to);
  statistics_.add_time(*cell.block, phase.limit, phase.axis, duration_s);
  const double change = 0.5 * (phase.speed_to - phase.speed_from) / duration_s;
  const Mark mark{cell.block->line,  phase.limit,         static_cast<std::int8_t>(phase.axis),
                  cell.block->rapid, cell.block->cutting, !cell.block->rapid};
  const int cycles = cycles_within(duration_s);
  SampleColumns::Column t, s;
  for (int done = 0; done < cycles;) {
    const int first = filled_, count = std::min(cycles - done, lot - filled_);
    even_steps(wait_s_, period_s_, done, count, t.data());
    quadratic(phase.from, phase.speed_from, change, t.data(), count, s.data());
    linear(cell.tip_rate * phase.speed_from, 2.0 * cell.tip_rate * change, t.data(), count,
           tip_speeds_.data() + half_ + first);
    for (int i = 0; i < kinematics::axis_count; ++i) {
      double* inputs = filter_.inputs(i) + first;
      if (cell.straight)
        linear(cell.start[i], cell.rate[i], s.data(), count, inputs);
      else
        quadratic(cell.start[i], cell.rate[i], 0.5 * cell.curvature[i], s.data(), count, inputs);
    }
    take(count, mark);
    done += count;
  }
  wait_s_ = wait_s_ + cycles * period_s_ - duration_s;
}

/// How many cycles of a phase that lasts so long; the first of them is wait_s_ after its beginning.
int CycleSampler::cycles_within(double duration_s) const {
  if (wait_s_ > duration_s) return 0;
  const int cycles = static_cast<int>((duration_s - wait_s_) / period_s_) + 1;
  // The quotient may be rounded up to a whole number.
  return wait_s_ + (cycles - 1) * period_s_ <= duration_s ? cycles : cycles - 1;
}

/// The next cycles of this lot have their inputs and tip speeds.
void CycleSampler::take(int count, const Mark& mark) {
  std::fill_n(marks_.begin() + static_cast<std::ptrdiff_t>(half_) + filled_, count, mark);
  std::fill_n(rates_of_.begin() + filled_, count, tip_rates_.size() - 1);
  filled_ += count;
  if (filled_ == lot) flush();
}

void CycleSampler::rest_at(const AxisVector& q, std::int64_t cycles, const Mark& mark) {
  while (cycles > 0) {
    const int count = static_cast<int>(std::min<std::int64_t>(cycles, lot - filled_));
    for (int i = 0; i < kinematics::axis_count; ++i) std::fill_n(filter_.inputs(i) + filled_, count, q[i]);
    std::fill_n(tip_speeds_.begin() + static_cast<std::ptrdiff_t>(half_) + filled_, count, 0.0);
    take(count, mark);
    cycles -= count;
  }
}

// The axes rest when the average has taken in nothing but the last position.
void CycleSampler::drain(Mark mark) {
  rest_at(at_, filter_.length(), mark);
  rest(filter_.length());
  wait_s_ = period_s_;
}

// The positions are the curve's own: the filter is one cycle long meanwhile.
void CycleSampler::move(const TimedCell& timed) {
  const RestMove& move = *timed.cell.move;
  BlockInfo& block = *timed.cell.block;
  Mark mark{block.line, Limit::stop, -1, block.rapid, block.cutting, false};
  if (filter_.length() > 1) {
    rest_at(at_, settling_cycles, mark);
    statistics_.add_stop(settling_cycles * period_s_);
  }
  rest(1);
  forget_marks(0);
  limits_ = nullptr;
  mark.limit = move.limit();
  mark.axis = static_cast<std::int8_t>(move.limit_axis());
  const int cycles = cycles_within(move.duration_s());
  for (int done = 0; done < cycles;) {
    const int count = std::min(cycles - done, lot - filled_);
    for (int k = 0; k < count; ++k) {
      const double time_s = wait_s_ + (done + k) * period_s_;
      const AxisVector q = move.position(time_s);
      for (int i = 0; i < kinematics::axis_count; ++i) filter_.inputs(i)[filled_ + k] = q[i];
      tip_speeds_[static_cast<std::size_t>(filled_ + k)] = move.tip_speed_mm_s(time_s);
    }
    take(count, mark);
    done += count;
  }
  at_ = move.position(move.duration_s());
  mark.limit = Limit::stop;
  mark.axis = -1;
  rest_at(at_, settling_cycles, mark);
  statistics_.add_time(block, move.limit(), move.limit_axis(), move.duration_s());
  statistics_.add_stop(wait_s_ + (cycles - 1 + settling_cycles) * period_s_ - move.duration_s());
  wait_s_ = period_s_;
}

void CycleSampler::hold(const TimedCell& timed) {
  if (timed.cell.move) return move(timed);
  const BlockInfo& block = *timed.cell.block;
  Mark mark{block.line, Limit::stop, -1, block.rapid, false, false};
  statistics_.add_stop(static_cast<double>(filter_.length()) * period_s_);
  drain(mark);
  mark.limit = Limit::dwell;
  const auto cycles = static_cast<std::int64_t>(std::llround(timed.cell.dwell_s / period_s_));
  statistics_.add_dwell(static_cast<double>(cycles) * period_s_);
  rest_at(at_, cycles, mark);
}

void CycleSampler::finish() {
  statistics_.add_stop(static_cast<double>(filter_.length()) * period_s_);
  const auto end = half_ + static_cast<std::size_t>(filled_);
  const Mark last = end > 0 ? marks_[end - 1] : Mark{};
  drain({last.line, Limit::stop, -1, last.rapid, false, false});  // coming to rest belongs to the last block
  flush();
}

/// Averages this lot, lets the servos follow it, and hands it out.
void CycleSampler::flush() {
  if (filled_ == 0) return;
  columns_.count = filled_;
  filter_.pass(filled_, columns_);
  if (!exact_servo_) servo_.step(columns_);
  const bool within = statistics_.add_columns(columns_, exact_servo_);
  if (sink_ || !within || !exact_servo_) {
    write_samples();
    const auto count = static_cast<std::size_t>(filled_);
    for (std::size_t k = 0; k < count; ++k) {
      const AxisSample& sample = samples_[k];
      if (!within) statistics_.check_travel(sample);
      if (!exact_servo_ && rates_of_[k] < tip_rates_.size())
        statistics_.add_contour_error(sample, sample.position - sample.actual, tip_rates_[rates_of_[k]]);
    }
    if (sink_) sink_(std::span<const AxisSample>(samples_.data(), count));
  }
  cycle_ += filled_;
  std::copy_n(marks_.begin() + filled_, half_, marks_.begin());
  std::copy_n(tip_speeds_.begin() + filled_, half_, tip_speeds_.begin());
  if (tip_rates_.size() > 1) tip_rates_.erase(tip_rates_.begin(), tip_rates_.end() - 1);
  filled_ = 0;
}

void CycleSampler::write_samples() {
  for (int k = 0; k < filled_; ++k) {
    AxisSample& sample = samples_[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < columns_.position.size(); ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      sample.position[axis] = columns_.position[i][k];
      sample.velocity[axis] = columns_.velocity[i][k];
      sample.acceleration[axis] = columns_.acceleration[i][k];
      sample.jerk[axis] = columns_.jerk[i][k];
      sample.actual[axis] = columns_.position[i][k] - columns_.error[i][k];
    }
    const Mark& middle = marks_[static_cast<std::size_t>(k)];
    sample.time_s = static_cast<double>(cycle_ + k) * period_s_;
    sample.line = middle.line;
    sample.tip_speed_mm_s = tip_speeds_[static_cast<std::size_t>(k)];
    sample.limit = middle.limit;
    sample.limiting_axis = middle.axis;
    sample.rapid = middle.rapid;
    sample.cutting = middle.cutting;
  }
}

}  // namespace volute::sim
