// A run thinned for drawing and playback.
#pragma once

#include <span>
#include <vector>

#include "kinematics/model/machine.hpp"
#include "sim/trace.hpp"

namespace volute::sim {

/// Keeps two samples of every stretch of equally many cycles: its first, and the one that comes closest to some axis's
/// limit of velocity, acceleration or jerk. When there are too many, neighbouring stretches are joined. Properties: 1.
/// At most `samples_max` samples, in order of time. 2. The first, the last and the greatest peak of the run are kept.
class TraceThinner {
 public:
  /// The machine must outlive the thinner. Requires: samples_max >= 8.
  TraceThinner(const kinematics::Machine& machine, std::size_t samples_max)
      : machine_(&machine), stretches_max_(samples_max / 2 - 1) {}
  void add(std::span<const AxisSample> samples);
  [[nodiscard]] std::vector<AxisSample> finish() const;

 private:
  struct Stretch {
    AxisSample first, peak;
    double peak_ratio = -1.0;
    std::int64_t count = 0;
  };
  void join();
  const kinematics::Machine* machine_;
  std::size_t stretches_max_;
  std::int64_t stretch_samples_ = 1;
  std::vector<Stretch> stretches_;
  AxisSample last_;
};

}  // namespace volute::sim
