#include "planner/orientation/motion.hpp"

#include <algorithm>
#include <cmath>

namespace volute::planner {

namespace {

/// Greatest magnitude and length-weighted mean square of samples.
struct Peak {
  double greatest = 0.0, sum_sq = 0.0, length = 0.0;
  void add(double value, double weight) {
    greatest = std::max(greatest, std::abs(value));
    sum_sq += weight * value * value;
    length += weight;
  }
  [[nodiscard]] double rms() const { return length > 0.0 ? std::sqrt(sum_sq / length) : 0.0; }
};

}  // namespace

AxisMotionPeaks motion_peaks(std::span<const double> s_mm, std::span<const double> phi_rad, double feed_mm_s) {
  Peak velocity, acceleration, jerk;
  double v_last = 0.0, a_last = 0.0, step_last = 0.0, step_before = 0.0;
  for (std::size_t i = 0; i + 1 < s_mm.size(); ++i) {
    const double step = s_mm[i + 1] - s_mm[i];
    const double v = (phi_rad[i + 1] - phi_rad[i]) / step * feed_mm_s;
    velocity.add(v, step);
    if (i > 0) {
      const double between = 0.5 * (step + step_last), a = (v - v_last) / between * feed_mm_s;
      acceleration.add(a, between);
      // a stands for the mean of its three places, so a third of the four places' length lies between two of them.
      if (i > 1) jerk.add(3.0 * (a - a_last) / (step + step_last + step_before) * feed_mm_s, step_last);
      a_last = a;
    }
    v_last = v;
    step_before = step_last;
    step_last = step;
  }
  return {velocity.greatest, acceleration.greatest, jerk.greatest, velocity.rms(), acceleration.rms(), jerk.rms()};
}

}  // namespace volute::planner
