#include "sim/controller/run_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/number_text.hpp"
#include "sim/controller/column_kernels.hpp"
#include "sim/controller/lanes.hpp"

namespace volute::sim {

namespace {

using kinematics::axis_count;
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
  for (int i = 0; i < axis_count; ++i) {
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

// One quantity at a time: its five peaks then stay in registers.
void RunStatistics::add_samples(std::span<const AxisSample> samples) {
  if (samples.empty()) return;
  report_.samples += static_cast<std::int64_t>(samples.size());
  const auto raise = [&](AxisVector& peaks, const auto& value_of) {
    for_lanes([&]<int first, int count>() {
      Eigen::Array<double, count, 1> most = peaks.segment<count>(first);
      for (const AxisSample& sample : samples)
        most = most.max(value_of(sample).template segment<count>(first).array().abs());
      peaks.segment<count>(first) = most;
    });
  };
  raise(velocity_, [](const AxisSample& s) -> const AxisVector& { return s.velocity; });
  raise(acceleration_, [](const AxisSample& s) -> const AxisVector& { return s.acceleration; });
  raise(jerk_, [](const AxisSample& s) -> const AxisVector& { return s.jerk; });
  raise(error_, [](const AxisSample& s) { return s.position - s.actual; });
  add_range(samples);
}

void RunStatistics::add_range(std::span<const AxisSample> samples) {
  AxisVector lowest, highest;
  for_lanes([&]<int first, int count>() {
    using Lanes = Eigen::Array<double, count, 1>;
    Lanes least = Lanes::Constant(no_limit), most = Lanes::Constant(-no_limit);
    for (const AxisSample& sample : samples) {
      const Lanes position = sample.position.segment<count>(first);
      least = least.min(position);
      most = most.max(position);
    }
    lowest.segment<count>(first) = least;
    highest.segment<count>(first) = most;
  });
  if (!add_range(lowest, highest))
    for (const AxisSample& sample : samples) check_travel(sample);
}

bool RunStatistics::add_columns(const SampleColumns& samples, bool exact) {
  if (samples.count == 0) return true;
  report_.samples += samples.count;
  const auto raise = [&](AxisVector& peaks, const SampleColumns::Columns& columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      double& peak = peaks[static_cast<Eigen::Index>(i)];
      peak = std::max(peak, greatest_magnitude(columns[i].data(), samples.count));
    }
  };
  raise(velocity_, samples.velocity);
  raise(acceleration_, samples.acceleration);
  raise(jerk_, samples.jerk);
  if (!exact) raise(error_, samples.error);
  AxisVector lowest = AxisVector::Constant(no_limit), highest = AxisVector::Constant(-no_limit);
  for (std::size_t i = 0; i < samples.position.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    extend_range(samples.position[i].data(), samples.count, lowest[axis], highest[axis]);
  }
  return add_range(lowest, highest);
}

/// Whether a lot of samples with these ends is within the travels.
bool RunStatistics::add_range(const AxisVector& lowest, const AxisVector& highest) {
  lowest_ = lowest_.cwiseMin(lowest);
  highest_ = highest_.cwiseMax(highest);
  const bool within = (lowest.array() >= travel_min_.array()).all() && (highest.array() <= travel_max_.array()).all();
  if (within) outside_ = {};
  return within;
}

void RunStatistics::add_contour_error(const AxisSample& sample, const AxisVector& following_error,
                                      const TipRates& tip_rates) {
  if (sample.rapid || following_error.isZero(0.0)) return;
  // At rest the tip still stands behind along the way it came.
  const Vec3 error = tip_rates * following_error, along = tip_rates * sample.velocity;
  const double speed = along.norm();
  if (speed > 1e-3) tip_direction_ = along / speed;
  contour_error_sq_ = std::max(contour_error_sq_, (error - error.dot(tip_direction_) * tip_direction_).squaredNorm());
}

void RunStatistics::check_travel(const AxisSample& sample) {
  constexpr double rounding = 1e-9;
  for (int i = 0; i < axis_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double position = sample.position[i];
    const bool low = position<travel_min_[i] - rounding, high = position> travel_max_[i] + rounding;
    if (low || high) {
      const double end = low ? travel_min_[i] : travel_max_[i];
      TravelExcess& excess = excess_at(i, end, sample);
      if (!outside_[k]) ++excess.times;
      if (std::abs(position - end) > std::abs(excess.farthest - end)) {
        excess.farthest = position;
        excess.farthest_line = sample.line;
      }
    }
    outside_[k] = low || high;
  }
}

TravelExcess& RunStatistics::excess_at(int axis, double end, const AxisSample& sample) {
  auto& list = report_.out_of_travel;
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const TravelExcess& e) { return e.axis == axis && e.limit == end; });
  if (found != list.end()) return *found;
  return list.emplace_back(TravelExcess{axis, end, sample.line, sample.time_s, end, sample.line, 0});
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
  for (int i = 0; i < axis_count; ++i) {
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
  if (!holds_jerk_) warn_of_jerk(report);
  return report;
}

void RunStatistics::warn_of_jerk(RunReport& report) const {
  for (std::size_t i = 0; i < report.axes.size(); ++i) {
    const kinematics::Axis& axis = machine_.axes[i];
    const double ratio = axis.jerk_max > 0.0 ? report.axes[i].jerk_max / axis.jerk_max : 0.0;
    if (ratio > 1.0)
      report.warnings.push_back(std::string("this control limits no jerk: axis ") + axis.letter + " reaches " +
                                geometry::short_text(ratio, 3) + " times the jerk that the machine file allows");
  }
}

}  // namespace volute::sim
