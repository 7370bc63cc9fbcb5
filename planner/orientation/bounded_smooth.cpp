#include "planner/orientation/bounded_smooth.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "planner/orientation/banded.hpp"

// Notation. c: coefficients; s_l = c - lower and s_u = upper - c: slacks; z_l, z_u: their multipliers; mu: barrier
// parameter. Newton on P c + q - z_l + z_u = 0, s z = mu, with the slacks tied to c exactly.
namespace volute::planner {

namespace {

constexpr int band = 3;
constexpr int newton_steps_max = 60;
constexpr double complementarity_share = 1e-10;
constexpr double boundary_share = 0.995;
constexpr double centring = 0.2;

using Band = BandMatrix<band>;

/// Adds weight * (sum_k stencil[k] c[i + k])^2 for every i: to the matrix of the quadratic form c^T P c.
template <std::size_t N>
void add_squares(Band& matrix, const std::array<double, N>& stencil, double weight) {
  for (std::size_t i = 0; i + N <= matrix.size(); ++i) {
    for (std::size_t a = 0; a < N; ++a) {
      for (std::size_t b = 0; b <= a; ++b) matrix[i + a][a - b] += weight * stencil[a] * stencil[b];
    }
  }
}

Band smoothness_matrix(std::size_t n, const SmoothnessWeights& weights) {
  Band matrix(n, {0.0, 0.0, 0.0, 0.0});
  const double h = weights.step_mm, l_sq = weights.length_mm * weights.length_mm;
  add_squares<2>(matrix, {-1.0, 1.0}, 1.0 / h);
  add_squares<3>(matrix, {1.0, -2.0, 1.0}, l_sq / (h * h * h));
  add_squares<4>(matrix, {-1.0, 3.0, -3.0, 1.0}, l_sq * l_sq / (h * h * h * h * h));
  for (auto& row : matrix) row[0] += weights.attraction;
  return matrix;
}

std::vector<double> multiplied(const Band& matrix, const std::vector<double>& x) {
  std::vector<double> y(x.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    y[i] += matrix[i][0] * x[i];
    for (std::size_t j = 1; j <= band && j <= i; ++j) {
      y[i] += matrix[i][j] * x[i - j];
      y[i - j] += matrix[i][j] * x[i];
    }
  }
  return y;
}

class InteriorPoint {
 public:
  InteriorPoint(std::span<const double> lower, std::span<const double> upper, std::span<const double> start,
                std::span<const double> target, const SmoothnessWeights& weights)
      : lower_(lower), upper_(upper), matrix_(smoothness_matrix(lower.size(), weights)), q_(lower.size(), 0.0) {
    for (std::size_t i = 0; i < lower.size(); ++i) {
      VOLUTE_CHECK(lower[i] < upper[i], i, lower[i], upper[i]);
      const double width = upper[i] - lower[i];
      c_.push_back(std::clamp(start[i], lower[i] + 0.05 * width, upper[i] - 0.05 * width));
      if (weights.attraction > 0.0) q_[i] = -weights.attraction * target[i];
    }
    // Multipliers of the size of the forces that the start asks for.
    const std::vector<double> force = multiplied(matrix_, c_);
    double mean = 0.0;
    for (std::size_t i = 0; i < c_.size(); ++i) mean += std::abs(force[i] + q_[i]);
    const double size = std::max(mean / static_cast<double>(c_.size()), 1e-9);
    z_l_.assign(c_.size(), size);
    z_u_.assign(c_.size(), size);
  }

  std::vector<double> run() {
    const double first = complementarity();
    for (int k = 0; k < newton_steps_max && complementarity() > complementarity_share * first; ++k) step();
    return c_;
  }

 private:
  [[nodiscard]] double complementarity() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < c_.size(); ++i) sum += (c_[i] - lower_[i]) * z_l_[i] + (upper_[i] - c_[i]) * z_u_[i];
    return sum / (2.0 * static_cast<double>(c_.size()));
  }
  void step();

  std::span<const double> lower_, upper_;
  Band matrix_;
  std::vector<double> q_, c_, z_l_, z_u_;
};

void InteriorPoint::step() {
  const std::size_t n = c_.size();
  const double mu = centring * complementarity();
  Band newton = matrix_;
  std::vector<double> d = multiplied(matrix_, c_);
  for (std::size_t i = 0; i < n; ++i) {
    const double s_l = c_[i] - lower_[i], s_u = upper_[i] - c_[i];
    newton[i][0] += z_l_[i] / s_l + z_u_[i] / s_u;
    d[i] = -(d[i] + q_[i]) + mu / s_l - mu / s_u;
  }
  factor_banded<band>(newton);
  solve_banded<band>(newton, d);
  double primal = 1.0, dual = 1.0;
  std::vector<double> dz_l(n), dz_u(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double s_l = c_[i] - lower_[i], s_u = upper_[i] - c_[i];
    dz_l[i] = (mu - z_l_[i] * d[i]) / s_l - z_l_[i];
    dz_u[i] = (mu + z_u_[i] * d[i]) / s_u - z_u_[i];
    if (d[i] < 0.0) primal = std::min(primal, -boundary_share * s_l / d[i]);
    if (d[i] > 0.0) primal = std::min(primal, boundary_share * s_u / d[i]);
    if (dz_l[i] < 0.0) dual = std::min(dual, -boundary_share * z_l_[i] / dz_l[i]);
    if (dz_u[i] < 0.0) dual = std::min(dual, -boundary_share * z_u_[i] / dz_u[i]);
  }
  const double both = std::min(primal, dual);
  for (std::size_t i = 0; i < n; ++i) {
    c_[i] = std::clamp(c_[i] + both * d[i], std::nextafter(lower_[i], upper_[i]), std::nextafter(upper_[i], lower_[i]));
    z_l_[i] += both * dz_l[i];
    z_u_[i] += both * dz_u[i];
  }
}

}  // namespace

std::vector<double> smoothest_within(std::span<const double> lower, std::span<const double> upper,
                                     std::span<const double> start, std::span<const double> target,
                                     const SmoothnessWeights& weights) {
  VOLUTE_CHECK(lower.size() == upper.size() && lower.size() == start.size() && lower.size() > 3, lower.size());
  return InteriorPoint(lower, upper, start, target, weights).run();
}

}  // namespace volute::planner
