#include "planner/path/cc_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "planner/path/path_spline.hpp"

namespace volute::planner {
namespace {

constexpr double pi = std::numbers::pi;

/// One turn around a ball of radius R at polar angle `polar`, unevenly spaced, moved along the path's side by
/// `noise_mm`.
std::vector<RawPoint> ball_circle(double radius, double polar, double noise_mm) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<RawPoint> raw;
  for (double angle = 0.0; angle < 2.0 * pi; angle += (0.05 + 0.75 * unit(random)) / (radius * std::sin(polar))) {
    const double p = polar + noise_mm / radius * (2.0 * unit(random) - 1.0);
    const Vec3 n(std::sin(p) * std::cos(angle), std::sin(p) * std::sin(angle), std::cos(p));
    raw.push_back({radius * n, n, angle / (2.0 * pi), Vec3::Zero()});
  }
  return raw;
}

CurveOptions options() { return {0.01, 1.0, 3.0, geometry::Angle::degrees(10.0), geometry::Angle()}; }

TEST(PathSpline, ReproducesACubic) {
  std::vector<double> s, w;
  Eigen::MatrixXd values(30, 1);
  for (int i = 0; i < 30; ++i) {
    s.push_back(0.1 * i + 0.03 * std::sin(i));
    w.push_back(1.0 + 0.1 * i);
    values(i, 0) = 1.0 - 2.0 * s.back() + 0.5 * s.back() * s.back() * s.back();
  }
  const PathSpline spline(s, values, w, {s.front(), 0.4, 1.0, 2.2, s.back()}, 0.0);
  for (double x : {s.front(), 0.7, 1.9, s.back()}) {
    EXPECT_NEAR(spline.value(x)[0], 1.0 - 2.0 * x + 0.5 * x * x * x, 1e-8);
    EXPECT_NEAR(spline.derivative(x)[0], -2.0 + 1.5 * x * x, 1e-7);
  }
}

TEST(SmoothCurve, KeepsTheEndsAndTheSteps) {
  const auto raw = ball_circle(20.0, 0.9, 0.003);
  const auto points = smooth_curve(raw, options());
  EXPECT_LT((points.front().point_P_mm - raw.front().point_mm).norm(), 1e-12);
  EXPECT_LT((points.back().point_P_mm - raw.back().point_mm).norm(), 1e-12);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = (points[i].point_P_mm - points[i - 1].point_P_mm).norm();
    EXPECT_LE(step, 1.0 + 1e-9);
    EXPECT_GE(step, 0.02);
    EXPECT_NEAR(points[i].normal_P.norm(), 1.0, 1e-12);
  }
}

TEST(SmoothCurve, ChordsOfTheBallCentreKeepTheTolerance) {
  for (double tolerance : {0.02, 0.01, 0.002}) {
    CurveOptions o = options();
    o.tolerance_mm = tolerance;
    const auto points = smooth_curve(ball_circle(6.0, 1.2, 0.0), o);
    double worst = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec3 a = points[i - 1].point_P_mm + 3.0 * points[i - 1].normal_P,
                 b = points[i].point_P_mm + 3.0 * points[i].normal_P;
      worst = std::max(worst, 9.0 - (0.5 * (a + b)).norm());
    }
    EXPECT_LT(worst, tolerance);
    EXPECT_GT(worst, 0.2 * tolerance) << "no denser than needed";
  }
}

TEST(SmoothCurve, TakesOutTheZigzagOfTheMesh) {
  const auto raw = ball_circle(20.0, 0.9, 0.003);
  const auto points = smooth_curve(raw, options());
  double raw_turn = 0.0, smooth_turn = 0.0;
  const auto turn = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::atan2((b - a).cross(c - b).norm(), (b - a).dot(c - b));
  };
  for (std::size_t i = 2; i < raw.size(); ++i)
    raw_turn = std::max(raw_turn, turn(raw[i - 2].point_mm, raw[i - 1].point_mm, raw[i].point_mm));
  for (std::size_t i = 2; i < points.size(); ++i)
    smooth_turn = std::max(smooth_turn, turn(points[i - 2].point_P_mm, points[i - 1].point_P_mm, points[i].point_P_mm));
  EXPECT_GT(raw_turn, 0.08);
  EXPECT_LT(smooth_turn, 0.09) << "a step of 1 mm on a circle of 15.7 mm turns by 0.064";
}

TEST(SmoothCurve, NormalAcrossEdgeCurveAndPathIsThatOfTheBall) {
  auto raw = ball_circle(20.0, 0.9, 0.0);
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  for (RawPoint& p : raw) {
    const Vec3 n = p.normal;
    p.edge_tangent = n.cross(Vec3(normal(random), normal(random), normal(random))).normalized();
    p.normal = (n + 0.02 * Vec3(normal(random), normal(random), normal(random))).normalized();  // a poor vertex normal
  }
  double worst = 0.0;
  for (const CcPoint& p : smooth_curve(raw, options()))
    worst = std::max(worst, (p.normal_P - p.point_P_mm.normalized()).norm());
  EXPECT_LT(worst, 0.05) << "the vertex normals are off by up to 0.08";
}

}  // namespace
}  // namespace volute::planner
