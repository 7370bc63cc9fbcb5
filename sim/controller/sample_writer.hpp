// Axis positions of each cycle, with their derivatives, servo error and marks, handed out in chunks.
#pragma once

#include <array>

#include "sim/controller/run_statistics.hpp"
#include "sim/controller/servo.hpp"
#include "sim/trace.hpp"

namespace volute::sim {

/// What a sample says beside positions.
struct SampleMark {
  std::int64_t line = 0;
  double tip_speed_mm_s = 0.0;
  Limit limit = Limit::stop;
  int axis = -1;
  bool rapid = false, cutting = false;
};

/// Velocity, acceleration and jerk are backward differences of the positions.
class SampleWriter {
 public:
  SampleWriter(const kinematics::Machine& machine, const kinematics::Control& control, const AxisVector& start,
               const SampleSink& sink, RunStatistics& statistics)
      : period_s_(control.servo_period_s),
        servo_(machine, control),
        sink_(sink),
        statistics_(statistics),
        position_(start) {
    velocity_.setZero();
    acceleration_.setZero();
  }
  void push(const AxisVector& position, const SampleMark& mark);
  void finish();

 private:
  double period_s_;
  Servo servo_;
  const SampleSink& sink_;
  RunStatistics& statistics_;
  AxisVector position_, velocity_, acceleration_;
  std::int64_t cycle_ = 0;
  std::array<AxisSample, 128> chunk_;  ///< small enough to stay near the processor
  std::size_t filled_ = 0;
};

}  // namespace volute::sim
