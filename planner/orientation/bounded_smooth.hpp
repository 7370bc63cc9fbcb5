// The smoothest curve within bounds: a quadratic programme solved by an interior point method on a band matrix.
#pragma once

#include <span>
#include <vector>

namespace volute::planner {

/// What is least: the integral over arc length of x'^2 + l^2 x''^2 + l^4 x'''^2 for a B-spline with these coefficients,
/// plus attraction * (x - target)^2 summed over the coefficients.
struct SmoothnessWeights {
  double step_mm = 1.0;
  double length_mm = 10.0;  ///< l: motions over less than 2 pi l are judged by their jerk, over more by their velocity
  double attraction = 0.0;
};

/// Minimises over lower <= c <= upper. The differences of the coefficients stand for the derivatives.
/// Requires: lower < upper everywhere; start within the bounds (it is moved inside). `target` may be empty when
/// attraction is 0. Ends always: at most 60 Newton steps; the mean complementarity is then below 1e-10 of its start, or
/// the last iterate, within the bounds, is returned.
std::vector<double> smoothest_within(std::span<const double> lower, std::span<const double> upper,
                                     std::span<const double> start, std::span<const double> target,
                                     const SmoothnessWeights& weights);

}  // namespace volute::planner
