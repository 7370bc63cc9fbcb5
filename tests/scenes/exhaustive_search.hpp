// Plain FCL at every orientation of a raster: no trees of ours, no bounds, no adaptive anything.
#pragma once

#include "planner/plan.hpp"

namespace volute::scenes {

/// How many of the raster's orientations at a contact are allowed. The raster: directions `step` apart over all tilts
/// from the normal that the options allow.
struct SearchResult {
  int tried = 0, allowed = 0;
};
SearchResult search_exhaustively(const planner::PlanRequest& request, const geometry::Vec3& contact_P_mm,
                                 const geometry::Vec3& normal_P, geometry::Angle step);

}  // namespace volute::scenes
