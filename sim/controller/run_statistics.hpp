// What a run amounts to: times by cause, peaks, slow blocks, travel.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "sim/controller/control_run.hpp"
#include "sim/controller/path_point.hpp"
#include "sim/controller/sample_columns.hpp"

namespace volute::sim {

class RunStatistics {
 public:
  /// `holds_jerk`: the control limits it; else it is left out of limit_ratio_max.
  RunStatistics(const kinematics::Machine& machine, double period_s, bool holds_jerk);

  void add_time(BlockInfo& block, Limit limit, int axis, double time_s);
  void add_stop(double time_s) { stop_s_ += time_s; }
  void add_dwell(double time_s) { dwell_s_ += time_s; }
  /// All of the block's time has been added.
  void end_block(const BlockInfo& block);
  /// Samples in order; each is told once.
  void add_samples(std::span<const AxisSample> samples);
  /// The same, axis by axis. Returns whether every position is within its travel; else each sample is to be given to
  /// check_travel. `exact`: the errors are zero and not looked at.
  [[nodiscard]] bool add_columns(const SampleColumns& samples, bool exact);
  void check_travel(const AxisSample& sample);
  /// What the servos leave across the tip's way at one of them.
  void add_contour_error(const AxisSample& sample, const AxisVector& following_error, const TipRates& tip_rates);
  [[nodiscard]] RunReport report() const;

 private:
  void add_range(std::span<const AxisSample> samples);
  [[nodiscard]] bool add_range(const AxisVector& lowest, const AxisVector& highest);
  TravelExcess& excess_at(int axis, double end, const AxisSample& sample);
  void warn_of_jerk(RunReport& report) const;

  const kinematics::Machine& machine_;
  double period_s_;
  bool holds_jerk_;
  RunReport report_;
  double programmed_s_ = 0.0;
  double stop_s_ = 0.0, dwell_s_ = 0.0, rapid_s_ = 0.0;
  std::array<double, 10> feed_limit_s_{};
  double rotary_s_ = 0.0;
  AxisVector velocity_, acceleration_, jerk_, error_, lowest_, highest_, travel_min_, travel_max_;
  std::array<bool, kinematics::axis_count> outside_{};
  double contour_error_sq_ = 0.0;
  Vec3 tip_direction_ = Vec3::Zero();  ///< in which the tip moved last
};

}  // namespace volute::sim
