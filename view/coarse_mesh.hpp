// A mesh with fewer triangles that looks the same from where a page or a picture is seen.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/mesh.hpp"

namespace volute::view {

struct CoarseMesh {
  geometry::TriangleMesh mesh;
  std::vector<geometry::Index> cluster_of_vertex;  ///< vertex of the finer mesh -> vertex of `mesh`
};

/// Vertices in one cell of a cubic grid become their mean; triangles that collapse are left out. The cell grows until
/// at most `triangles_max` triangles stand. A mesh that is small enough comes back as it is. For looking at only: two
/// walls closer together than a cell may grow together. Requires: triangles_max >= 1. Deterministic.
CoarseMesh coarse_mesh(const geometry::TriangleMesh& mesh, std::size_t triangles_max);

/// One value a vertex of the coarse mesh: that of largest magnitude among the finer mesh's; NaN only where all are NaN.
std::vector<double> coarse_values(const CoarseMesh& coarse, const std::vector<double>& values);

}  // namespace volute::view
