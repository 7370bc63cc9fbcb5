// The judge of scallops: no grid, no field.
#pragma once

#include "planner/path/cc_path.hpp"

namespace volute::planner::samples {

/// For random points of random triangles, the least entry of the normal into any ball of the path; the greatest of
/// them over the allowed height.
double greatest_scallop_ratio(const geometry::TriangleMesh& mesh, const CcPath& path, double radius_mm,
                              double scallop_mm, int count, unsigned seed);

}  // namespace volute::planner::samples
