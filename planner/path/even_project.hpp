// The ADMM step of the even field in one triangle: the nearest gradient that is allowed; several triangles at a time.
#pragma once

#include <Eigen/Core>

namespace volute::planner {

constexpr int project_lanes = 4;  ///< triangles taken together
/// One number of each of several triangles.
using Lanes = Eigen::Array<double, project_lanes, 1>;
/// One vector of each of them, in its own triangle's frame.
struct LaneVectors {
  Lanes x, y;
};

/// What a gradient must hold, triangle by triangle. Requires: d unit, needed > 0, mu >= 0, weight > 0.
struct Allowed {
  LaneVectors d;  ///< unit: where the gradient is asked to grow
  Lanes needed;   ///< g: the least of q . d
  double mu;      ///< cost of (|q| / g)^2 beside |q| / g
  Lanes weight;   ///< of the distance squared
};

/// The minimiser over q of |q| + mu |q|^2 / (2 g) + weight |q - z|^2 / 2 with q . d >= g, lane by lane.
/// Accuracy: on the constraint 1e-6 of |z|, and exact off it. Properties: 1. q . d >= g up to rounding. 2. No allowed
/// gradient near by costs less. 3. A lane does not depend on the others.
LaneVectors nearest_allowed(const LaneVectors& z, const Allowed& allowed);

}  // namespace volute::planner
