#include "geometry/mesh_measure.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

TEST(MeshMeasure, AreaOfASheetIsExact) {
  EXPECT_DOUBLE_EQ(area_mm2(sheet(4, 3, 0.5)), 3.0);
  EXPECT_DOUBLE_EQ(triangle_area_mm2(sheet(4, 3, 0.5), 5), 0.125);
}

TEST(MeshMeasure, AreaOfASphereConvergesWithTheSquareOfTheEdge) {
  const double exact = 4.0 * std::numbers::pi * 9.0;
  const double coarse = exact - area_mm2(sphere(3.0, 3)), fine = exact - area_mm2(sphere(3.0, 4));
  EXPECT_GT(fine, 0.0);
  EXPECT_NEAR(coarse / fine, 4.0, 0.1);
}

TEST(MeshMeasure, NormalsPointOutwards) {
  const TriangleMesh mesh = sphere(2.0, 3);
  const auto of_triangles = triangle_normals(mesh);
  for (std::size_t t = 0; t < of_triangles.size(); ++t)
    EXPECT_GT(of_triangles[t].dot(mesh.vertices_mm[static_cast<std::size_t>(mesh.triangles[t][0])]), 1.9);
  const auto of_vertices = vertex_normals(mesh);
  for (std::size_t v = 0; v < of_vertices.size(); ++v) {
    EXPECT_NEAR(of_vertices[v].norm(), 1.0, 1e-12);
    EXPECT_GT(of_vertices[v].dot(mesh.vertices_mm[v]) / 2.0, std::cos(0.025));
  }
}

TEST(MeshMeasure, VertexNormalWeighsByCornerAngleNotByCount) {
  // A cube's corner whose three faces are cut into one, two and two triangles there.
  const TriangleMesh corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}},
                            {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {0, 3, 5}, {0, 5, 1}}};
  const Vec3 normal = vertex_normals(corner).front();
  EXPECT_LT((normal - Vec3(1, 1, 1).normalized()).norm(), 1e-12);
}

}  // namespace
}  // namespace volute::geometry::test
