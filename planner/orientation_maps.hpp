// C-space maps of a finished plan: what was allowed at chosen CC points, and what the plan chose.
#pragma once

#include <vector>

#include "planner/orientation/cspace.hpp"
#include "planner/orientation/narrowest.hpp"
#include "planner/plan.hpp"

namespace volute::planner {

struct MapRequest {
  std::vector<int> cut_points;  ///< indices among the cutting points (cuts and links) in the order of the path
  /// And so many more: where the least share of the directions is allowed, of 200 places along the path and of those
  /// 1 mm apart round the narrowest of them.
  int worst = 0;
  CspaceOptions cspace;
  double neighbours_mm = 15.0;  ///< the chosen orientations this far before and after are drawn too
};

/// Maps in the order of `cut_points`, then the worst, each at least 5 mm along the path from those before it. Requires:
/// `plan` is the result of plan(request). Errors (bad_input): map-point (an index past the path).
geometry::Result<std::vector<kinematics::OrientationMap>> orientation_maps(const PlanRequest& request,
                                                                           const PlanResult& plan,
                                                                           const MapRequest& maps);

}  // namespace volute::planner
