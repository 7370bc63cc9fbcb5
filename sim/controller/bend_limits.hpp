// The acceleration limits of one curved cell as bounds between its squared speeds at both ends.
#pragma once

#include <array>

#include "sim/controller/path_cells.hpp"

namespace volute::sim {

/// |from_weight[j] x0 + to_weight[j] x1| <= 1 for x = (ds/dt)^2 at the cell's start and end: each axis at each end.
class BendLimits {
 public:
  explicit BendLimits(const PathCell& cell);

  struct Answer {
    double sq = 0.0;
    int axis = -1;  ///< whose bound decided; -1: none
  };
  /// The greatest x0 for which some x1 in [0, end_sq_max] keeps all bounds.
  [[nodiscard]] Answer greatest_start(double end_sq_max, double start_sq_max) const;
  /// The greatest x1 <= end_sq_max for this x0. Requires: some x1 keeps all bounds.
  [[nodiscard]] Answer greatest_end(double start_sq, double end_sq_max) const;

 private:
  struct Line {
    double at_zero = 0.0, slope = 0.0;
    int axis = -1;
  };
  struct Bounds {
    Line upper, lower;
  };
  [[nodiscard]] Line bound_at(double end_sq) const;
  [[nodiscard]] Bounds bounds_at(double end_sq) const;
  [[nodiscard]] double greatest_feasible_end(double end_sq_max) const;

  static constexpr int count = 2 * kinematics::axis_count;
  std::array<double, count> from_weight_{}, to_weight_{};
};

}  // namespace volute::sim
