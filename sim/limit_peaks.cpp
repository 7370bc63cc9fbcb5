#include "sim/limit_peaks.hpp"

#include <algorithm>
#include <cmath>

namespace volute::sim {

LimitPeaks::LimitPeaks(const kinematics::Machine& machine) {
  for (auto& axis : peaks_) axis = {LimitPeak{"velocity"}, LimitPeak{"acceleration"}, LimitPeak{"jerk"}};
  for (int i = 0; i < kinematics::axis_count; ++i) {
    const kinematics::Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    per_limit_[0][i] = 1.0 / axis.velocity_max;
    per_limit_[1][i] = 1.0 / axis.acceleration_max;
    per_limit_[2][i] = axis.jerk_max > 0.0 ? 1.0 / axis.jerk_max : 0.0;
  }
}

void LimitPeaks::add(std::span<const AxisSample> samples) {
  for (const AxisSample& s : samples) {
    const std::array<const kinematics::AxisVector*, quantities> rates = {&s.velocity, &s.acceleration, &s.jerk};
    for (std::size_t k = 0; k < quantities; ++k) {
      const kinematics::AxisVector share = rates[k]->cwiseAbs().cwiseProduct(per_limit_[k]);
      for (int i = 0; i < kinematics::axis_count; ++i) {
        LimitPeak& peak = peaks_[static_cast<std::size_t>(i)][k];
        if (share[i] > peak.ratio) peak = {peak.quantity, share[i], s.line, s.time_s};
      }
    }
  }
}

LimitPeak LimitPeaks::nearest_to(int axis, double ratio) const {
  const auto& peaks = peaks_[static_cast<std::size_t>(axis)];
  return *std::min_element(peaks.begin(), peaks.end(), [&](const LimitPeak& a, const LimitPeak& b) {
    return std::abs(a.ratio - ratio) < std::abs(b.ratio - ratio);
  });
}

}  // namespace volute::sim
