// The centre of a surface without holes: a slit along its deepest ridge for a spiral to end in.
#pragma once

#include "geometry/mesh.hpp"
#include "geometry/result.hpp"
#include "planner/surface/surface_path.hpp"

namespace volute::planner {

using geometry::Result;

/// A path of at least three points inside the surface, through its deepest part and along it. Depth is the solution u
/// of -Laplace(u) = 1 with u = 0 on the boundary; where u >= 0.9 of its greatest value the surface looks like an
/// ellipse, whose focal segment (shortened to 0.8) is the slit. On a round surface it shrinks to two edges. Requires:
/// one boundary loop at least. Errors (bad_input): surface-too-coarse (no inner vertex with room around it). Property:
/// the slit of a flat ellipse lies on its long axis, about its centre.
Result<SurfacePath> centre_slit(const TriangleMesh& mesh, const geometry::MeshTopology& topology);

}  // namespace volute::planner
