#include "sim/controller/servo.hpp"

#include <cmath>

namespace volute::sim {

// e' = (1 - f) v - Kv e, so e(t + T) = e exp(-Kv T) + (1 - f) v (1 - exp(-Kv T)) / Kv.
Servo::Servo(const kinematics::Machine& machine, const kinematics::Control& control) {
  for (int i = 0; i < kinematics::axis_count; ++i) {
    const kinematics::Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    const double kv = axis.position_gain_per_s;
    if (kv <= 0.0) continue;
    const double forward = control.feed_forward ? axis.velocity_feed_forward : 0.0;
    keep_[i] = std::exp(-kv * control.servo_period_s);
    gain_[i] = (1.0 - forward) * (1.0 - keep_[i]) / kv;
  }
}

void Servo::step(SampleColumns& samples) {
  for (std::size_t i = 0; i < samples.error.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    for (int k = 0; k < samples.count; ++k)
      samples.error[i][k] = error_[axis] = keep_[axis] * error_[axis] + gain_[axis] * samples.velocity[i][k];
  }
}

}  // namespace volute::sim
