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
    float tip_speed_mm_s = 0.0F;
    Limit limit = Limit::stop;
    std::int8_t axis = -1;
    bool rapid = false, cutting = false, feed = false;
  };
  void hold(const TimedCell& timed);
  void play(const PathCell& cell, const Phase& phase);
  void push(const AxisVector& q, const Mark& mark);
  void drain(Mark mark);
  void start_filter(const MotionLimits& limits);
  void flush();

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
  std::vector<Mark> marks_;  ///< of the cycles within half the filter: marks travel with the middle of the average
  std::size_t next_mark_ = 0;
  std::array<AxisSample, 64> chunk_;  ///< small enough to stay near the processor
  std::size_t filled_ = 0;
  const TipRates* tip_rates_ = nullptr;
};

}  // namespace volute::sim
