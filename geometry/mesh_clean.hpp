// The steps of cleaning that `weld` is made of. Internal to `geometry`.
#pragma once

#include "geometry/mesh.hpp"

namespace volute::geometry {

/// Removes triangles with two equal corners or with a height of at most `tolerance_mm`. A neighbour across the long
/// edge of such a sliver is split at the sliver's third corner, so that no gap opens. Returns the number removed.
/// Requires: vertex indices in range.
Index remove_degenerate(TriangleMesh& mesh, double tolerance_mm);

/// Removes triangles that have the same three corners as an earlier one, in either sense. Returns the number removed.
Index remove_duplicates(TriangleMesh& mesh);

}  // namespace volute::geometry
