// Spirals and contour-parallel passes that follow a map: methods paper and periodic.
#pragma once

#include "planner/path/cc_path.hpp"

namespace volute::planner {

/// Strategies spiral and contour_parallel, methods paper and periodic. Method even: as periodic, with a note.
/// Errors (bad_input): surface-*, path-broken, path-turns (no part of the path lies between the turns asked for).
Result<CcPathResult> plan_guided_path(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                      const PathOptions& options, const OrientationOptions& orientation);

}  // namespace volute::planner
