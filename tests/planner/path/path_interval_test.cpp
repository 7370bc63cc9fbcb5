#include "planner/path/path_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "planner/path/cc_path.hpp"
#include "sample_surfaces.hpp"

namespace volute::planner {
namespace {

/// Height left between two balls that touch a circle of curvature k at two points a chord `interval` apart, by plane
/// geometry: ball centres on the circle of radius R + r, both at half angle beta; the highest point of the gap lies on
/// the axis.
double scallop_mm(double r, double k, double interval) {
  if (std::abs(k) < 1e-12) return r - std::sqrt(r * r - 0.25 * interval * interval);
  const double radius = 1.0 / k, beta = std::asin(0.5 * interval / std::abs(radius));
  const double across = (radius + r) * std::sin(beta), along = (radius + r) * std::cos(beta);
  const double top = k > 0 ? along - std::sqrt(r * r - across * across)
                           : along - std::copysign(1.0, radius + r) * -std::sqrt(r * r - across * across);
  return k > 0 ? top - radius : std::abs(radius) - std::abs(top);
}

TEST(PathInterval, LeavesExactlyTheScallopOnPlaneRidgeAndHollow) {
  for (double r : {1.0, 3.0, 8.0})
    for (double h : {0.005, 0.1, 0.2})
      for (double k : {-0.08, -0.02, 0.0, 0.02, 0.2, 0.7}) {
        const double interval = path_interval_mm(r, h, k);
        EXPECT_NEAR(scallop_mm(r, k, interval), h, 1e-10) << "r " << r << " h " << h << " k " << k;
      }
}

TEST(PathInterval, Equation20IsTheLimitOfSmallHeightsAndTooWide) {
  EXPECT_NEAR(path_interval_eq20_mm(3.0, 1e-6, 0.05) / path_interval_mm(3.0, 1e-6, 0.05), 1.0, 1e-6);
  EXPECT_NEAR(scallop_mm(3.0, 0.0, path_interval_eq20_mm(3.0, 0.2, 0.0)) / 0.2, 1.036, 0.001) << "errata, R3";
  EXPECT_NEAR(scallop_mm(1.0, 0.0, path_interval_eq20_mm(1.0, 0.1, 0.0)) / 0.1, 1.056, 0.001) << "errata, R1";
}

TEST(IntervalRule, IsNeverWiderThanTheCutterAndBoundedInTightHollows) {
  const kinematics::Cutter ball;
  const IntervalRule rule = interval_rule(ball, 0.2, OrientationOptions{});
  EXPECT_DOUBLE_EQ(rule.interval_mm(0.0), path_interval_mm(3.0, 0.2, 0.0));
  EXPECT_GT(rule.interval_mm(-0.2), rule.interval_mm(0.0));
  EXPECT_DOUBLE_EQ(rule.interval_mm(-5.0), rule.interval_mm(-0.3)) << "below 1 + k r = 0.2 it stays";
  EXPECT_LE(rule.interval_mm(-5.0), 0.9 * 6.0);
}

TEST(IntervalField, LowerBoundOfABallIsAreaOverInterval) {
  const double radius = 20.0;
  const TriangleMesh dome = samples::dome(radius, 0.4, 160, 60);
  const IntervalField field(dome, interval_rule(kinematics::Cutter{}, 0.1, OrientationOptions{}));
  const double area = 2.0 * 3.14159265358979 * radius * radius * std::cos(0.4);
  EXPECT_NEAR(field.lower_bound_mm() / (area / path_interval_mm(3.0, 0.1, 1.0 / radius)), 1.0, 0.01);
  EXPECT_EQ(field.too_tight_share(), 0.0);
}

}  // namespace
}  // namespace volute::planner
