// Around a slit the field is given, so that the last turns go round its tips as wide as they may.
#pragma once

#include <vector>

#include "planner/path/even_domain.hpp"
#include "planner/path/path_interval.hpp"

namespace volute::planner {

struct CollarVertex {
  Index vertex = geometry::no_index;
  double turns_before = 0.0;  ///< phi there is the centre's less this
};

/// The vertices within 1.3 intervals of the slits; phi falls by one turn an interval away from them. Where the
/// curvature differs the interval is the one that 95 % of the collar allow. Left out are vertices to which another
/// boundary is nearer, and those about places where slits meet or grow out of a hole: in the corners there turns must
/// stand closer. Empty where the centre has no slit. A field of least length pulls its lines taut around a slit, into
/// hairpins at its tips; in the collar they are circles.
std::vector<CollarVertex> slit_collar(const EvenDomain& domain, const IntervalRule& rule);

}  // namespace volute::planner
