#include "sim/controller/axis_filter.hpp"

#include "geometry/check.hpp"

namespace volute::sim {

void AxisFilter::rest(int n, double period_s, const kinematics::AxisVector& position) {
  VOLUTE_CHECK(n >= 1 && period_s > 0.0, n, period_s);
  n_ = n;
  period_s_ = period_s;
  cycles_per_s_ = 1.0 / period_s;
  windows_per_s_ = 1.0 / (n * period_s);
  ring_.assign(static_cast<std::size_t>(n), position);
  next_ = 0;
  mean_ = position;
  velocity_.setZero();
  acceleration_.setZero();
}

void AxisFilter::push(const kinematics::AxisVector& position, AxisSample& sample) {
  kinematics::AxisVector& oldest = ring_[next_];
  if (++next_ == ring_.size()) next_ = 0;
  for (int i = 0; i < kinematics::axis_count; ++i) {
    const double velocity = (position[i] - oldest[i]) * windows_per_s_;
    const double acceleration = (velocity - velocity_[i]) * cycles_per_s_;
    mean_[i] += velocity * period_s_;
    sample.position[i] = mean_[i];
    sample.velocity[i] = velocity;
    sample.acceleration[i] = acceleration;
    sample.jerk[i] = (acceleration - acceleration_[i]) * cycles_per_s_;
    velocity_[i] = velocity;
    acceleration_[i] = acceleration;
  }
  oldest = position;
}

}  // namespace volute::sim
