// The smoothest curve within bounds: a quadratic programme solved by an interior point method on a band matrix.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace volute::planner {

/// What is least: the integral over arc length of x'^2 + l^2 x''^2 + l^4 x'''^2 for a B-spline with these coefficients.
struct SmoothnessWeights {
  double step_mm = 1.0;
  double length_mm = 10.0;  ///< l: motions over less than 2 pi l are judged by their jerk, over more by their velocity
};

/// Adds sum of weight[i] (x[i] - target[i])^2. Both empty, or one of each a coefficient.
struct Attraction {
  std::vector<double> weight, target;
};

/// Adds weight (sum of share[k] x[first + k] - value)^2: the curve's value at a place.
struct HeldValue {
  int first = 0;
  std::array<double, 4> share{};
  double value = 0.0, weight = 0.0;
};

/// Limits of the first three derivatives per arc length, as scales t_k of `most`: |difference of order k| <= t_k
/// most[k] step^k with t_k <= 1, which for a uniform cubic B-spline bounds the derivative everywhere. `price` * (energy
/// of the start) is paid for every unit of t_k, so that peaks fall as far as they are worth it. Requires: most > 0,
/// price > 0.
struct PeakLimits {
  std::array<double, 3> most{};
  double price = 1.0;
};

struct SmoothProblem {
  std::span<const double> lower, upper, start;
  SmoothnessWeights weights{};
  Attraction attraction{};
  std::vector<HeldValue> held{};
  std::optional<PeakLimits> peaks{};
};

/// Minimises over lower <= c <= upper, and the limits where there are some. The differences of the coefficients stand
/// for the derivatives. Requires: lower < upper everywhere, four coefficients at least; with limits some curve within
/// the bounds must keep them (the start, normally).
/// Ends always: at most 60 Newton steps; what is left of complementarity is then below 1e-9 of the energy of the start,
/// or the last iterate is returned. Bounds are kept exactly, limits to 1e-6 of themselves unless no curve keeps them.
std::vector<double> smoothest_within(const SmoothProblem& problem);

}  // namespace volute::planner
