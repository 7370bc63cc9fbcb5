// The example parts are what their README says: one surface each, the right number of holes, and near enough to their
// formula.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "examples/mouse.hpp"
#include "examples/shapes.hpp"
#include "geometry/mesh_report.hpp"

namespace volute::geometry {
namespace {

LoadedMesh part(const std::string& name) {
  const auto mesh = load_mesh(std::filesystem::path(VOLUTE_SOURCE_DIR) / "examples" / "parts" / (name + ".stl"));
  EXPECT_TRUE(mesh) << mesh.error().message;
  return mesh ? *mesh : LoadedMesh{};
}

TEST(ExampleParts, AreMachinableWithTheRightNumberOfHoles) {
  const std::vector<std::pair<std::string, std::size_t>> loops = {
      {"plate-one-hole", 2}, {"plate-two-holes", 3}, {"plate-three-holes", 4}, {"disc-with-hole", 2}, {"disc-wavy", 1},
      {"mouse", 2},          {"obstacle-plate", 2},  {"half-sphere", 1},       {"arched-strip", 1}};
  for (const auto& [name, count] : loops) {
    const MeshReport report = inspect(part(name));
    EXPECT_TRUE(report.machinable) << name << ": " << report.reason;
    EXPECT_EQ(report.loops.size(), count) << name;
    EXPECT_GT(report.least_angle_deg, 12.0) << name;
    EXPECT_TRUE(report.repairs.warnings.empty()) << name;
  }
}

TEST(ExampleParts, ObstaclesAreClosedWithTheirOutsideOutwards) {
  for (const char* name : {"obstacle-wall", "obstacle-post"}) {
    const LoadedMesh obstacle = part(name);
    EXPECT_EQ(inspect(obstacle).reason_code, "mesh-no-boundary") << name;
    double volume_mm3 = 0.0;
    for (const Triangle& t : obstacle.mesh.triangles) {
      const auto& v = obstacle.mesh.vertices_mm;
      volume_mm3 += v[static_cast<std::size_t>(t[0])]
                        .cross(v[static_cast<std::size_t>(t[1])])
                        .dot(v[static_cast<std::size_t>(t[2])]) /
                    6.0;
    }
    EXPECT_GT(volume_mm3, 1000.0) << name;
  }
}

/// The farthest that a triangle leaves the height field, measured along its normal.
double chord_error_mm(const TriangleMesh& mesh, double (*height_mm)(double, double)) {
  constexpr int steps = 6;
  double worst = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices_mm[static_cast<std::size_t>(t[0])],
               &b = mesh.vertices_mm[static_cast<std::size_t>(t[1])],
               &c = mesh.vertices_mm[static_cast<std::size_t>(t[2])];
    const double slope = (b - a).cross(c - a).normalized().z();
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Vec3 p = (i * a + j * b + (steps - i - j) * c) / steps;
        worst = std::max(worst, slope * std::abs(height_mm(p.x(), p.y()) - p.z()));
      }
  }
  return worst;
}

TEST(ExampleParts, LeaveTheirFormulaByAtMostATwentiethOfTheScallop) {
  for (const char* name : {"plate-one-hole", "plate-two-holes", "plate-three-holes", "obstacle-plate"})
    EXPECT_LT(chord_error_mm(part(name).mesh, examples::freeform_height_mm), 0.05 * 0.2) << name;
  for (const char* name : {"disc-with-hole", "disc-wavy"})
    EXPECT_LT(chord_error_mm(part(name).mesh, examples::wavy_height_mm), 0.05 * 0.2) << name;
  EXPECT_LT(chord_error_mm(part("mouse").mesh, examples::mouse_height_mm), 0.05 * 0.1);
}

TEST(ExampleParts, HalfSphereAndStripLieOnTheirFormulas) {
  for (const Vec3& p : part("half-sphere").mesh.vertices_mm) EXPECT_NEAR(p.norm(), 10.0, 2e-6);
  for (const Vec3& p : part("arched-strip").mesh.vertices_mm)
    EXPECT_NEAR(std::hypot(p.x() - 30.0, p.z() + 160.0 * std::cos(std::asin(30.0 / 160.0))), 160.0, 2e-5);
}

TEST(ExampleParts, MouseHasItsSizeAndSteepWalls) {
  const MeshReport report = inspect(part("mouse"));
  const Vec3 size = report.greatest_mm - report.least_mm;
  EXPECT_NEAR(size.x(), 100.0, 1.0);
  EXPECT_NEAR(size.y(), 60.0, 1.5);
  EXPECT_NEAR(report.greatest_mm.z(), 35.0, 0.5);
}

}  // namespace
}  // namespace volute::geometry
