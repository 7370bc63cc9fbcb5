// method = "even": one spiral over any number of holes, passes as far apart as the scallop allows, almost everywhere.
#pragma once

#include "planner/path/cc_path.hpp"

namespace volute::planner {

/// Conditions the mesh, chooses a centre, optimises the field (even_field.hpp), traces the path and corrects it by the
/// dense scallop map. A path over 1.5 times that of a plane as large is looked for again with sharper bends; a note
/// says what they save. Requires: a machinable surface; 0 < scallop < radius. The path runs inward, counter-clockwise
/// seen from outside. Errors (bad_input): path-even-broken where no field holds one piece (use method "periodic");
/// path-centre-loop; surface-*. Deterministic: the same bytes on any number of threads. Properties: 1. One piece. 2.
/// Scallop measured densely as the report says. 3. length_mm >= lower_bound_mm. Departs from [Sun2016]: no bridges and
/// no fixed seam; holes float in the field, and the increment is right everywhere.
Result<CcPathResult> plan_even_spiral(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                      const PathOptions& options, const OrientationOptions& orientation);

}  // namespace volute::planner
