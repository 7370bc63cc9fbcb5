#include "sim/machining/surface_samples.hpp"

#include <algorithm>
#include <cmath>

namespace volute::sim {
namespace {

Cell triangle_cell(const geometry::TriangleMesh& mesh, geometry::Index triangle) {
  const auto& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
  return {mesh.vertices_mm[static_cast<std::size_t>(corners[0])],
          mesh.vertices_mm[static_cast<std::size_t>(corners[1])],
          mesh.vertices_mm[static_cast<std::size_t>(corners[2])]};
}

double longest_edge(const Cell& cell) {
  return std::max({(cell.b - cell.a).norm(), (cell.c - cell.b).norm(), (cell.a - cell.c).norm()});
}

std::int32_t cuts_for(double edge_mm, double size_mm) {
  return std::max(1, static_cast<std::int32_t>(std::ceil(edge_mm / size_mm - 1e-9)));
}

}  // namespace

Cell child_cell(const Cell& cell, int n, int k) {
  // Row r has 2 (n - r) - 1 children and begins at r (2 n - r).
  int row = 0;
  while (row + 1 < n && (row + 1) * (2 * n - row - 1) <= k) ++row;
  const int place = k - row * (2 * n - row);
  const int column = place / 2;
  const double step = 1.0 / n, u = column * step, v = row * step;
  if (place % 2 == 0) return {cell.at(u, v), cell.at(u + step, v), cell.at(u, v + step)};
  return {cell.at(u + step, v + step), cell.at(u, v + step), cell.at(u + step, v)};
}

SurfaceSamples::SurfaceSamples(const geometry::TriangleMesh& mesh, double spacing_mm, double patch_size_mm)
    : mesh_(&mesh) {
  const auto triangles = static_cast<geometry::Index>(mesh.triangles.size());
  normals_.reserve(mesh.triangles.size());
  for (geometry::Index t = 0; t < triangles; ++t) {
    const Cell cell = triangle_cell(mesh, t);
    const Vec3 cross = (cell.b - cell.a).cross(cell.c - cell.a);
    areas_.push_back(0.5 * cross.norm());
    normals_.push_back(cross.normalized());
    const double edge = longest_edge(cell);
    const std::int32_t patches = cuts_for(edge, patch_size_mm);
    // One sample for each square of the spacing, and none farther apart than twice that in a sliver.
    const double side = std::max(std::sqrt(areas_.back()), 0.5 * edge) / patches;
    const std::int32_t cells = cuts_for(side, spacing_mm);
    patch_cuts_.push_back(patches);
    for (std::int32_t k = 0; k < patches * patches; ++k) {
      patches_.push_back({t, k, cells, count_});
      count_ += static_cast<std::int64_t>(cells) * cells;
    }
  }
}

Cell SurfaceSamples::patch_cell(const Patch& patch) const {
  return child_cell(triangle_cell(*mesh_, patch.triangle), patch_cuts_[static_cast<std::size_t>(patch.triangle)],
                    patch.child);
}

double SurfaceSamples::sample_area_mm2(const Patch& patch) const {
  const double cuts = static_cast<double>(patch_cuts_[static_cast<std::size_t>(patch.triangle)]) * patch.cell_cuts;
  return areas_[static_cast<std::size_t>(patch.triangle)] / (cuts * cuts);
}

const SurfaceSamples::Patch& SurfaceSamples::patch_of(std::int64_t sample) const {
  const auto after = std::upper_bound(patches_.begin(), patches_.end(), sample,
                                      [](std::int64_t s, const Patch& p) { return s < p.first_sample; });
  return *(after - 1);
}

}  // namespace volute::sim
