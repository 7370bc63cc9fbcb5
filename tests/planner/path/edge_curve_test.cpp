#include "planner/surface/edge_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace volute::planner {
namespace {

Vec3 random_unit(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

TEST(EdgeCurve, StartsAndEndsAtTheEdgeAcrossTheNormals) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    // Two points of a ball and its normals: the section plane holds both normals, so that eq. 16 is exact at both ends.
    const Vec3 n = random_unit(random), m = (n + 0.2 * random_unit(random)).normalized();
    const EdgeCurve curve(7.0 * n, 7.0 * m, n, m);
    EXPECT_LT((curve.point_mm(0.0) - 7.0 * n).norm(), 1e-12);
    EXPECT_LT((curve.point_mm(1.0) - 7.0 * m).norm(), 1e-12);
    EXPECT_NEAR(curve.derivative_mm(0.0).dot(n), 0.0, 1e-12) << "with the printed sign of eta: 6e-2";
    EXPECT_NEAR(curve.derivative_mm(1.0).dot(m), 0.0, 1e-12);
  }
}

TEST(EdgeCurve, IsTheSameFromTheOtherEnd) {
  std::mt19937 random(6);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = random_unit(random), q = p + 0.3 * random_unit(random);
    const Vec3 n = random_unit(random), m = (n + 0.3 * random_unit(random)).normalized();
    const EdgeCurve ahead(p, q, n, m), back(q, p, m, n);
    for (double t : {0.1, 0.5, 0.8}) EXPECT_LT((ahead.point_mm(t) - back.point_mm(1.0 - t)).norm(), 1e-12);
  }
}

TEST(EdgeCurve, ComesFourthOrderCloseToABall) {
  double before = 0.0;
  for (double edge : {0.8, 0.4, 0.2}) {
    const double angle = edge / 5.0, radius = 5.0;
    const Vec3 n(0, 0, 1), m(std::sin(angle), 0, std::cos(angle));
    const EdgeCurve curve(radius * n, radius * m, n, m);
    const double error = std::abs(curve.point_mm(0.5).norm() - radius),
                 chord_error = radius * (1.0 - std::cos(0.5 * angle));
    EXPECT_LT(error, 0.01 * chord_error);
    EXPECT_TRUE(before == 0.0 || std::abs(before / error - 16.0) < 1.5) << before / error;
    before = error;
  }
}

TEST(EdgeCurve, TheDerivativeIsThatOfThePoint) {
  const EdgeCurve curve({0, 0, 0}, {1, 0.2, 0}, Vec3(-0.2, 0, 1).normalized(), Vec3(0.3, 0.1, 1).normalized());
  for (double t : {0.2, 0.5, 0.9})
    EXPECT_LT(((curve.point_mm(t + 1e-6) - curve.point_mm(t - 1e-6)) / 2e-6 - curve.derivative_mm(t)).norm(), 1e-8);
}

}  // namespace
}  // namespace volute::planner
