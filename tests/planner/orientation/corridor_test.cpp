#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "planner/orientation/banded.hpp"
#include "planner/orientation/bounded_smooth.hpp"
#include "planner/orientation/rotary_spline.hpp"

namespace volute::planner {
namespace {

/// A dense system by Gaussian elimination with row pivoting.
using Dense = std::vector<std::vector<double>>;
std::vector<double> solved(Dense a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) pivot = std::abs(a[i][k]) > std::abs(a[pivot][k]) ? i : pivot;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double share = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= share * a[k][j];
      b[i] -= share * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// Adds weight * row row^T.
void add_square(Dense& form, const std::vector<double>& row, double weight) {
  for (std::size_t i = 0; i < row.size(); ++i)
    for (std::size_t j = 0; j < row.size(); ++j) form[i][j] += weight * row[i] * row[j];
}

TEST(Banded, SolvesWhatADenseSolverSolves) {
  const unsigned seed = 17;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const std::size_t n = 40;
  BandMatrix<3> band(n);
  Dense dense(n, std::vector<double>(n, 0.0));
  std::vector<double> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    right[i] = any(random);
    for (std::size_t j = 0; j <= 3 && j <= i; ++j)
      band[i][j] = dense[i][i - j] = dense[i - j][i] = j == 0 ? 7.0 + any(random) : any(random);
  }
  const std::vector<double> wanted = solved(dense, right);
  factor_banded<3>(band);
  solve_banded<3>(band, right);
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(right[i], wanted[i], 1e-13);
}

/// Bounds wide open, the start at 0.
struct Problem {
  std::vector<double> lower, upper, start;
  explicit Problem(std::size_t n) : lower(n, -10.0), upper(n, 10.0), start(n, 0.0) {}
  void fix(std::size_t i, double value) { lower[i] = value - 1e-7, upper[i] = value + 1e-7, start[i] = value; }
  [[nodiscard]] SmoothProblem with(double step_mm) const { return {lower, upper, start, {step_mm, 10.0}}; }
};

double greatest_difference(std::vector<double> c, int order) {
  for (int k = 0; k < order; ++k) {
    for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] = c[i + 1] - c[i];
    c.pop_back();
  }
  double most = 0.0;
  for (const double value : c) most = std::max(most, std::abs(value));
  return most;
}

TEST(SmoothestWithin, IsStraightWhereTheBoundsAllowIt) {
  Problem problem(200);
  problem.fix(0, 1.0);
  for (const double value : smoothest_within(problem.with(2.0))) EXPECT_NEAR(value, 1.0, 1e-4);
}

TEST(SmoothestWithin, KeepsTheBoundsAndTouchesThem) {
  Problem problem(300);
  problem.lower.assign(300, -1.0), problem.upper.assign(300, 1.0);
  for (std::size_t i = 120; i < 160; ++i) problem.lower[i] = 0.5;
  for (std::size_t i = 0; i < 20; ++i) problem.upper[i] = -0.2;
  const auto c = smoothest_within(problem.with(2.0));
  double least = 1.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    EXPECT_GE(c[i], problem.lower[i]);
    EXPECT_LE(c[i], problem.upper[i]);
    if (i >= 120 && i < 160) least = std::min(least, c[i] - 0.5);
  }
  EXPECT_LT(least, 1e-4);
}

/// The stationary point of the same quadratic form by a dense solver.
TEST(SmoothestWithin, WithoutBoundsInTheWayIsTheDenseMinimiser) {
  const unsigned seed = 5;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const std::size_t n = 60;
  const double h = 1.5, l = 10.0;
  Problem open(n);
  SmoothProblem problem = open.with(h);
  Dense form(n, std::vector<double>(n, 0.0)), difference = form;
  std::vector<double> right(n);
  for (std::size_t i = 0; i < n; ++i) difference[i][i] = 1.0;
  for (const double weight : {1.0 / h, l * l / (h * h * h), l * l * l * l / std::pow(h, 5)}) {
    for (std::size_t i = 0; i + 1 < difference.size(); ++i)
      for (std::size_t j = 0; j < n; ++j) difference[i][j] = difference[i + 1][j] - difference[i][j];
    difference.pop_back();
    for (const auto& row : difference) add_square(form, row, weight);
  }
  for (std::size_t i = 0; i < n; ++i) {
    problem.attraction.weight.push_back(0.05 + 0.04 * any(random));
    problem.attraction.target.push_back(any(random));
    form[i][i] += problem.attraction.weight.back();
    right[i] = problem.attraction.weight.back() * problem.attraction.target.back();
  }
  problem.held.push_back({20, {0.1, 0.4, 0.4, 0.1}, 0.7, 1e6});
  std::vector<double> row(n, 0.0);
  for (std::size_t k = 0; k < 4; ++k) row[20 + k] = problem.held.back().share[k];
  add_square(form, row, 1e6);
  for (std::size_t i = 0; i < n; ++i) right[i] += 1e6 * 0.7 * row[i];
  const std::vector<double> wanted = solved(form, right);
  const auto c = smoothest_within(problem);
  double held = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(c[i], wanted[i], 1e-5) << "seed " << seed;
    held += row[i] * wanted[i];
  }
  EXPECT_NEAR(held, 0.7, 1e-5);
}

/// From rest to rest over a length L the least greatest acceleration for a rise D is 4 D / L^2: full on, full off.
TEST(SmoothestWithin, APricedAccelerationBecomesBangBang) {
  const std::size_t n = 203;
  const double h = 0.5;
  Problem problem(n);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) problem.fix(i, 0.0);
  for (const std::size_t i : {n - 2, n - 1}) problem.fix(i, 1.0);
  for (std::size_t i = 2; i + 2 < n; ++i) {
    const double t = static_cast<double>(i - 1) / static_cast<double>(n - 3);
    problem.start[i] = t * t * (3.0 - 2.0 * t);
  }
  const double length = h * static_cast<double>(n - 2);
  SmoothProblem priced = problem.with(h);
  priced.peaks = PeakLimits{{1.0, 6.2 / (length * length), 1.0}, 1e4};
  const auto c = smoothest_within(priced);
  EXPECT_NEAR(greatest_difference(c, 2) / (h * h), 4.0 / (length * length), 0.02 * 4.0 / (length * length));
  // Without the price the smooth curve is above.
  EXPECT_GT(greatest_difference(smoothest_within(problem.with(h)), 2) / (h * h), 5.0 / (length * length));
}

TEST(SmoothestWithin, KeepsEveryLimitThatTheStartKeeps) {
  const unsigned seed = 31;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const std::size_t n = 160;
  const double h = 2.0;
  double worst = 0.0;
  for (int trial = 0; trial < 20; ++trial) {
    Problem problem(n);
    const double a = any(random), b = any(random), c = 3.0 * any(random);
    for (std::size_t i = 0; i < n; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(n);
      problem.start[i] = a * std::sin(9.0 * t) + b * std::cos(4.0 * t + c);
      const double width = 0.02 + 0.2 * std::abs(any(random));
      problem.lower[i] = problem.start[i] - width, problem.upper[i] = problem.start[i] + width;
    }
    SmoothProblem limited = problem.with(h);
    PeakLimits limits;
    for (int k = 1; k <= 3; ++k)
      limits.most[static_cast<std::size_t>(k) - 1] = greatest_difference(problem.start, k) / std::pow(h, k);
    limited.peaks = limits;
    const auto found = smoothest_within(limited);
    for (int k = 1; k <= 3; ++k) {
      const double share =
          greatest_difference(found, k) / std::pow(h, k) / limits.most[static_cast<std::size_t>(k) - 1];
      worst = std::max(worst, share);
      EXPECT_LE(share, 1.0 + 1e-6) << "seed " << seed << " trial " << trial << " order " << k;
    }
  }
  RecordProperty("worst_share", std::to_string(worst));
}

TEST(SplineGrid, ReproducesLines) {
  const SplineGrid grid(37.0, 2.0);
  std::vector<double> c;
  for (int j = 0; j < grid.coefficients(); ++j) c.push_back(3.0 + 0.5 * (j - 1) * grid.step_mm());
  for (double s = 0.0; s <= 37.0; s += 0.37) EXPECT_NEAR(grid.value(c, s), 3.0 + 0.5 * s, 1e-12);
}

}  // namespace
}  // namespace volute::planner
