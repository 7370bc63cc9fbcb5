#include "sim/controller/axis_filter.hpp"

#include <algorithm>

#include "geometry/check.hpp"
#include "sim/controller/column_kernels.hpp"

namespace volute::sim {

namespace {

/// Backward differences times `scale`; `last` is the value before the first and becomes the last one.
void differences(const SampleColumns::Column& values, int count, double scale, double& last,
                 SampleColumns::Column& out) {
  out[0] = (values[0] - last) * scale;
  scaled_difference(values.data() + 1, values.data(), scale, count - 1, out.data() + 1);
  last = values[count - 1];
}

}  // namespace

void AxisFilter::rest(int n, double period_s, const kinematics::AxisVector& position) {
  VOLUTE_CHECK(n >= 1 && period_s > 0.0, n, period_s);
  n_ = n;
  period_s_ = period_s;
  cycles_per_s_ = 1.0 / period_s;
  windows_per_s_ = 1.0 / (n * period_s);
  for (std::size_t i = 0; i < history_.size(); ++i)
    history_[i].setConstant(n + SampleColumns::size, position[static_cast<Eigen::Index>(i)]);
  mean_ = position;
  velocity_.setZero();
  acceleration_.setZero();
}

void AxisFilter::pass(int axis, int count, SampleColumns& out) {
  const auto i = static_cast<std::size_t>(axis);
  Eigen::ArrayXd& history = history_[i];
  scaled_difference(history.data() + n_, history.data(), windows_per_s_, count, out.velocity[i].data());
  differences(out.velocity[i], count, cycles_per_s_, velocity_[axis], out.acceleration[i]);
  differences(out.acceleration[i], count, cycles_per_s_, acceleration_[axis], out.jerk[i]);
  std::copy_n(history.data() + count, n_, history.data());
}

void AxisFilter::pass(int count, SampleColumns& out) {
  constexpr int axes = kinematics::axis_count;
  for (int axis = 0; axis < axes; ++axis) pass(axis, count, out);
  // Each mean follows from the one before: five such chains side by side wait for none.
  std::array<double, axes> mean{};
  std::copy_n(mean_.data(), axes, mean.data());
  const double period_s = period_s_;  // a copy that no store can change
  for (int k = 0; k < count; ++k)
    for (std::size_t i = 0; i < axes; ++i) {
      mean[i] += out.velocity[i].data()[k] * period_s;
      out.position[i].data()[k] = mean[i];
    }
  std::copy_n(mean.data(), axes, mean_.data());
}

}  // namespace volute::sim
