#include "post/feed.hpp"

#include <algorithm>
#include <cmath>

namespace volute::post {

using kinematics::AxisPathPoint;
using kinematics::Control;
using kinematics::Machine;

namespace {

constexpr double seconds_per_minute = 60.0;

double step_time_s(const Machine& machine, const AxisPathPoint& from, const AxisPathPoint& to) {
  double time_s = (to.pose.tip_P_mm - from.pose.tip_P_mm).norm() / to.feed_mm_s;
  for (int i = 3; i < kinematics::axis_count; ++i)
    time_s = std::max(time_s, std::abs(to.q[i] - from.q[i]) / machine.axes[static_cast<std::size_t>(i)].velocity_max);
  return time_s;
}

// What the control takes for the length of a block that moves linear axes and rotaries without TCP.
double counted_length_mm(const Control& control, const AxisPathPoint& from, const AxisPathPoint& to) {
  const kinematics::AxisVector step = to.q - from.q;
  const double linear_mm = step.head<3>().norm();
  if (control.mixed_feed == kinematics::MixedFeed::linear_axes_only) return linear_mm;
  return std::hypot(linear_mm, control.mixed_feed_mm_per_rad * step.tail<2>().norm());
}

}  // namespace

FeedWord feed_word(const Machine& machine, const Control& control, const AxisPathPoint& from, const AxisPathPoint& to) {
  if (control.inverse_time) {
    const double time_s = step_time_s(machine, from, to);
    const double per_minute =
        time_s * control.inverse_time_max < seconds_per_minute ? control.inverse_time_max : seconds_per_minute / time_s;
    return {per_minute, time_s > 0.0 && seconds_per_minute / time_s > control.inverse_time_max};
  }
  const double tip_feed_mm_min = to.feed_mm_s * seconds_per_minute;
  if (control.tcp) return {tip_feed_mm_min, false};
  const double time_s = step_time_s(machine, from, to), length_mm = counted_length_mm(control, from, to);
  if (!(time_s > 0.0) || !(length_mm > 0.0)) return {tip_feed_mm_min, false};
  return {length_mm / time_s * seconds_per_minute, false};
}

}  // namespace volute::post
