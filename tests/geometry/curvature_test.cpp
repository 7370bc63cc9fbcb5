#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/mesh_measure.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

Vec3 centre(const TriangleMesh& mesh, const Triangle& t) {
  return (mesh.vertices_mm[static_cast<std::size_t>(t[0])] + mesh.vertices_mm[static_cast<std::size_t>(t[1])] +
          mesh.vertices_mm[static_cast<std::size_t>(t[2])]) /
         3.0;
}

double worst_error(const TriangleMesh& mesh, double least_per_mm, double greatest_per_mm) {
  const auto tensors = triangle_curvature(mesh);
  const auto normals = triangle_normals(mesh);
  double worst = 0.0;
  for (std::size_t t = 0; t < tensors.size(); ++t) {
    const PrincipalCurvature k = principal_curvature(tensors[t], normals[t]);
    worst = std::max({worst, std::abs(k.least_per_mm - least_per_mm), std::abs(k.greatest_per_mm - greatest_per_mm)});
  }
  return worst;
}

TEST(Curvature, OfASphereIsPositiveAndOneOverTheRadius) {
  EXPECT_LT(worst_error(sphere(20.0, 4), 0.05, 0.05), 0.4 * 2.0 / 400.0);  // 0.4 e / R^2, edges of 2 mm
  EXPECT_LT(worst_error(sphere(20.0, 5), 0.05, 0.05), 0.4 * 1.0 / 400.0);
}

TEST(Curvature, OfAHollowSphereIsNegative) {
  TriangleMesh hollow = sphere(20.0, 4);
  for (Triangle& t : hollow.triangles) std::swap(t[0], t[1]);
  EXPECT_LT(worst_error(hollow, -0.05, -0.05), 0.05 * 0.02);
}

TEST(Curvature, OfATubeHoldsUpToItsEdges) { EXPECT_LT(worst_error(tube(10.0, 20.0, 96, 30), 0.0, 0.1), 0.1 * 0.01); }

TEST(Curvature, TensorIsSymmetricAndTangent) {
  const TriangleMesh mesh = torus(30.0, 10.0, 120, 40);
  const auto tensors = triangle_curvature(mesh);
  const auto normals = triangle_normals(mesh);
  for (std::size_t t = 0; t < tensors.size(); ++t) {
    EXPECT_LT((tensors[t] - tensors[t].transpose()).norm(), 1e-12);
    EXPECT_LT((tensors[t] * normals[t]).norm(), 1e-12);
  }
}

TEST(Curvature, OfATorusFollowsItsFormulaInSizeAndDirection) {
  const double major = 30.0, minor = 10.0;
  const TriangleMesh mesh = torus(major, minor, 240, 80);
  const auto tensors = triangle_curvature(mesh);
  const auto normals = triangle_normals(mesh);
  for (std::size_t t = 0; t < tensors.size(); ++t) {
    const Vec3 p = centre(mesh, mesh.triangles[t]);
    const double radius = std::hypot(p.x(), p.y()), cosine = (radius - major) / minor;
    const PrincipalCurvature k = principal_curvature(tensors[t], normals[t]);
    EXPECT_NEAR(k.greatest_per_mm, 1.0 / minor, 0.1 * 0.02);
    EXPECT_NEAR(k.least_per_mm, cosine / (major + minor * cosine), 0.1 * 0.02);
    const Vec3 ring = Vec3(-p.y(), p.x(), 0.0).normalized();  // the direction of least curvature
    EXPECT_LT(std::abs(k.direction_of_greatest.dot(ring)), 0.03);
  }
}

TEST(Curvature, AveragingHoldsItsGroundAgainstNoise) {
  const unsigned seed = 20260917;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.002);
  TriangleMesh mesh = sphere(20.0, 5);  // edges of about 1 mm
  for (Vec3& p : mesh.vertices_mm) p += noise(random) * p.normalized();
  const auto error = [&](int rounds) {
    const auto tensors = triangle_curvature(mesh, rounds);
    double sum_sq = 0.0;
    for (const Mat3& s : tensors) sum_sq += std::pow(0.5 * s.trace() - 0.05, 2);
    return std::sqrt(sum_sq / static_cast<double>(tensors.size()));
  };
  const double raw = error(0), averaged = error(6);
  EXPECT_LT(averaged, 0.2 * raw);
  EXPECT_LT(averaged, 0.05 * 0.05);
}

TEST(Curvature, IsTheSameInEveryPlaceAndTurn) {
  const TriangleMesh mesh = torus(30.0, 10.0, 40, 20);
  Transform moved = Transform::Identity();
  moved.rotate(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()));
  moved.pretranslate(Vec3(7, -5, 3));
  TriangleMesh elsewhere = mesh;
  for (Vec3& p : elsewhere.vertices_mm) p = moved * p;
  const auto here = triangle_curvature(mesh), there = triangle_curvature(elsewhere);
  for (std::size_t t = 0; t < here.size(); ++t)
    EXPECT_LT((moved.linear() * here[t] * moved.linear().transpose() - there[t]).norm(), 1e-10);
}

TEST(Curvature, PrincipalValuesOfAKnownTensor) {
  const Vec3 n = Vec3(1, 2, 2) / 3.0, u = Vec3(2, 1, -2) / 3.0, v = n.cross(u);
  const PrincipalCurvature k = principal_curvature(0.3 * u * u.transpose() - 0.2 * v * v.transpose(), n);
  EXPECT_NEAR(k.greatest_per_mm, 0.3, 1e-14);
  EXPECT_NEAR(k.least_per_mm, -0.2, 1e-14);
  EXPECT_NEAR(std::abs(k.direction_of_greatest.dot(u)), 1.0, 1e-14);
}

}  // namespace
}  // namespace volute::geometry::test
