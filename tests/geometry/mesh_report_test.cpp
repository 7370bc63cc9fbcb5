#include "geometry/mesh_report.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

MeshReport report_of(const TriangleMesh& mesh) { return inspect({mesh, {}}); }

TEST(MeshReport, AcceptsSheetsWithAndWithoutHoles) {
  for (const TriangleMesh& mesh : {sheet(4, 4), sheet_with_hole(5, 4, 2, 1), tube(3.0, 4.0, 20, 3)}) {
    const MeshReport report = report_of(mesh);
    EXPECT_TRUE(report.machinable) << report.reason;
    EXPECT_EQ(report.reason_code, "");
  }
}

TEST(MeshReport, MeasuresShape) {
  const MeshReport report = report_of(sheet_with_hole(5, 4, 2, 1));
  EXPECT_EQ(report.triangles, 38);
  EXPECT_EQ(report.vertices, 30);
  EXPECT_DOUBLE_EQ(report.area_mm2, 19.0);
  EXPECT_EQ(report.greatest_mm, Vec3(5, 4, 0));
  EXPECT_EQ(report.least_mm, Vec3(0, 0, 0));
  EXPECT_NEAR(report.least_angle_deg, 45.0, 1e-9);
  EXPECT_NEAR(report.greatest_angle_deg, 90.0, 1e-9);
  EXPECT_EQ(report.obtuse_triangles, 0);
  EXPECT_DOUBLE_EQ(report.median_edge_mm, 1.0);
  EXPECT_EQ(report.loops.size(), 2U);
}

TEST(MeshReport, SaysWhyAMeshCannotBeMachined) {
  TriangleMesh fin = sheet(2, 1);
  fin.vertices_mm.emplace_back(1.0, 0.5, 1.0);
  fin.triangles.push_back({1, 4, 6});
  const TriangleMesh torus_with_hole = [] {
    TriangleMesh mesh = torus(5.0, 2.0, 16, 9);
    mesh.triangles.pop_back();
    return mesh;
  }();
  const std::vector<std::pair<TriangleMesh, std::string>> expected = {
      {fin, "mesh-not-manifold"},
      {together(sheet(2, 2), sheet(3, 3)), "mesh-several-components"},
      {torus_with_hole, "mesh-handles"},
      {tetrahedron(), "mesh-no-boundary"},
      {turned(sheet(2, 2), {1}), "mesh-inconsistent-orientation"}};
  for (const auto& [mesh, code] : expected) {
    const MeshReport report = report_of(mesh);
    EXPECT_FALSE(report.machinable);
    EXPECT_EQ(report.reason_code, code);
    EXPECT_FALSE(report.reason.empty());
    EXPECT_EQ(report.reason.find('\n'), std::string::npos);
    const auto surface = machinable_surface({mesh, {}});
    ASSERT_FALSE(surface);
    EXPECT_EQ(surface.error().code, code);
  }
}

TEST(MeshReport, AChosenComponentIsTakenOutAlone) {
  const LoadedMesh both{together(sheet(2, 2), sheet_with_hole(5, 4, 2, 1)), {}};
  const auto largest = machinable_surface(both, 0), smallest = machinable_surface(both, 1);
  ASSERT_TRUE(largest);
  ASSERT_TRUE(smallest);
  EXPECT_EQ(largest->triangles.size(), 38U);
  EXPECT_EQ(smallest->triangles, sheet(2, 2).triangles);
  EXPECT_EQ(smallest->vertices_mm, sheet(2, 2).vertices_mm);
  const auto none = machinable_surface(both, 2);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, "component-out-of-range");
}

TEST(MeshReport, NeverFailsOnAnEmptyMesh) { EXPECT_EQ(report_of({}).reason_code, "mesh-empty"); }

}  // namespace
}  // namespace volute::geometry::test
