// The smoothing models of [Sun2016] 6.3 for one rotary axis: least velocity or least acceleration through pinned
// values.
#pragma once

#include <span>
#include <vector>

#include "planner/options.hpp"

namespace volute::planner {

struct Pin {
  int index = 0;
  double value = 0.0;
};

/// Minimises [Sun2016] eq. 27, sum ((Phi[i+1] - Phi[i]) / L[i])^2 (Weights::as_printed) or the same times L[i]
/// (arc_length), the pins held. Constant beyond the outer pins. Exact, one pass: between pins the steps are as L^2 or
/// as L. Requires: s rising strictly, one pin at least, pins rising.
std::vector<double> least_velocity(std::span<const double> s_mm, std::span<const Pin> pins, Weights weights);

/// Minimises [Sun2016] eq. 33, sum a[i]^2 over the inner points, a[i] the difference quotient of eq. 32 (as_printed),
/// or the same times (L[i] + L[i-1]) / 2 (arc_length), the pins held; straight beyond the outer pins; one pin:
/// constant. Departs from the source: instead of the five-banded system (34)-(36) with n unknowns, whose condition
/// grows as n^4, the stationary point is written with its multipliers. They are linear in s between pins, so the
/// unknowns are one a pin, tridiagonal, and two sums give the curve: the same minimiser, exact to rounding at any n.
/// Time: O(n). Requires: as least_velocity.
std::vector<double> least_acceleration(std::span<const double> s_mm, std::span<const Pin> pins, Weights weights);

}  // namespace volute::planner
