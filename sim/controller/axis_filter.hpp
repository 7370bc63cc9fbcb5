// The moving average between the plan and the axes.
#pragma once

#include <array>

#include <Eigen/Core>

#include "sim/controller/sample_columns.hpp"

namespace volute::sim {

/// Mean of the last n positions. Velocity, acceleration and jerk are backward differences of the means, taken from
/// differences of the inputs, so that no rounding of a running sum enters them.
class AxisFilter {
 public:
  /// The axes have rested at `position` for ever. Requires: n >= 1.
  void rest(int n, double period_s, const kinematics::AxisVector& position);
  /// Where the next positions of an axis are written, up to SampleColumns::size of them.
  [[nodiscard]] double* inputs(int axis) { return history_[static_cast<std::size_t>(axis)].data() + n_; }
  /// Takes the first `count` inputs of every axis; sets position, velocity, acceleration and jerk of `out`. Requires:
  /// 1 <= count <= SampleColumns::size.
  void pass(int count, SampleColumns& out);
  [[nodiscard]] int length() const { return n_; }

 private:
  void pass(int axis, int count, SampleColumns& out);

  int n_ = 1;
  double period_s_ = 0.0, cycles_per_s_ = 0.0, windows_per_s_ = 0.0;
  /// The last n inputs, oldest first, and behind them the next.
  std::array<Eigen::ArrayXd, kinematics::axis_count> history_;
  kinematics::AxisVector mean_, velocity_, acceleration_;
};

}  // namespace volute::sim
