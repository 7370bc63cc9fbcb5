// What the axes do over time.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "kinematics/model/machine.hpp"

namespace volute::sim {

using kinematics::AxisVector;

/// What holds the speed down at a moment.
enum class Limit : std::uint8_t {
  programmed_feed,
  axis_velocity,
  axis_acceleration,
  axis_jerk,
  corner,
  block_time,
  look_ahead,
  rapid,
  dwell,
  stop,
};

/// One interpolation cycle.
struct AxisSample {
  double time_s = 0.0;
  AxisVector position, velocity, acceleration, jerk;  ///< commanded, machine coordinates
  AxisVector actual;                                  ///< position behind the servo
  std::int64_t line = 0;
  double tip_speed_mm_s = 0.0;  ///< of the tip relative to the part
  Limit limit = Limit::programmed_feed;
  std::int8_t limiting_axis = -1;  ///< index of the axis for axis_* limits
  bool rapid = false;
  bool cutting = false;  ///< feed move with the spindle on
};

/// Receives samples in order, in chunks; a chunk is valid during the call only.
using SampleSink = std::function<void(std::span<const AxisSample>)>;

}  // namespace volute::sim
