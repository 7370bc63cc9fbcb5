// A smooth curve of the axes: what a straight tip and turning rotaries ask of the linear axes, with three derivatives.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "sim/trace.hpp"

namespace volute::sim {

/// A position and its derivatives by the share u of the way.
struct CurvePoint {
  AxisVector position, first, second, third;
};

/// Bounds of the derivatives over a stretch, axis by axis.
struct CurveRange {
  AxisVector first_low, first_high, second_low, second_high, third_low, third_high;
};

/// Polynomials of fifth degree over 0 <= u <= 1 that agree with a function and its first two derivatives where they
/// meet. Property 1: position and its first two derivatives are continuous. 2. The third derivative is bounded, and
/// `range` holds every value of all three. 3. Half-way between two nodes the curve is within `accuracy` of the
/// function.
class AxisCurve {
 public:
  /// Half-way between the nodes (mm, rad): far below what any program prints.
  static constexpr double accuracy = 1e-6;
  /// The axes at a share of the way; also asked for a little beyond both ends. Nothing: no such position.
  using Function = std::function<std::optional<AxisVector>(double u)>;

  /// Nothing: the function has no value somewhere, or `cells_most` polynomials do not follow it. Requires: 1 <= cells
  /// <= cells_most.
  static std::optional<AxisCurve> through(const Function& function, int cells, int cells_most);
  static AxisCurve line(const AxisVector& from, const AxisVector& to);

  [[nodiscard]] AxisVector position(double u) const;
  /// A bound of every |position|.
  [[nodiscard]] AxisVector positions_most() const;
  [[nodiscard]] CurvePoint at(double u) const;
  /// Requires: 0 <= from <= to <= 1.
  [[nodiscard]] CurveRange range(double from, double to) const;

 private:
  /// position = sum of c[k] x^k, 0 <= x <= 1 within the cell.
  struct Cell {
    std::array<AxisVector, 6> c;
  };
  struct Place {
    std::size_t cell;
    double x;
  };
  [[nodiscard]] Place place(double u) const;
  [[nodiscard]] CurvePoint at(const Place& place) const;
  void extend(const Cell& cell, double from, double to, CurveRange& range) const;

  std::vector<Cell> cells_;
};

}  // namespace volute::sim
