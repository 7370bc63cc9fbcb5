// How far a path's turns really stand apart, against what the scallop allows there.
#pragma once

#include <vector>

#include "planner/path/cc_path.hpp"
#include "planner/path/path_interval.hpp"

namespace volute::planner {

/// A place on the path and the distance from there to the next turn over the interval allowed between the two.
struct IntervalSample {
  Vec3 point_P_mm;
  double turn = 0.0;
  double ratio = 0.0;  ///< above 1: wider than the scallop allows
};

/// Samples at even spacing (half an interval of flat ground) wherever a next turn, 0.6 to 1.4 turns on, lies within
/// three intervals. Requires: CcPoint::turn grows by one a turn (or a pass); `intervals` of the same mesh.
/// Deterministic on any number of threads.
std::vector<IntervalSample> interval_samples(const TriangleMesh& surface, const IntervalField& intervals,
                                             const CcPath& path);

}  // namespace volute::planner
