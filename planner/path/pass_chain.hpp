// Passes in order, joined on the surface where they are near and by rapids where they are not: what the baselines
// share.
#pragma once

#include <vector>

#include "planner/path/finish_path.hpp"
#include "planner/path/path_measure.hpp"
#include "planner/path/surface_locator.hpp"

namespace volute::planner {

/// The interval that holds the scallop on all but 1 % of the area, whichever way the passes run. mm
double constant_interval_mm(const TriangleMesh& mesh, const IntervalField& intervals);

/// Raw points along the surface between two places that are near each other: the chord, put onto the surface.
std::vector<RawPoint> link_across(const SurfaceLocator& locator, const RawPoint& from, const RawPoint& to,
                                  double spacing_mm);

/// Stretches that run one into the next; a new run starts with a rapid traversal.
using Run = std::vector<RawStretch>;

/// Pieces from runs, and the counts that follow from them: rapids = pieces - 1, liftings = 2 a piece (Table 2 counts
/// so).
void finish_runs(const std::vector<Run>& runs, const PathOptions& options, const CurveOptions& curve,
                 CcPathResult& result);

}  // namespace volute::planner
