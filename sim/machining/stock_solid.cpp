// A stock from a closed mesh: every ray's crossings with the triangles, in pairs.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "geometry/number_text.hpp"
#include "sim/machining/stock.hpp"

namespace volute::sim {
namespace {

/// Twice the signed area of (a, b, p), the same number whichever way the edge is named (but for its sign): two
/// triangles that share an edge then never both take a ray, nor both leave it.
double side_of(const Vec2& a, const Vec2& b, const Vec2& p) {
  const bool turned = b.x() < a.x() || (b.x() == a.x() && b.y() < a.y());
  const Vec2 &from = turned ? b : a, &to = turned ? a : b;
  const double value = (to.x() - from.x()) * (p.y() - from.y()) - (to.y() - from.y()) * (p.x() - from.x());
  return turned ? -value : value;
}

/// Height at which a ray through `p` crosses the triangle; nothing when it passes by. Corners in ray coordinates (u, v,
/// height).
std::optional<double> crossing(const std::array<Vec3, 3>& c, const Vec2& p) {
  const Vec2 a = c[0].head<2>(), b = c[1].head<2>(), d = c[2].head<2>();
  const double wa = side_of(b, d, p), wb = side_of(d, a, p), wd = side_of(a, b, p);
  const bool left = wa > 0.0 && wb > 0.0 && wd > 0.0, right = wa < 0.0 && wb < 0.0 && wd < 0.0;
  if (!left && !right) return std::nullopt;
  return (wa * c[0].z() + wb * c[1].z() + wd * c[2].z()) / (wa + wb + wd);
}

/// All crossings of one grid's rays, sorted on each ray.
std::vector<std::vector<double>> crossings(const geometry::TriangleMesh& mesh, const DexelGrid& grid, double grid_mm) {
  // Nodes are moved by a tiny fraction that no drawing uses, so that no ray runs through an edge or a corner.
  const Vec2 nudge = grid_mm * Vec2(1.234567e-7, 2.718281e-7);
  const int axis = grid.axis(), u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<std::vector<double>> out(static_cast<std::size_t>(grid.columns()) *
                                       static_cast<std::size_t>(grid.rows()));
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3, 3> c;
    Eigen::AlignedBox3d box;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.vertices_mm[static_cast<std::size_t>(triangle[k])];
      c[k] = Vec3(p[u], p[v], p[axis]);
      box.extend(p);
    }
    const auto range = grid.range(
        Eigen::AlignedBox3d(Vec3(box.min().array() - 1e-3 * grid_mm), Vec3(box.max().array() + 1e-3 * grid_mm)));
    for (int row = range.row_begin; row < range.row_end; ++row) {
      for (int column = range.column_begin; column < range.column_end; ++column) {
        const Vec3 node = grid.node(column, row);
        const auto height = crossing(c, Vec2(node[u], node[v]) + nudge);
        if (height)
          out[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns()) +
              static_cast<std::size_t>(column)]
              .push_back(*height);
      }
    }
  }
  for (auto& ray : out) std::sort(ray.begin(), ray.end());
  return out;
}

}  // namespace

geometry::Result<Stock> Stock::solid(const geometry::TriangleMesh& mesh, double grid_mm) {
  if (mesh.triangles.empty())
    return geometry::bad_input("stock-empty", "the stock's mesh has no triangles; give a closed solid or a box");
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.vertices_mm) box.extend(p);
  std::array<int, 3> nodes{};
  for (int k = 0; k < 3; ++k)
    nodes[static_cast<std::size_t>(k)] = std::max(1, static_cast<int>(std::ceil(box.sizes()[k] / grid_mm)));
  Stock stock(box.min(), nodes, grid_mm);
  for (DexelGrid& grid : stock.grids_) {
    const auto rays = crossings(mesh, grid, grid_mm);
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        const auto& heights = rays[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns()) +
                                   static_cast<std::size_t>(column)];
        if (heights.size() % 2 != 0) {
          const Vec3 at = grid.node(column, row);
          return geometry::bad_input(
              "stock-not-closed", "the stock's mesh is open: a line along " + std::string(1, "xyz"[grid.axis()]) +
                                      " through (" + geometry::short_text(at.x()) + " " + geometry::short_text(at.y()) +
                                      " " + geometry::short_text(at.z()) + ") crosses it " +
                                      std::to_string(heights.size()) + " times; close its holes or give a box");
        }
        std::vector<Span> spans;
        for (std::size_t i = 0; i + 1 < heights.size(); i += 2) spans.push_back({heights[i], heights[i + 1]});
        if (!spans.empty()) grid.set(column, row, spans);
      }
    }
  }
  return stock;
}

}  // namespace volute::sim
