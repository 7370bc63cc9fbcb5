#include "planner/field/radial_basis.hpp"

#include <cmath>
#include <numbers>

#include "geometry/check.hpp"

namespace volute::planner {

double basis_value(const RadialBasis& basis, double distance) {
  VOLUTE_CHECK(distance >= 0.0 && basis.a > 0.0 && basis.beta > 0.0 && basis.order >= 1, distance, basis.a, basis.beta,
               basis.order);
  switch (basis.kind) {
    case BasisKind::gaussian:
      return std::exp(-(basis.a * distance) * (basis.a * distance));
    case BasisKind::inverse_multiquadric:
      return std::pow(basis.a * basis.a + distance * distance, -basis.beta);
    case BasisKind::half_open: {
      VOLUTE_CHECK(basis.a < 0.5, basis.a);
      if (distance >= basis.a) return 0.0;
      const double g = 1.0 - std::pow(1.0 - distance / basis.a, basis.order);
      return 0.5 * (std::cos(std::numbers::pi * g) + 1.0);
    }
  }
  return 0.0;
}

}  // namespace volute::planner
