#include "planner/orientation/rotary_spline.hpp"

#include <algorithm>
#include <cmath>

namespace volute::planner {

SplineGrid::SplineGrid(double length_mm, double step_mm)
    : spans_(std::max(1, static_cast<int>(std::ceil(length_mm / step_mm)))), step_mm_(length_mm / spans_) {}

SplineGrid::Weights SplineGrid::at(double s_mm) const {
  const double u = std::clamp(s_mm / step_mm_, 0.0, static_cast<double>(spans_));
  const int k = std::min(static_cast<int>(u), spans_ - 1);
  const double t = u - k, r = 1.0 - t;
  return {k,
          {r * r * r / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
           (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) / 6.0, t * t * t / 6.0}};
}

double SplineGrid::value(std::span<const double> coefficients, double s_mm) const {
  const Weights w = at(s_mm);
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) sum += w.weight[k] * coefficients[static_cast<std::size_t>(w.first) + k];
  return sum;
}

double SplineGrid::place_mm(int j) const { return std::clamp((j - 1) * step_mm_, 0.0, spans_ * step_mm_); }

}  // namespace volute::planner
