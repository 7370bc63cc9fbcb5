// Where a cutter without a ball nose reaches deepest below the surface: sought from the cutter's side, because the
// notch of a sharp tilted corner is narrower than the spacing of any samples.
#pragma once

#include <vector>

#include "sim/machining/cut_measure.hpp"
#include "sim/machining/surface_facets.hpp"

namespace volute::sim {

/// For every place of the cutter and every triangle near it: where on the triangle the cutter reaches deepest below it,
/// exact however narrow the notch. That is the foot of the cutter's deepest point against the triangle's normal, where
/// the foot lies on the triangle; else a point of an edge that the foot lies beyond, by golden section on the concave
/// depth along it. Returned: the deepest that lie more than `beyond_mm` below, as the cut surface defines gouges, the
/// deepest first, at most one in a cube of the cutter's radius on each triangle and `most` in all. A ball nose needs no
/// such search and gives nothing. Property: the result does not depend on the number of threads.
std::vector<Extreme> deepest_notches(const SweptCutter& cutter, const SurfaceFacets& facets, double beyond_mm,
                                     std::size_t most);

}  // namespace volute::sim
