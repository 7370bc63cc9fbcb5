// The strategies that others use, for comparison (Table 2 of [Sun2016]).
#pragma once

#include "planner/path/cc_path.hpp"

namespace volute::planner {

/// Parallel slicing planes about z, zigzag: the path pattern of [Sun2016]'s introduction. Holes interrupt passes.
Result<CcPathResult> plan_iso_planar(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                     const PathOptions& options, const OrientationOptions& orientation);

/// Archimedean spiral projected along z ([Sun2016] 7.3, SP path): equal steps in projection; lifted over holes.
Result<CcPathResult> plan_projected_spiral(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                           const PathOptions& options, const OrientationOptions& orientation);

/// Offsets of the boundaries by equal geodesic distance ([Sun2016] 7.3, CP path), loops linked, corners and all.
Result<CcPathResult> plan_contour_offset(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                         const PathOptions& options, const OrientationOptions& orientation);

}  // namespace volute::planner
