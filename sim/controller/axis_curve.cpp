#include "sim/controller/axis_curve.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::sim {

namespace {

/// Differences of sixth order over a quarter of a cell give the derivatives at its ends: their error falls with the
/// sixth power of the cell, as the polynomial's own.
constexpr int steps_of_a_cell = 4, steps_beyond = 3;

struct Node {
  AxisVector value, first, second;  ///< by the cell's own parameter
};

Node node_at(const std::vector<AxisVector>& f, std::size_t i) {
  constexpr double step = 1.0 / steps_of_a_cell;
  Node node;
  node.value = f[i];
  node.first = (45.0 * (f[i + 1] - f[i - 1]) - 9.0 * (f[i + 2] - f[i - 2]) + (f[i + 3] - f[i - 3])) / (60.0 * step);
  node.second =
      (270.0 * (f[i + 1] + f[i - 1]) - 27.0 * (f[i + 2] + f[i - 2]) + 2.0 * (f[i + 3] + f[i - 3]) - 490.0 * f[i]) /
      (180.0 * step * step);
  return node;
}

std::array<AxisVector, 6> between(const Node& a, const Node& b) {
  const AxisVector way = b.value - a.value - a.first - 0.5 * a.second, rise = b.first - a.first - a.second,
                   bend = b.second - a.second;
  return {a.value,
          a.first,
          0.5 * a.second,
          10.0 * way - 4.0 * rise + 0.5 * bend,
          -15.0 * way + 7.0 * rise - bend,
          6.0 * way - 3.0 * rise + 0.5 * bend};
}

}  // namespace

std::optional<AxisCurve> AxisCurve::through(const Function& function, int cells, int cells_most) {
  VOLUTE_CHECK(cells >= 1 && cells <= cells_most, cells, cells_most);
  for (; cells <= cells_most; cells *= 2) {
    const int steps = cells * steps_of_a_cell;
    std::vector<AxisVector> f;
    f.reserve(static_cast<std::size_t>(steps + 2 * steps_beyond + 1));
    for (int k = -steps_beyond; k <= steps + steps_beyond; ++k) {
      const auto q = function(static_cast<double>(k) / steps);
      if (!q) return std::nullopt;
      f.push_back(*q);
    }
    AxisCurve curve;
    double off = 0.0;
    Node from = node_at(f, steps_beyond);
    for (int cell = 0; cell < cells; ++cell) {
      const auto at = static_cast<std::size_t>(steps_beyond + cell * steps_of_a_cell);
      const Node to = node_at(f, at + steps_of_a_cell);
      curve.cells_.push_back({between(from, to)});
      off = std::max(off, (curve.at(Place{static_cast<std::size_t>(cell), 0.5}).position - f[at + steps_of_a_cell / 2])
                              .cwiseAbs()
                              .maxCoeff());
      from = to;
    }
    if (off <= accuracy) return curve;
  }
  return std::nullopt;
}

AxisCurve AxisCurve::line(const AxisVector& from, const AxisVector& to) {
  AxisCurve curve;
  Cell cell;
  cell.c.fill(AxisVector::Zero());
  cell.c[0] = from;
  cell.c[1] = to - from;
  curve.cells_.push_back(cell);
  return curve;
}

AxisCurve::Place AxisCurve::place(double u) const {
  const double at = u * static_cast<double>(cells_.size());
  const auto cell = std::min(cells_.size() - 1, static_cast<std::size_t>(std::max(0.0, at)));
  return {cell, at - static_cast<double>(cell)};
}

AxisVector AxisCurve::position(double u) const {
  const auto [cell, x] = place(u);
  const auto& c = cells_[cell].c;
  return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
}

AxisVector AxisCurve::positions_most() const {
  AxisVector most = AxisVector::Zero();
  for (const Cell& cell : cells_) {
    AxisVector sum = AxisVector::Zero();
    for (const AxisVector& c : cell.c) sum += c.cwiseAbs();
    most = most.cwiseMax(sum);
  }
  return most;
}

CurvePoint AxisCurve::at(double u) const { return at(place(u)); }

CurvePoint AxisCurve::at(const Place& place) const {
  const double x = place.x, n = static_cast<double>(cells_.size());
  const auto& c = cells_[place.cell].c;
  return {c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5])))),
          n * (c[1] + x * (2.0 * c[2] + x * (3.0 * c[3] + x * (4.0 * c[4] + x * 5.0 * c[5])))),
          n * n * (2.0 * c[2] + x * (6.0 * c[3] + x * (12.0 * c[4] + x * 20.0 * c[5]))),
          n * n * n * (6.0 * c[3] + x * (24.0 * c[4] + x * 60.0 * c[5]))};
}

// Each derivative is its value in the middle and, by Taylor's exact sum, no more than the higher ones there beside it.
void AxisCurve::extend(const Cell& cell, double from, double to, CurveRange& range) const {
  const double x = 0.5 * (from + to), r = 0.5 * (to - from), n = static_cast<double>(cells_.size());
  const auto& c = cell.c;
  const AxisVector fifth = (120.0 * c[5]).cwiseAbs(), fourth_value = 24.0 * c[4] + x * 120.0 * c[5];
  const AxisVector fourth = fourth_value.cwiseAbs();
  const AxisVector third = 6.0 * c[3] + x * (24.0 * c[4] + x * 60.0 * c[5]);
  const AxisVector second = 2.0 * c[2] + x * (6.0 * c[3] + x * (12.0 * c[4] + x * 20.0 * c[5]));
  const AxisVector first = c[1] + x * (2.0 * c[2] + x * (3.0 * c[3] + x * (4.0 * c[4] + x * 5.0 * c[5])));
  const AxisVector third_off = r * (fourth + (r / 2.0) * fifth);
  const AxisVector second_off = r * (third.cwiseAbs() + (r / 2.0) * (fourth + (r / 3.0) * fifth));
  const AxisVector first_off =
      r * (second.cwiseAbs() + (r / 2.0) * (third.cwiseAbs() + (r / 3.0) * (fourth + (r / 4.0) * fifth)));
  range.first_low = range.first_low.cwiseMin(n * (first - first_off));
  range.first_high = range.first_high.cwiseMax(n * (first + first_off));
  range.second_low = range.second_low.cwiseMin(n * n * (second - second_off));
  range.second_high = range.second_high.cwiseMax(n * n * (second + second_off));
  range.third_low = range.third_low.cwiseMin(n * n * n * (third - third_off));
  range.third_high = range.third_high.cwiseMax(n * n * n * (third + third_off));
}

CurveRange AxisCurve::range(double from, double to) const {
  VOLUTE_CHECK(from <= to, from, to);
  constexpr double all = std::numeric_limits<double>::infinity();
  const AxisVector high = AxisVector::Constant(all), low = AxisVector::Constant(-all);
  CurveRange range{high, low, high, low, high, low};
  const Place first = place(from), last = place(to);
  for (std::size_t cell = first.cell; cell <= last.cell; ++cell)
    extend(cells_[cell], cell == first.cell ? first.x : 0.0, cell == last.cell ? last.x : 1.0, range);
  return range;
}

}  // namespace volute::sim
