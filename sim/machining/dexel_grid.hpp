// One family of parallel rays through the stock: what is left on each.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "sim/machining/line_span.hpp"

namespace volute::sim {

/// Rays along one axis of the part's frame at the nodes of a square grid. On each ray the material is a list of spans,
/// apart and rising. Rows (nodes of equal second coordinate) are independent: different threads may change different
/// rows.
class DexelGrid {
 public:
  /// `axis` 0, 1, 2: rays along x, y, z. Nodes stand at low + (i + 1/2) grid in the two other axes (axis + 1, axis + 2,
  /// cyclic).
  DexelGrid(int axis, const Vec3& low_mm, const std::array<int, 3>& nodes, double grid_mm);

  [[nodiscard]] int axis() const { return axis_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double grid_mm() const { return grid_mm_; }
  [[nodiscard]] Vec3 direction() const { return Vec3::Unit(axis_); }
  /// The node, with 0 in the ray's own coordinate.
  [[nodiscard]] Vec3 node(int column, int row) const;
  /// Columns [first, second) and rows likewise of the nodes inside a box.
  struct Range {
    int column_begin = 0, column_end = 0, row_begin = 0, row_end = 0;
  };
  [[nodiscard]] Range range(const Eigen::AlignedBox3d& box) const;

  /// Spans of one ray, rising. Most rays have none or one.
  template <class Visit>
  void visit(int column, int row, Visit&& visit_span) const {
    const Ray& ray = at(column, row);
    if (ray.low_mm < ray.high_mm) visit_span(Span{ray.low_mm, ray.high_mm});
    if (ray.more < 0) return;
    for (const Span& span : more_[static_cast<std::size_t>(row)][static_cast<std::size_t>(ray.more)]) visit_span(span);
  }
  /// Quick: whether anything is left on the ray between two heights of its first and last material.
  [[nodiscard]] bool reaches(int column, int row, double low_mm, double high_mm) const {
    const Ray& ray = at(column, row);
    return ray.low_mm < ray.high_mm && ray.low_mm < high_mm && ray.top_mm > low_mm;
  }
  void set(int column, int row, const std::vector<Span>& spans);
  /// Takes a span away; returns the length that was material.
  double remove(int column, int row, const Span& span);
  /// The length of material inside a span.
  [[nodiscard]] double overlap(int column, int row, const Span& span) const;
  [[nodiscard]] double length_mm() const;

 private:
  /// The first span inline, further ones in the row's store; `top_mm`: the end of the last span.
  struct Ray {
    double low_mm = 0.0, high_mm = 0.0, top_mm = 0.0;
    std::int32_t more = -1;
  };
  [[nodiscard]] const Ray& at(int column, int row) const {
    return rays_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  }
  [[nodiscard]] Ray& at(int column, int row) {
    return rays_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  }
  double remove_slowly(int column, int row, const Span& span);

  int axis_;
  Vec3 low_mm_;
  double grid_mm_;
  int columns_, rows_;
  std::vector<Ray> rays_;
  std::vector<std::vector<std::vector<Span>>>
      more_;  // [row][store]: the second and further spans of rays that have them
};

}  // namespace volute::sim
