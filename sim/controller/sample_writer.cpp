#include "sim/controller/sample_writer.hpp"

namespace volute::sim {

void SampleWriter::push(const AxisVector& position, const SampleMark& mark) {
  AxisSample& sample = chunk_[filled_++];
  sample.time_s = static_cast<double>(cycle_++) * period_s_;
  sample.position = position;
  sample.velocity = (position - position_) / period_s_;
  sample.acceleration = (sample.velocity - velocity_) / period_s_;
  sample.jerk = (sample.acceleration - acceleration_) / period_s_;
  const AxisVector& error = servo_.step(sample.velocity);
  sample.actual = position - error;
  sample.line = mark.line;
  sample.tip_speed_mm_s = mark.tip_speed_mm_s;
  sample.limit = mark.limit;
  sample.limiting_axis = static_cast<std::int8_t>(mark.axis);
  sample.rapid = mark.rapid;
  sample.cutting = mark.cutting;
  position_ = position;
  velocity_ = sample.velocity;
  acceleration_ = sample.acceleration;
  if (filled_ == chunk_.size()) finish();
}

void SampleWriter::finish() {
  statistics_.add_samples(std::span<const AxisSample>(chunk_.data(), filled_));
  if (filled_ > 0 && sink_) sink_(std::span<const AxisSample>(chunk_.data(), filled_));
  filled_ = 0;
}

}  // namespace volute::sim
