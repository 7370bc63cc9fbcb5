// The timed path, read at every interpolation cycle, averaged, and followed by the servos.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/controller/axis_filter.hpp"
#include "sim/controller/run_statistics.hpp"
#include "sim/controller/servo.hpp"
#include "sim/controller/speed_profile.hpp"
#include "sim/trace.hpp"

namespace volute::sim {

/// Requires: cells in the order of the path.
class CycleSampler {
 public:
  CycleSampler(const kinematics::Machine& machine, const kinematics::Control& control, const AxisVector& start,
               const SampleSink& sink, RunStatistics& statistics);

  void add(const TimedCell& timed);
  /// Lets the filter empty and hands out the last chunk.
  void finish();

 private:
  struct Mark {
    std::int64_t line = 0;
    Limit limit = Limit::stop;
    std::int8_t axis = -1;
    bool rapid = false, cutting = false, feed = false;
  };
  void hold(const TimedCell& timed);
  void move(const TimedCell& timed);
  void play(const PathCell& cell, const Phase& phase);
  [[nodiscard]] int cycles_within(double duration_s) const;
  void take(int count, const Mark& mark);
  void forget_marks(int half);
  void rest_at(const AxisVector& q, std::int64_t cycles, const Mark& mark);
  void drain(Mark mark);
  void start_filter(const MotionLimits& limits);
  void rest(int filter_cycles);
  void flush();
  void write_samples();

  static constexpr int lot = SampleColumns::size;
  double period_s_;
  Servo servo_;
  bool exact_servo_;
  const SampleSink& sink_;
  RunStatistics& statistics_;
  AxisFilter filter_;
  AxisVector at_;
  const MotionLimits* limits_ = nullptr;
  double wait_s_ = 0.0;  ///< until the next cycle, from where the path has been played to
  std::int64_t cycle_ = 0;
  /// Of the cycles within half the filter, and behind them of this lot: marks travel with the middle of the average.
  std::vector<Mark> marks_;
  std::vector<double> tip_speeds_;
  std::size_t half_ = 0;
  int filled_ = 0;  ///< cycles of this lot so far
  SampleColumns columns_;
  std::array<AxisSample, lot> samples_;
  /// Of the cells of this lot, and which of them each cycle goes by; only where the servos leave errors.
  std::vector<TipRates> tip_rates_;
  std::array<std::size_t, lot> rates_of_{};
};

}  // namespace volute::sim
