#include "sim/controller/run_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace volute::sim {

namespace {

constexpr int axes = kinematics::axis_count;
constexpr std::size_t worst_kept = 20;
/// More lost time first; the earlier line first among equals.
bool worse(const SlowBlock& a, const SlowBlock& b) {
  return a.lost_s != b.lost_s ? a.lost_s > b.lost_s : a.line < b.line;
}

const char* cause_of(Limit limit) {
  switch (limit) {
    case Limit::programmed_feed:
      return "feed";
    case Limit::corner:
      return "corner";
    case Limit::block_time:
      return "block_time";
    case Limit::look_ahead:
      return "look_ahead";
    case Limit::rapid:
      return "rapid";
    case Limit::dwell:
      return "dwell";
    case Limit::axis_velocity:
    case Limit::axis_acceleration:
    case Limit::axis_jerk:
    case Limit::stop:
      return "acceleration";
  }
  return "acceleration";
}

}  // namespace

RunStatistics::RunStatistics(const kinematics::Machine& machine, double period_s, bool holds_jerk)
    : machine_(machine), period_s_(period_s), holds_jerk_(holds_jerk) {
  velocity_.setZero();
  acceleration_.setZero();
  jerk_.setZero();
  error_.setZero();
  lowest_.setConstant(no_limit);
  highest_.setConstant(-no_limit);
  for (int i = 0; i < axes; ++i) {
    const kinematics::Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    travel_min_[i] = axis.travel_min.value_or(-no_limit);
    travel_max_[i] = axis.travel_max.value_or(no_limit);
  }
}

void RunStatistics::add_time(BlockInfo& block, Limit limit, int axis, double time_s) {
  block.time_s += time_s;
  if (limit != Limit::programmed_feed && time_s > block.capped_s) {
    block.capped_s = time_s;
    block.limit = limit;
    block.axis = axis;
  }
  const bool by_axis = limit == Limit::axis_velocity || limit == Limit::axis_acceleration ||
                       limit == Limit::axis_jerk || limit == Limit::corner;
  if (by_axis && axis >= 0) report_.limited_by_axis_s[static_cast<std::size_t>(axis)] += time_s;
  if (block.rapid) {
    rapid_s_ += time_s;
  } else if (by_axis && axis >= 3 && limit != Limit::corner) {
    rotary_s_ += time_s;
  } else {
    feed_limit_s_[static_cast<std::size_t>(limit)] += time_s;
  }
}

void RunStatistics::end_block(const BlockInfo& block) {
  ++report_.blocks;
  if (block.rapid) return;
  report_.feed_length_mm += block.tip_length_mm;
  report_.feed_time_s += block.time_s;
  programmed_s_ += block.programmed_time_s;
  const double lost_s = block.time_s - block.programmed_time_s;
  if (block.programmed_time_s <= 0.0 || lost_s <= 1e-9 * block.programmed_time_s) return;
  const SlowBlock slow{block.line,
                       block.time_s,
                       lost_s,
                       block.tip_length_mm / block.programmed_time_s,
                       block.tip_length_mm / block.time_s,
                       block.limit,
                       block.axis};
  auto& list = report_.worst_blocks;
  if (list.size() == worst_kept && !worse(slow, list.back())) return;
  list.insert(std::upper_bound(list.begin(), list.end(), slow, worse), slow);
  if (list.size() > worst_kept) list.pop_back();
}

void RunStatistics::add_sample(const AxisSample& sample, const AxisVector& following_error, const TipRates* tip_rates) {
  ++report_.samples;
  bool outside = false;
  for (int i = 0; i < axes; ++i) {
    velocity_[i] = std::max(velocity_[i], std::abs(sample.velocity[i]));
    acceleration_[i] = std::max(acceleration_[i], std::abs(sample.acceleration[i]));
    jerk_[i] = std::max(jerk_[i], std::abs(sample.jerk[i]));
    error_[i] = std::max(error_[i], std::abs(following_error[i]));
    lowest_[i] = std::min(lowest_[i], sample.position[i]);
    highest_[i] = std::max(highest_[i], sample.position[i]);
    outside |= (sample.position[i] < travel_min_[i]) | (sample.position[i] > travel_max_[i]);
  }
  if (outside)
    check_travel(sample);
  else
    outside_ = {};
  if (!tip_rates || sample.rapid || following_error.isZero(0.0)) return;
  // At rest the tip still stands behind along the way it came.
  const Vec3 error = *tip_rates * following_error, along = *tip_rates * sample.velocity;
  const double speed = along.norm();
  if (speed > 1e-3) tip_direction_ = along / speed;
  contour_error_sq_ = std::max(contour_error_sq_, (error - error.dot(tip_direction_) * tip_direction_).squaredNorm());
}

void RunStatistics::check_travel(const AxisSample& sample) {
  constexpr double rounding = 1e-9;
  constexpr std::size_t events_kept = 1000;
  for (int i = 0; i < axes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool low = sample.position[i]<travel_min_[i] - rounding, high = sample.position[i]> travel_max_[i] + rounding;
    if ((low || high) && !outside_[k] && report_.out_of_travel.size() < events_kept)
      report_.out_of_travel.push_back(
          {sample.line, sample.time_s, i, sample.position[i], low ? travel_min_[i] : travel_max_[i]});
    outside_[k] = low || high;
  }
}

RunReport RunStatistics::report() const {
  RunReport report = report_;
  report.cycle_time_s = static_cast<double>(std::max<std::int64_t>(0, report.samples - 1)) * period_s_;
  if (report.feed_time_s > 0.0) report.actual_feed_mm_s = report.feed_length_mm / report.feed_time_s;
  if (programmed_s_ > 0.0) report.programmed_feed_mm_s = report.feed_length_mm / programmed_s_;
  if (report.programmed_feed_mm_s > 0.0)
    report.feed_loss_percent =
        100.0 * (report.actual_feed_mm_s - report.programmed_feed_mm_s) / report.programmed_feed_mm_s;
  for (const char* name :
       {"feed", "acceleration", "corner", "block_time", "rotary_limit", "rapid", "dwell", "look_ahead"})
    report.time_by_cause_s[name] = 0.0;
  for (std::size_t i = 0; i < feed_limit_s_.size(); ++i)
    report.time_by_cause_s[cause_of(static_cast<Limit>(i))] += feed_limit_s_[i];
  report.time_by_cause_s["rotary_limit"] += rotary_s_;
  report.time_by_cause_s["rapid"] += rapid_s_;
  report.time_by_cause_s["dwell"] += dwell_s_;
  report.time_by_cause_s["acceleration"] += stop_s_;
  for (int i = 0; i < axes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const kinematics::Axis& axis = machine_.axes[k];
    AxisPeaks& peaks = report.axes[k];
    peaks.velocity_max = velocity_[i];
    peaks.acceleration_max = acceleration_[i];
    peaks.jerk_max = jerk_[i];
    peaks.following_error_max = error_[i];
    peaks.limit_ratio_max = std::max(velocity_[i] / axis.velocity_max, acceleration_[i] / axis.acceleration_max);
    if (holds_jerk_ && axis.jerk_max > 0.0)
      peaks.limit_ratio_max = std::max(peaks.limit_ratio_max, jerk_[i] / axis.jerk_max);
    peaks.position_min = report.samples > 0 ? lowest_[i] : 0.0;
    peaks.position_max = report.samples > 0 ? highest_[i] : 0.0;
  }
  report.contour_error_max_mm = std::sqrt(contour_error_sq_);
  return report;
}

}  // namespace volute::sim
