// A rotary axis over arc length as a uniform cubic B-spline: two continuous derivatives, whatever the spacing of the CC
// points.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "planner/orientation/rotary_chart.hpp"

namespace volute::planner {

/// Knots every step_mm from 0 to the end. Coefficient j acts round s = (j - 1) step_mm.
class SplineGrid {
 public:
  /// The step is at most `step_mm`, so that the knots end where the path does.
  SplineGrid(double length_mm, double step_mm);

  struct Weights {
    int first;
    std::array<double, 4> weight;
  };
  [[nodiscard]] Weights at(double s_mm) const;
  [[nodiscard]] double value(std::span<const double> coefficients, double s_mm) const;
  [[nodiscard]] int coefficients() const { return spans_ + 3; }
  [[nodiscard]] double step_mm() const { return step_mm_; }
  /// Where coefficient j acts, clamped into the path.
  [[nodiscard]] double place_mm(int j) const;

 private:
  int spans_;
  double step_mm_;
};

}  // namespace volute::planner
