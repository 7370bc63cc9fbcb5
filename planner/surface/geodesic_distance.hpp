// Distance along the surface from a set of vertices.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/result.hpp"

namespace volute::planner {

/// Distance of every vertex from the nearest of `sources` along the surface, mm: a short heat flow from the sources,
/// its direction made unit, the function whose gradient fits best (Crane, Weischedel, Wardetzky 2013). Never below 0,
/// exactly 0 at the sources. Accuracy: a few per cent of the edge length beside sources, about 1 % of the distance away
/// from ridges, which it rounds over an edge or two. Requires: one source at least. Errors: as SparseSolver::factor.
geometry::Result<std::vector<double>> geodesic_distance_mm(const geometry::TriangleMesh& mesh,
                                                           std::span<const geometry::Index> sources);

}  // namespace volute::planner
