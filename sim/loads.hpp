// Force and torque of every drive over a run, by inverse dynamics on the machine's chain.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "kinematics/model/machine.hpp"
#include "sim/chain_dynamics.hpp"
#include "sim/finding.hpp"
#include "sim/trace.hpp"

namespace volute::sim {

struct DriveLoad {
  double peak = 0.0, rms = 0.0;
};  ///< N or Nm

struct LoadsReport {
  bool known = false;  ///< the machine file gives masses
  std::array<DriveLoad, kinematics::axis_count> axes;
  std::vector<Finding> findings;  ///< loads over a limit that a data sheet gives
  std::vector<Finding> warnings;  ///< loads over a limit that rests on assumed numbers of the machine file
};

/// Force (N) or torque (Nm) that each drive gives for one state: inertia, gravity, viscous and dry friction of the
/// links; the part's and the tool's own masses are not in machine files and count as none. `velocity` and
/// `acceleration` per s and s^2 of q's units. Gravity pulls along -z of the base, which is -z of M with every axis at
/// zero. Positive: in the axis's positive direction. Property: force times velocity, summed over the axes, is the
/// change of kinetic and potential energy plus what friction takes. For many states: ChainDynamics.
AxisVector drive_forces(const kinematics::Machine& machine, const AxisVector& q, const AxisVector& velocity,
                        const AxisVector& acceleration);

/// Whether the load of an axis is computed from, or held against, assumed numbers: those of the axis itself and of
/// every axis that it carries.
bool rests_on_assumptions(const kinematics::Machine& machine, int axis);

/// Gathers loads over a run, chunk by chunk. The machine must outlive the meter.
class LoadsMeter {
 public:
  explicit LoadsMeter(const kinematics::Machine& machine);
  void add(std::span<const AxisSample> samples);
  [[nodiscard]] LoadsReport report() const;

 private:
  void take(int axis, double load, const AxisSample& sample);
  [[nodiscard]] Finding overload(std::size_t axis, bool assumed) const;
  const kinematics::Machine* machine_;
  ChainDynamics dynamics_;
  std::array<double, kinematics::axis_count> square_sum_{};
  std::array<std::int64_t, kinematics::axis_count> peak_line_{};
  std::array<double, kinematics::axis_count> peak_time_s_{};
  std::array<AxisVector, kinematics::axis_count> peak_q_{};
  std::int64_t count_ = 0;
  LoadsReport report_;
};

}  // namespace volute::sim
