// The virtual control: motions in, axis samples out.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/control.hpp"
#include "sim/interpreter/program.hpp"
#include "sim/trace.hpp"

namespace volute::sim {

struct AxisPeaks {
  double velocity_max = 0.0, acceleration_max = 0.0, jerk_max = 0.0, following_error_max = 0.0;
  /// Of velocity, acceleration and jerk to the axis's limits; jerk counts where the control limits it.
  double limit_ratio_max = 0.0;

  double position_min = 0.0, position_max = 0.0;
};

/// A block that took longer than its feed asked.
struct SlowBlock {
  std::int64_t line = 0;
  double time_s = 0.0, lost_s = 0.0, programmed_mm_s = 0.0, actual_mm_s = 0.0;
  Limit limit = Limit::programmed_feed;
  int axis = -1;
};

/// An axis that leaves its travel at one end, over the whole run.
struct TravelExcess {
  int axis = -1;
  double limit = 0.0;           ///< the end, mm or rad
  std::int64_t first_line = 0;  ///< where it leaves first
  double first_time_s = 0.0;
  double farthest = 0.0;  ///< the position farthest beyond, mm or rad
  std::int64_t farthest_line = 0;
  std::int64_t times = 0;  ///< how often it leaves
};

struct RunReport {
  double cycle_time_s = 0.0;
  double feed_length_mm = 0.0, feed_time_s = 0.0;  ///< tip length and time of feed moves
  double programmed_feed_mm_s = 0.0;  ///< their length over the time that F asks for it: F itself where it is constant
  double actual_feed_mm_s = 0.0;      ///< [Sun2016] eq. 37
  double feed_loss_percent = 0.0;     ///< eq. 38: (actual - programmed) / programmed * 100
  std::int64_t samples = 0, blocks = 0;
  std::array<AxisPeaks, kinematics::axis_count> axes;
  std::array<double, kinematics::axis_count> limited_by_axis_s{};
  std::map<std::string, double> time_by_cause_s;  ///< feed acceleration corner block_time rotary_limit rapid dwell
  double contour_error_max_mm = 0.0;              ///< tip, servo against command
  std::vector<SlowBlock> worst_blocks;            ///< at most 20, by lost time
  std::vector<TravelExcess> out_of_travel;        ///< in the order in which the ends were passed first
  std::vector<std::string> warnings;
};

/// The next motion of a program, nothing at its end.
using MotionSource = std::function<Result<std::optional<MotionBlock>>()>;

struct ControlSetup {
  const kinematics::Machine* machine = nullptr;
  const kinematics::Control* control = nullptr;
  kinematics::Setup setup;
  double tool_length_mm = 0.0;
  std::optional<AxisVector> start;  ///< where the axes stand; nothing: the machine's zero pose
  std::int64_t program_lines = 0;   ///< lines of the text, for `progress`; 0: not known
};

/// Runs the whole program. Memory is bounded by look-ahead, not by the program's length. `sink` may be empty.
/// `progress` (share of the text read) may be empty.
/// Property 1: no axis exceeds position, velocity, acceleration or jerk limits (position: reported, velocity,
/// acceleration, jerk: held). Errors: those of ProgramReader; pose-unreachable.
Result<RunReport> run_program(ProgramReader& program, const ControlSetup& setup, const SampleSink& sink,
                              const std::function<void(double)>& progress = {});

/// The same for motions from anywhere. `progress` is called every few thousand blocks with the line of the last one.
Result<RunReport> run_motions(const MotionSource& next, const ControlSetup& setup, const SampleSink& sink,
                              const std::function<void(std::int64_t line)>& progress = {});

}  // namespace volute::sim
