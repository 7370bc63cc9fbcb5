// Where the even spiral ends: the user's boundary loop, or the centre that promises the shortest path.
#pragma once

#include "planner/options.hpp"
#include "planner/path/even_domain.hpp"

namespace volute::planner {

/// `options.centre_loop` where the user names one; else a slit in the deepest part of the surface.
/// Errors (bad_input): path-centre-loop (no such loop), surface-too-coarse.
Result<Centre> choose_centre(const EvenSurface& surface, const IntervalRule& rule, const PathOptions& options);

}  // namespace volute::planner
