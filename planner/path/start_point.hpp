// A spiral that is already made begins where the user wants.
#pragma once

#include "planner/path/finish_path.hpp"

namespace volute::planner {

/// Lengthens an inward piece by a run along its first pass, in the path's own direction, so that it begins at the
/// place of that pass nearest to `start_P_mm`: for Direction::inward along the outer boundary before its first point,
/// for outward (the piece is reversed later) around its closing loop once more behind its last point. Returns the added
/// length, mm. Requires: two points at least; a surface with a boundary. Where an outward piece ends in no closed loop
/// nothing is added and 0 returned.
/// Properties: 1. What was there before stays, point by point. 2. The added length is below one round of the pass.
double begin_at(CcPiece& inward_piece, const TriangleMesh& surface, const geometry::MeshTopology& topology,
                const Vec3& start_P_mm, Direction direction, Sense sense);

}  // namespace volute::planner
