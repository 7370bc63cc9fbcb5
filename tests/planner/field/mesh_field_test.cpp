#include "planner/field/mesh_field.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace volute::planner {
namespace {

using std::numbers::pi;

/// A half-sphere of radius 10 by latitude and longitude, open at the equator and with a small hole at the pole.
geometry::TriangleMesh half_sphere() {
  geometry::TriangleMesh mesh;
  constexpr int rings = 20, around = 64;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double polar = 0.05 + (pi / 2 - 0.05) * i / rings, turn = 2 * pi * j / around;
      mesh.vertices_mm.emplace_back(10 * std::sin(polar) * std::cos(turn), 10 * std::sin(polar) * std::sin(turn),
                                    10 * std::cos(polar));
    }
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const geometry::Index a = i * around + j, b = i * around + (j + 1) % around, c = a + around, d = b + around;
      mesh.triangles.push_back({a, c, d});
      mesh.triangles.push_back({a, d, b});
    }
  return mesh;
}

std::vector<PointKey> normal_keys(const geometry::TriangleMesh& mesh, std::size_t step) {
  std::vector<PointKey> keys;
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); i += step)
    keys.push_back({mesh.vertices_mm[i], mesh.vertices_mm[i].normalized()});
  return keys;
}

TEST(MeshField, KeysAlongTheNormalsKeepTheAxisOnTheNormals) {
  const geometry::TriangleMesh mesh = half_sphere();
  const auto field = field_on_mesh(mesh, normal_keys(mesh, 37), {});
  ASSERT_TRUE(field) << field.error().message;
  const auto denser = field_on_mesh(mesh, normal_keys(mesh, 11), {});
  ASSERT_TRUE(denser) << denser.error().message;
  EXPECT_LT(field->report.tilt_greatest.degrees(), 5.0);
  EXPECT_LT(denser->report.tilt_greatest.degrees(), field->report.tilt_greatest.degrees())
      << "more keys, nearer the normals";
  EXPECT_NEAR(field->report.fitting_accuracy, 1.0, 1e-9);
  // The Gauss map of a sphere has |grad T|^2 = 2 / R^2.
  EXPECT_NEAR(field->report.dirichlet_per_mm2, 1.0 / 100.0, 0.15 / 100.0);
}

TEST(MeshField, SplineOnTheCylinderStaysNearTheInterpolation) {
  const geometry::TriangleMesh mesh = half_sphere();
  FieldOptions options{{BasisKind::half_open, 0.4, 1.0, 2}, FieldPlacement::cylinder, false, 16, 32};
  const auto rbf = field_on_mesh(mesh, normal_keys(mesh, 41), options);
  options.spline = true;
  const auto spline = field_on_mesh(mesh, normal_keys(mesh, 41), options);
  ASSERT_TRUE(rbf && spline);
  double largest = 0.0;
  for (std::size_t i = 0; i < rbf->axes_P.size(); ++i)
    largest = std::max(largest, (rbf->axes_P[i] - spline->axes_P[i]).norm());
  EXPECT_GT(largest, 0.0) << "the approximation is another field";
  EXPECT_LT(largest, 0.1);
}

TEST(MeshField, SplineWithoutParametersIsRefused) {
  FieldOptions options;
  options.spline = true;
  const auto field = field_on_mesh(half_sphere(), {{Vec3::Zero(), Vec3::UnitZ()}}, options);
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().code, "field-no-parameters");
}

TEST(MeshField, HalfOpenBasisWithoutAClosedDirectionIsRefused) {
  for (const FieldPlacement placement : {FieldPlacement::straight, FieldPlacement::box}) {
    const auto field = field_on_mesh(half_sphere(), {{Vec3::Zero(), Vec3::UnitZ()}},
                                     {{BasisKind::half_open, 0.4, 1.0, 2}, placement, false, 30, 10});
    ASSERT_FALSE(field);
    EXPECT_EQ(field.error().code, "field-basis-placement");
  }
}

TEST(MeshField, HalfOpenBasisOfHalfAPeriodIsRefused) {
  const auto field = field_on_mesh(half_sphere(), {{Vec3::Zero(), Vec3::UnitZ()}},
                                   {{BasisKind::half_open, 0.6, 1.0, 2}, FieldPlacement::cylinder, false, 30, 10});
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().code, "field-basis-width");
}

}  // namespace
}  // namespace volute::planner
