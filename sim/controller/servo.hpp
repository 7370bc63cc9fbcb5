// The position loop of each axis: how far the axis stands behind its command.
#pragma once

#include "kinematics/model/control.hpp"
#include "kinematics/model/machine.hpp"
#include "sim/controller/sample_columns.hpp"

namespace volute::sim {

/// A proportional position loop with velocity feed-forward f: d(actual)/dt = Kv (command - actual) + f d(command)/dt,
/// solved exactly for a command that moves evenly within each period. At constant velocity v the following error is (1
/// - f) v / Kv. An axis without a gain (0) follows its command exactly.
class Servo {
 public:
  Servo(const kinematics::Machine& machine, const kinematics::Control& control);
  void rest() { error_.setZero(); }
  /// Every axis follows its command without error.
  [[nodiscard]] bool exact() const { return gain_.isZero(0.0); }
  /// The following error (command - actual) at the end of a period in which the command moved at `velocity`.
  const kinematics::AxisVector& step(const kinematics::AxisVector& velocity) {
    error_ = keep_.cwiseProduct(error_) + gain_.cwiseProduct(velocity);
    return error_;
  }
  /// The same for a lot of periods: sets `samples.error`.
  void step(SampleColumns& samples);

 private:
  kinematics::AxisVector keep_ = kinematics::AxisVector::Zero(), gain_ = kinematics::AxisVector::Zero(),
                         error_ = kinematics::AxisVector::Zero();
};

}  // namespace volute::sim
