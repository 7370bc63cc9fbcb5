#include <Eigen/Cholesky>
#include <random>

#include <gtest/gtest.h>

#include "planner/orientation/banded.hpp"
#include "planner/orientation/bounded_smooth.hpp"
#include "planner/orientation/rotary_spline.hpp"

namespace volute::planner {
namespace {

TEST(Banded, SolvesWhatADenseSolverSolves) {
  const unsigned seed = 17;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const int n = 40;
  BandMatrix<3> band(n);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  std::vector<double> right(n);
  for (int i = 0; i < n; ++i) {
    right[static_cast<std::size_t>(i)] = any(random);
    for (int j = 0; j <= 3 && j <= i; ++j) {
      const double value = j == 0 ? 7.0 + any(random) : any(random);
      band[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = value;
      dense(i, i - j) = dense(i - j, i) = value;
    }
  }
  const Eigen::VectorXd wanted = dense.ldlt().solve(Eigen::Map<Eigen::VectorXd>(right.data(), n));
  factor_banded<3>(band);
  solve_banded<3>(band, right);
  for (int i = 0; i < n; ++i) EXPECT_NEAR(right[static_cast<std::size_t>(i)], wanted[i], 1e-13);
}

TEST(SmoothestWithin, IsStraightWhereTheBoundsAllowIt) {
  const std::size_t n = 200;
  std::vector<double> lower(n, -10.0), upper(n, 10.0), start(n, 0.0);
  lower.front() = 1.0 - 1e-9, upper.front() = 1.0 + 1e-9;
  const auto c = smoothest_within(lower, upper, start, {}, {2.0, 10.0, 0.0});
  for (const double value : c) EXPECT_NEAR(value, 1.0, 1e-5);
}

TEST(SmoothestWithin, KeepsTheBoundsAndTouchesThem) {
  const std::size_t n = 300;
  std::vector<double> lower(n, -1.0), upper(n, 1.0), start(n, 0.0);
  for (std::size_t i = 120; i < 160; ++i) lower[i] = 0.5;
  for (std::size_t i = 0; i < 20; ++i) upper[i] = -0.2;
  const auto c = smoothest_within(lower, upper, start, {}, {2.0, 10.0, 0.0});
  double least = 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_GE(c[i], lower[i]);
    EXPECT_LE(c[i], upper[i]);
    if (i >= 120 && i < 160) least = std::min(least, c[i] - 0.5);
  }
  EXPECT_LT(least, 1e-4);
}

TEST(SplineGrid, ReproducesLines) {
  const SplineGrid grid(37.0, 2.0);
  std::vector<double> c;
  for (int j = 0; j < grid.coefficients(); ++j) c.push_back(3.0 + 0.5 * (j - 1) * grid.step_mm());
  for (double s = 0.0; s <= 37.0; s += 0.37) EXPECT_NEAR(grid.value(c, s), 3.0 + 0.5 * s, 1e-12);
}

}  // namespace
}  // namespace volute::planner
