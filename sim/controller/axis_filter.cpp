#include "sim/controller/axis_filter.hpp"

#include "geometry/check.hpp"

namespace volute::sim {

void AxisFilter::rest(int n, double period_s, const kinematics::AxisVector& position) {
  VOLUTE_CHECK(n >= 1 && period_s > 0.0, n, period_s);
  n_ = n;
  period_s_ = period_s;
  per_period_ = 1.0 / (n * period_s);
  ring_.assign(static_cast<std::size_t>(n), position);
  next_ = 0;
  mean_ = position;
  velocity_.setZero();
  acceleration_.setZero();
}

void AxisFilter::push(const kinematics::AxisVector& position, Output& output) {
  kinematics::AxisVector& oldest = ring_[next_];
  if (++next_ == ring_.size()) next_ = 0;
  output.velocity = (position - oldest) * per_period_;
  oldest = position;
  mean_ += output.velocity * period_s_;
  output.position = mean_;
  output.acceleration = (output.velocity - velocity_) / period_s_;
  output.jerk = (output.acceleration - acceleration_) / period_s_;
  velocity_ = output.velocity;
  acceleration_ = output.acceleration;
}

}  // namespace volute::sim
