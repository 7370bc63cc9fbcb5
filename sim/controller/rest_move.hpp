// A rapid from rest to rest that is planned along its path: the tip does not leave its line, and every axis's velocity,
// acceleration and jerk limit is kept without an average.
#pragma once

#include "kinematics/model/control.hpp"
#include "kinematics/model/machine.hpp"
#include "sim/controller/axis_curve.hpp"
#include "sim/controller/s_curve.hpp"

namespace volute::sim {

/// What the axes may do on a move that no average follows. Property: positions of that size, rounded and differenced
/// three times over a servo period, stay below the machine's limits.
struct RestLimits {
  AxisVector velocity, acceleration, jerk;

  /// Nothing: an axis has no limit of jerk, or the servo period is so short that rounding of the positions alone passes
  /// one.
  static std::optional<RestLimits> of(const kinematics::Machine& machine, double servo_period_s,
                                      const AxisVector& positions_most);
};

/// Cycles at rest before and after a move: a third difference of the positions then sees no other motion beside it.
constexpr int settling_cycles = 3;

/// q(u(t)): a curve of the axes, an S-curve for the share u of its way, stretched in time until no limit is passed.
/// With q', q'', q''' by u: the velocity is q' u', the acceleration q' u'' + q'' u'^2, the jerk q' u''' + 3 q'' u' u''
/// + q''' u'^3; all three scale with powers of the duration, so the least duration of a shape is a root. The shape is
/// searched from that of a straight curve with the greatest |q'|. Property 1: velocity, acceleration and jerk of every
/// axis are within `limits` at every moment, by interval arithmetic over stretches of the S-curve. 2. The axes are at
/// rest, without acceleration, at both ends.
class RestMove {
 public:
  /// `least_time_s`: the S-curve's greatest speed u' is at most 1 / this (rapid feed, least block time); 0: free.
  RestMove(AxisCurve curve, const RestLimits& limits, double least_time_s, double tip_length_mm);

  [[nodiscard]] double duration_s() const { return duration_s_; }
  /// Requires: 0 <= time_s <= duration_s().
  [[nodiscard]] AxisVector position(double time_s) const { return curve_.position(law_.at(time_s / duration_s_).way); }
  [[nodiscard]] double tip_speed_mm_s(double time_s) const {
    return tip_length_mm_ / duration_s_ * law_.at(time_s / duration_s_).speed;
  }
  /// What its duration is due to.
  [[nodiscard]] Limit limit() const { return limit_; }
  [[nodiscard]] int limit_axis() const { return limit_axis_; }

 private:
  struct Duration {
    double time_s = 0.0;
    Limit limit = Limit::rapid;
    int axis = -1;
  };
  void search_shape(const RestLimits& limits, double least_time_s);
  [[nodiscard]] Duration duration(const SCurve& law, const RestLimits& limits, double least_time_s, int stretches,
                                  bool points) const;

  AxisCurve curve_;
  SCurve law_;
  double tip_length_mm_;
  double duration_s_ = 0.0;
  Limit limit_ = Limit::rapid;
  int limit_axis_ = -1;
};

}  // namespace volute::sim
