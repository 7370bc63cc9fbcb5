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
    std::vector<std::size_t> column(points.size());
    std::vector<long> height(points.size());
    std::vector<geometry::Index> next(static_cast<std::size_t>(count_[0] * count_[1]) + 1, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const geometry::Vec3& p = points[i];
      column[i] = column_of(cell_of(p[0]) - first_[0], cell_of(p[1]) - first_[1]);
      height[i] = cell_of(p[2]) - first_[2];
      ++next[column[i]];
    }
    for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
    // From the ends of the columns down to their beginnings, so that each keeps the points' order.
    order_.resize(points.size());
    for (std::size_t i = points.size(); i-- > 0;)
      order_[static_cast<std::size_t>(--next[column[i]])] = static_cast<geometry::Index>(i);
    find_cells(next, height);
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
        const std::size_t c = column_of(x, y);
        auto first = cells_.begin() + column_[c];
        const auto last = cells_.begin() + column_[c + 1];
        constexpr std::ptrdiff_t few = 8;  // cells of a column that are looked through one by one
        if (last - first > few)
          first = std::partition_point(first, last, [&](const Cell& cell) { return cell.height < from[2]; });
        while (first != last && first->height < from[2]) ++first;
        auto end = first;
        while (end != last && end->height <= to[2]) ++end;
        if (first != end) visit(first->begin, end == cells_.end() ? order_.size() : end->begin);
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
  [[nodiscard]] std::size_t column_of(long x, long y) const { return static_cast<std::size_t>(x * count_[1] + y); }

  /// Sorts the points of each column by height and names the cells that hold any. `begin`: of each column in `order_`.
  void find_cells(std::span<const geometry::Index> begin, std::span<const long> height) {
    column_.reserve(begin.size());
    const auto height_of = [&](geometry::Index i) { return height[static_cast<std::size_t>(i)]; };
    for (std::size_t c = 0; c + 1 < begin.size(); ++c) {
      column_.push_back(static_cast<std::ptrdiff_t>(cells_.size()));
      const auto first = order_.begin() + begin[c], last = order_.begin() + begin[c + 1];
      const auto lower = [&](geometry::Index a, geometry::Index b) { return height_of(a) < height_of(b); };
      if (!std::is_sorted(first, last, lower)) std::stable_sort(first, last, lower);
      for (auto i = first; i != last; ++i) {
        if (i == first || height_of(*i) != height_of(*(i - 1)))
          cells_.push_back({height_of(*i), static_cast<std::size_t>(i - order_.begin())});
      }
    }
    column_.push_back(static_cast<std::ptrdiff_t>(cells_.size()));
  }

  /// Cells of a column that hold points, from below; a cell ends where the next one begins.
  struct Cell {
    long height;
    std::size_t begin;  ///< in order_
  };

  double cell_mm_;
  std::array<long, 3> first_{}, count_{};
  std::vector<Cell> cells_;
  std::vector<std::ptrdiff_t> column_;  ///< first cell of each column along z
  std::vector<geometry::Index> order_;
};

}  // namespace volute::planner
