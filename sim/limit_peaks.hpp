// Where in a run each axis came nearest to its limits, or passed them.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "kinematics/model/machine.hpp"
#include "sim/controller/control_run.hpp"

namespace volute::sim {

/// The sample at which an axis used the greatest share of one of its limits.
struct LimitPeak {
  const char* quantity = "";  ///< "velocity", "acceleration" or "jerk"
  double ratio = 0.0;         ///< of the limit
  std::int64_t line = 0;      ///< of the program
  double time_s = 0.0;
};

/// Takes the samples of a run in order. Cost: three products an axis and sample.
class LimitPeaks {
 public:
  explicit LimitPeaks(const kinematics::Machine& machine);
  void add(std::span<const AxisSample> samples);
  /// The first sample of the quantity whose greatest share is nearest to `ratio`: a run's own figure leaves the jerk
  /// out where the control does not limit it.
  [[nodiscard]] LimitPeak nearest_to(int axis, double ratio) const;

 private:
  static constexpr std::size_t quantities = 3;
  std::array<kinematics::AxisVector, quantities> per_limit_;  ///< 1 / limit; 0 where there is none
  std::array<std::array<LimitPeak, quantities>, kinematics::axis_count> peaks_;
};

}  // namespace volute::sim
