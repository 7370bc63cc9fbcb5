// Where a cutter without a ball nose reaches deepest below the surface: sought from the cutter's side, because the
// notch of a sharp tilted corner is narrower than the spacing of any samples.
#pragma once

#include <vector>

#include "sim/machining/cut_measure.hpp"

namespace volute::sim {

/// For every place of the cutter and every triangle near it: the deepest point of the cutter against the triangle's
/// normal, where its foot lies on that triangle, is the deepest that this place reaches below the triangle: exact,
/// however narrow the notch. Returned: the deepest that lie more than `beyond_mm` below, as the cut surface defines
/// deviations, the deepest first, at most one in a cube of the cutter's radius and `most` in all. Not seen are notches
/// whose deepest point lies on an edge of the mesh so that neither triangle holds its own foot: those are shallower
/// than the samples' and neighbours' by the turn of the normals there. A ball nose needs no such search and gives
/// nothing. Property: the result does not depend on the number of threads.
std::vector<Extreme> deepest_notches(const SweptCutter& cutter, const geometry::TriangleMesh& surface, double beyond_mm,
                                     std::size_t most);

}  // namespace volute::sim
