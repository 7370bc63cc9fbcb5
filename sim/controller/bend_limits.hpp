// The acceleration limits of one curved cell as bounds between its squared speeds at both ends.
#pragma once

#include <array>
#include <cstddef>

#include "sim/controller/path_cells.hpp"

namespace volute::sim {

/// |from_weight[j] x0 + to_weight[j] x1| <= 1 for x = (ds/dt)^2 at the cell's start and end: each axis at each end.
class BendLimits {
 public:
  BendLimits() = default;
  explicit BendLimits(const PathCell& cell);

  struct Answer {
    double sq = 0.0;
    int axis = -1;  ///< whose bound decided; -1: none
  };
  /// The greatest x0 for which some x1 in [0, end_sq_max] keeps all bounds.
  [[nodiscard]] Answer greatest_start(double end_sq_max, double start_sq_max);
  /// The greatest x1 <= end_sq_max for this x0. Requires: some x1 keeps all bounds.
  [[nodiscard]] Answer greatest_end(double start_sq, double end_sq_max) const;

 private:
  /// A bound on x0 as a line in x1.
  struct Line {
    double at_zero = 0.0, slope = 0.0;
    int axis = -1;
    [[nodiscard]] double at(double end_sq) const { return at_zero + slope * end_sq; }
  };
  /// The two speeds keep all bounds.
  [[nodiscard]] bool hold(double start_sq, double end_sq) const;
  static int axis_of(std::size_t bound) { return static_cast<int>(bound) % kinematics::axis_count; }
  void make_lines();
  [[nodiscard]] Line lowest_upper(double end_sq) const;
  [[nodiscard]] Line highest_lower(double end_sq) const;
  [[nodiscard]] double greatest_feasible_end(double end_sq_max) const;

  static constexpr std::size_t count = 2 * kinematics::axis_count;
  std::array<double, count> from_weight_{}, to_weight_{};
  /// The upper bounds on x0 are at_zero_[j] + slope_[j] x1, the lower ones -at_zero_[j] + slope_[j] x1.
  std::array<double, count> at_zero_, slope_;
  bool lines_made_ = false;       ///< of at_zero_, slope_ and end_sq_max_: most cells never need them
  double end_sq_max_ = no_limit;  ///< from bounds in which x0 does not occur
};

}  // namespace volute::sim
