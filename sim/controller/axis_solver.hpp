// Axes from a tip and an axis vector, found from the forward chain alone.
#pragma once

#include <array>
#include <optional>

#include "sim/controller/path_point.hpp"

namespace volute::sim {

/// What a TCP control computes at every point: one walk along the chain, a solve of 3 x 3, Newton's steps. Closed-form
/// inverse kinematics elsewhere are so judged by something that shares nothing with them.
class AxisSolver {
 public:
  /// `machine` must outlive the solver.
  AxisSolver(const kinematics::Machine& machine, const kinematics::Setup& setup, double tool_length_mm);

  struct State {
    Vec3 tip_P_mm;
    Vec3 axis_P;
    TipRates tip_rates;  ///< in M
  };
  [[nodiscard]] State state(const AxisVector& q) const;

  /// The linear axes that bring the tip to `tip_P_mm` while the rotaries stand as in `q`: the tip is affine in them, so
  /// one solve of 3 x 3 is exact. `tip_rates` receives those of the result. Nothing: the linear axes do not span space.
  [[nodiscard]] std::optional<AxisVector> with_tip(const Vec3& tip_P_mm, const AxisVector& q,
                                                   TipRates* tip_rates = nullptr) const;

  /// The rotaries that point the tool along `axis_P`, by Newton from `q` and from its mirror over the pole. Of the two
  /// answers the one with the smaller move of the master (the rotary nearer the workpiece), then of the slave, then
  /// nearer zero (Fanuc's rule for vectors, [F-79348]). At the pole the master stays. Nothing: no position of the
  /// rotaries points there.
  [[nodiscard]] std::optional<std::array<double, 2>> rotaries_along(const Vec3& axis_P, const AxisVector& q) const;

 private:
  /// The chain at one position: directions of all axes and the rotaries' points in M, tip and tool axis.
  struct Walk {
    std::array<Vec3, kinematics::axis_count> direction, point;
    Vec3 tip, tool;
  };
  [[nodiscard]] Walk walk(const AxisVector& q) const;
  [[nodiscard]] TipRates rates_of(const Walk& walk) const;
  [[nodiscard]] std::optional<std::array<double, 2>> newton(const Vec3& axis_M, AxisVector q) const;
  [[nodiscard]] double pole_of_slave() const;

  const kinematics::Machine& machine_;
  kinematics::Transform part_in_machine_, machine_in_part_;
  int master_ = 3, slave_ = 4;
  double slave_at_pole_rad_ = 0.0;
  Vec3 tip_at_zero_M_mm_, tool_at_zero_M_;
};

}  // namespace volute::sim
