#include "sim/trace_thinner.hpp"

#include <algorithm>
#include <cmath>

namespace volute::sim {
namespace {

double limit_ratio(const kinematics::Machine& machine, const AxisSample& sample) {
  double ratio = 0.0;
  for (int i = 0; i < kinematics::axis_count; ++i) {
    const auto& axis = machine.axes[static_cast<std::size_t>(i)];
    ratio =
        std::max({ratio, std::abs(sample.velocity[i]) / axis.velocity_max,
                  std::abs(sample.acceleration[i]) / axis.acceleration_max, std::abs(sample.jerk[i]) / axis.jerk_max});
  }
  return ratio;
}

}  // namespace

void TraceThinner::add(std::span<const AxisSample> samples) {
  for (const AxisSample& sample : samples) {
    if (stretches_.empty() || stretches_.back().count >= stretch_samples_) {
      if (stretches_.size() >= stretches_max_) join();
      if (stretches_.empty() || stretches_.back().count >= stretch_samples_)
        stretches_.push_back({sample, sample, -1.0, 0});
    }
    Stretch& stretch = stretches_.back();
    ++stretch.count;
    last_ = sample;
    if (const double ratio = limit_ratio(*machine_, sample); ratio > stretch.peak_ratio) {
      stretch.peak_ratio = ratio;
      stretch.peak = sample;
    }
  }
}

void TraceThinner::join() {
  std::vector<Stretch> joined;
  for (std::size_t i = 0; i < stretches_.size(); i += 2) {
    Stretch both = stretches_[i];
    if (i + 1 < stretches_.size()) {
      const Stretch& next = stretches_[i + 1];
      both.count += next.count;
      if (next.peak_ratio > both.peak_ratio) {
        both.peak = next.peak;
        both.peak_ratio = next.peak_ratio;
      }
    }
    joined.push_back(both);
  }
  stretches_ = std::move(joined);
  stretch_samples_ *= 2;
}

std::vector<AxisSample> TraceThinner::finish() const {
  std::vector<AxisSample> out;
  const auto add_once = [&](const AxisSample& sample) {
    if (out.empty() || sample.time_s > out.back().time_s) out.push_back(sample);
  };
  for (const Stretch& stretch : stretches_) {
    add_once(stretch.first);
    add_once(stretch.peak);
  }
  if (!stretches_.empty()) add_once(last_);
  return out;
}

}  // namespace volute::sim
