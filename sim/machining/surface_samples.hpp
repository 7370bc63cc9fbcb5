// The design surface cut into patches and cells: where deviations are measured.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.hpp"

namespace volute::sim {

using geometry::Vec3;

/// A triangle in space.
struct Cell {
  Vec3 a, b, c;
  [[nodiscard]] Vec3 centroid() const { return (a + b + c) / 3.0; }
  [[nodiscard]] Vec3 at(double u, double v) const { return a + u * (b - a) + v * (c - a); }
};

/// Child `k` (0 <= k < n * n) of a cell whose edges are cut into n: row by row, upright and turned children in turn.
Cell child_cell(const Cell& cell, int n, int k);

/// How a mesh is cut: triangle -> patches (one search of the neighbourhood each) -> cells (one sample at each
/// centroid). Property: the cells of all triangles cover the surface exactly once.
class SurfaceSamples {
 public:
  struct Patch {
    geometry::Index triangle = 0;
    std::int32_t child = 0;  ///< of the triangle cut into patch_cuts[triangle]
    std::int32_t cell_cuts = 1;
    std::int64_t first_sample = 0;
  };
  SurfaceSamples(const geometry::TriangleMesh& mesh, double spacing_mm, double patch_size_mm);

  [[nodiscard]] const std::vector<Patch>& patches() const { return patches_; }
  [[nodiscard]] std::int64_t count() const { return count_; }
  [[nodiscard]] Cell patch_cell(const Patch& patch) const;
  [[nodiscard]] const Vec3& normal(geometry::Index triangle) const {
    return normals_[static_cast<std::size_t>(triangle)];
  }
  /// Area of each sample of the patch.
  [[nodiscard]] double sample_area_mm2(const Patch& patch) const;
  /// The patch that holds a sample.
  [[nodiscard]] const Patch& patch_of(std::int64_t sample) const;

 private:
  const geometry::TriangleMesh* mesh_;
  std::vector<Vec3> normals_;
  std::vector<double> areas_;
  std::vector<std::int32_t> patch_cuts_;
  std::vector<Patch> patches_;
  std::int64_t count_ = 0;
};

}  // namespace volute::sim
