// Points in cubic cells: what lies near a place, in a fixed order.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"

namespace volute::planner {

/// Requires: cell_mm > 0. Cells are made larger where they would be more than 2^22. Which cubes they are depends on
/// their size alone, not on the points.
class PointGrid {
 public:
  PointGrid(std::span<const geometry::Vec3> points, double cell_mm) : cell_mm_(cell_mm) {
    geometry::Vec3 low = geometry::Vec3::Constant(1e300), high = -low;
    for (const auto& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    if (points.empty()) low = high = geometry::Vec3::Zero();
    constexpr double cells_max = 4194304.0;
    for (; cells_between(low, high) > cells_max; cell_mm_ *= 1.25) {
    }
    for (int d = 0; d < 3; ++d) {
      first_[static_cast<std::size_t>(d)] = cell_of(low[d]);
      count_[static_cast<std::size_t>(d)] = cell_of(high[d]) - cell_of(low[d]) + 1;
    }
    start_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
    std::vector<std::size_t> cell(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) ++start_[cell[i] = number(points[i])];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    // From the ends of the cells down to their beginnings, so that each keeps the points' order.
    order_.resize(points.size());
    for (std::size_t i = points.size(); i-- > 0;)
      order_[static_cast<std::size_t>(--start_[cell[i]])] = static_cast<geometry::Index>(i);
  }

  /// Calls visit(index) for every point of the cells within `reach_mm` of `place`: all points so near, and some farther
  /// ones.
  template <class Visit>
  void near(const geometry::Vec3& place, double reach_mm, Visit visit) const {
    near_ranges(place, reach_mm, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) visit(order_[i]);
    });
  }
  /// The same as ranges of `order`.
  template <class VisitRange>
  void near_ranges(const geometry::Vec3& place, double reach_mm, VisitRange visit) const {
    std::array<long, 3> from{}, to{};
    for (int d = 0; d < 3; ++d) {
      const auto k = static_cast<std::size_t>(d);
      from[k] = std::max(0L, cell_of(place[d] - reach_mm) - first_[k]);
      to[k] = std::min(count_[k] - 1, cell_of(place[d] + reach_mm) - first_[k]);
    }
    if (from[2] > to[2]) return;
    for (long x = from[0]; x <= to[0]; ++x) {
      for (long y = from[1]; y <= to[1]; ++y) {
        const std::size_t row = static_cast<std::size_t>((x * count_[1] + y) * count_[2]);
        const auto begin = start_[row + static_cast<std::size_t>(from[2])],
                   end = start_[row + static_cast<std::size_t>(to[2]) + 1];
        if (begin < end) visit(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
      }
    }
  }
  /// The points cell by cell.
  [[nodiscard]] const std::vector<geometry::Index>& order() const { return order_; }
  [[nodiscard]] double cell_mm() const { return cell_mm_; }

 private:
  [[nodiscard]] long cell_of(double coordinate_mm) const {
    return static_cast<long>(std::floor(coordinate_mm / cell_mm_));
  }
  [[nodiscard]] double cells_between(const geometry::Vec3& low, const geometry::Vec3& high) const {
    double cells = 1.0;
    for (int d = 0; d < 3; ++d) cells *= std::floor((high[d] - low[d]) / cell_mm_) + 2.0;
    return cells;
  }
  [[nodiscard]] std::size_t number(const geometry::Vec3& p) const {
    const long x = cell_of(p[0]) - first_[0], y = cell_of(p[1]) - first_[1], z = cell_of(p[2]) - first_[2];
    return static_cast<std::size_t>((x * count_[1] + y) * count_[2] + z);
  }

  double cell_mm_;
  std::array<long, 3> first_{}, count_{};
  std::vector<geometry::Index> start_, order_;
};

}  // namespace volute::planner
