#include "sim/interpreter/arithmetic.hpp"

#include <cmath>

namespace volute::sim {

std::optional<double> common_function(std::string_view name, double x) {
  if (name == "ABS") return std::abs(x);
  if (name == "ACOS") return std::acos(x) / rad_per_deg;
  if (name == "ASIN") return std::asin(x) / rad_per_deg;
  if (name == "COS") return std::cos(x * rad_per_deg);
  if (name == "SIN") return std::sin(x * rad_per_deg);
  if (name == "SQRT") return std::sqrt(x);
  if (name == "TAN") return std::tan(x * rad_per_deg);
  return std::nullopt;
}

}  // namespace volute::sim
