// A coordinate that runs once around an annulus: harmonic, periodic, its seam nowhere in particular.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/result.hpp"
#include "planner/surface/operators.hpp"

namespace volute::planner {

using geometry::Index;
using geometry::Result;

/// Values of a function with a unit jump across an edge path: at corner k of triangle t the value is
/// vertex[triangles[t][k]] + jump[t][k], where jump is 1 at the corners on the left of the path and 0 elsewhere.
struct PeriodicCoordinate {
  std::vector<double> vertex;
  std::vector<std::array<double, 3>> jump;
  std::vector<Index> seam;  ///< the edge path, from its first to its last vertex

  [[nodiscard]] double at_corner(const geometry::TriangleMesh& mesh, Index triangle, int corner) const {
    const auto t = static_cast<std::size_t>(triangle);
    const auto k = static_cast<std::size_t>(corner);
    return vertex[static_cast<std::size_t>(mesh.triangles[t][k])] + jump[t][k];
  }
};

/// The shortest edge path between two boundary loops that meets no boundary vertex between its ends.
/// Errors (bad_input): surface-no-path, where other boundaries leave no such path.
Result<std::vector<Index>> seam_between(const geometry::TriangleMesh& mesh, const geometry::MeshTopology& topology,
                                        const geometry::BoundaryLoop& from, const geometry::BoundaryLoop& to);

/// The jump of `seam`: an edge path between two boundary vertices, inner vertices between. Requires: such a path.
std::vector<std::array<double, 3>> seam_jump(const geometry::MeshTopology& topology, std::span<const Index> seam);

/// The harmonic function with a unit jump across `seam`, free at every boundary (no flux), 0 at the seam's first
/// vertex. It grows by one along any loop that crosses the seam once from its right to its left (counter-clockwise
/// where the seam runs inward). Properties: 1. The gradient does not depend on the seam chosen. 2. On a flat ring it is
/// angle / (2 pi). Errors: as SparseSolver::factor.
Result<PeriodicCoordinate> periodic_harmonic(const geometry::TriangleMesh& mesh, const geometry::MeshTopology& topology,
                                             std::span<const Index> seam);
/// The same with the mesh's triangle_operators and their cotan_laplacian.
Result<PeriodicCoordinate> periodic_harmonic(const geometry::TriangleMesh& mesh, const geometry::MeshTopology& topology,
                                             std::span<const TriangleOperator> operators, const SparseMatrix& laplacian,
                                             std::span<const Index> seam);

}  // namespace volute::planner
