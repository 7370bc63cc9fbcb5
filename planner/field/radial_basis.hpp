// The radial basis functions of [Huang2016] section 2.2.
#pragma once

namespace volute::planner {

enum class BasisKind {
  gaussian,              ///< exp(-(a t)^2): a in 1 / unit of t
  inverse_multiquadric,  ///< (a^2 + t^2)^-beta: a in units of t
  half_open,             ///< eq. 5: 0.5 (cos(pi g(t / a)) + 1), 0 beyond a, g(s) = 1 - (1 - s)^order
};

struct RadialBasis {
  BasisKind kind = BasisKind::inverse_multiquadric;
  double a = 0.8;
  double beta = 1.0;  ///< inverse_multiquadric
  int order = 2;      ///< half_open: N of eq. 5. Departs from the source: g(1) = 1, where it prints g(a) = 1
};

/// phi(t). Requires: t >= 0, a > 0, beta > 0, order >= 1; half_open: a < 0.5, since t is measured round a closed
/// direction of length 1.
double basis_value(const RadialBasis& basis, double distance);

}  // namespace volute::planner
