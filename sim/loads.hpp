// Force and torque of every drive over a run, by inverse dynamics on the machine's chain.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "kinematics/model/machine.hpp"
#include "sim/finding.hpp"
#include "sim/trace.hpp"

namespace volute::sim {

struct DriveLoad { double peak = 0.0, rms = 0.0; };  ///< N or Nm

struct LoadsReport {
  bool known = false;   ///< the machine file gives masses
  std::array<DriveLoad, kinematics::axis_count> axes;
  std::vector<Finding> findings;
};

/// Drive forces (N) and torques (Nm) for one state; gravity along -z of M.
AxisVector drive_forces(const kinematics::Machine& machine, const AxisVector& q, const AxisVector& velocity, const AxisVector& acceleration);

/// Gathers loads over a run, chunk by chunk.
class LoadsMeter {
 public:
  explicit LoadsMeter(const kinematics::Machine& machine);
  void add(std::span<const AxisSample> samples);
  [[nodiscard]] LoadsReport report() const;

 private:
  const kinematics::Machine* machine_;
  std::array<double, kinematics::axis_count> square_sum_{};
  std::int64_t count_ = 0;
  LoadsReport report_;
};

}  // namespace volute::sim
