// The moving average between the plan and the axes.
#pragma once

#include <vector>

#include "sim/trace.hpp"

namespace volute::sim {

/// Mean of the last n positions. Velocity, acceleration and jerk are backward differences of the means, taken from
/// differences of the inputs, so that no rounding of a running sum enters them.
class AxisFilter {
 public:
  /// The axes have rested at `position` for ever. Requires: n >= 1.
  void rest(int n, double period_s, const kinematics::AxisVector& position);
  /// Sets position, velocity, acceleration and jerk of `sample`.
  void push(const kinematics::AxisVector& position, AxisSample& sample);
  [[nodiscard]] int length() const { return n_; }

 private:
  int n_ = 1;
  double period_s_ = 0.0, cycles_per_s_ = 0.0, windows_per_s_ = 0.0;
  std::vector<kinematics::AxisVector> ring_;  ///< the last n inputs, oldest at next_
  std::size_t next_ = 0;
  kinematics::AxisVector mean_, velocity_, acceleration_;
};

}  // namespace volute::sim
