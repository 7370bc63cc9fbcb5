#include "sim/controller/axis_filter.hpp"

#include "geometry/check.hpp"
#include "sim/controller/lanes.hpp"

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
  for_lanes([&]<int first, int count>() {
    const auto part = [](auto& axes) { return axes.template segment<count>(first); };
    using Lanes = Eigen::Matrix<double, count, 1>;
    const Lanes velocity = (part(position) - part(oldest)) * windows_per_s_;
    const Lanes acceleration = (velocity - part(velocity_)) * cycles_per_s_;
    part(mean_) += velocity * period_s_;
    part(sample.position) = part(mean_);
    part(sample.velocity) = velocity;
    part(sample.acceleration) = acceleration;
    part(sample.jerk) = (acceleration - part(acceleration_)) * cycles_per_s_;
    part(velocity_) = velocity;
    part(acceleration_) = acceleration;
  });
  oldest = position;
}

}  // namespace volute::sim
