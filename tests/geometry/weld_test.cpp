#include <gtest/gtest.h>

#include <random>

#include "geometry/mesh_measure.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

TEST(Weld, JoinsAnStlSoupToTheMeshItCameFrom) {
  const TriangleMesh mesh = torus(5.0, 2.0, 30, 20);
  const LoadedMesh loaded = weld(soup_of(mesh));
  EXPECT_EQ(loaded.mesh.vertices_mm.size(), mesh.vertices_mm.size());
  EXPECT_EQ(loaded.mesh.triangles.size(), mesh.triangles.size());
  EXPECT_TRUE(loaded.repairs.warnings.empty());
  const auto topology = MeshTopology::build(loaded.mesh);
  ASSERT_TRUE(topology);
  EXPECT_EQ(topology->components()[0].handles, 1);
}

TEST(Weld, JoinsNearVerticesAndCountsThem) {
  const unsigned seed = 7;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-2e-4, 2e-4);
  TriangleMesh soup = soup_of(sphere(10.0, 3));
  for (Vec3& p : soup.vertices_mm) p += Vec3(shift(random), shift(random), shift(random));
  const LoadedMesh loaded = weld(soup, 1e-3);
  EXPECT_EQ(loaded.mesh.vertices_mm.size(), sphere(10.0, 3).vertices_mm.size());
  EXPECT_EQ(loaded.repairs.vertices_welded,
            static_cast<Index>(soup.vertices_mm.size() - loaded.mesh.vertices_mm.size()));
  EXPECT_EQ(loaded.repairs.warnings.size(), 1U);
}

TEST(Weld, KeepsApartWhatIsFartherThanTheTolerance) {
  TriangleMesh mesh = together(sheet(1, 1), sheet(1, 1));
  for (std::size_t v = 4; v < 8; ++v) mesh.vertices_mm[v].z() = 1e-3;
  EXPECT_EQ(weld(mesh, 0.9e-3).mesh.vertices_mm.size(), 8U);
  EXPECT_EQ(weld(mesh, 1.1e-3).mesh.vertices_mm.size(), 4U);
}

TEST(Weld, ZeroAndMinusZeroAreOnePoint) {
  TriangleMesh mesh = soup_of(sheet(1, 1));
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); v += 2) mesh.vertices_mm[v].z() = -0.0;
  EXPECT_EQ(weld(mesh, 0.0).mesh.vertices_mm.size(), 4U);
}

TEST(Weld, RemovesDuplicatesInEitherSense) {
  TriangleMesh mesh = sheet(3, 2);
  mesh.triangles.push_back(mesh.triangles[4]);
  mesh.triangles.push_back({mesh.triangles[7][1], mesh.triangles[7][0], mesh.triangles[7][2]});
  const LoadedMesh loaded = weld(mesh);
  EXPECT_EQ(loaded.repairs.duplicate_triangles_removed, 2);
  EXPECT_EQ(loaded.mesh.triangles, sheet(3, 2).triangles);
}

TEST(Weld, RemovesASliverWithoutOpeningAGap) {
  // The square 0 1 2 3 with an extra vertex on its diagonal: one half is cut there, the other has a sliver in between.
  TriangleMesh mesh{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}},
                    {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}}};
  const LoadedMesh loaded = weld(mesh);
  EXPECT_EQ(loaded.repairs.degenerate_triangles_removed, 1);
  const auto topology = MeshTopology::build(loaded.mesh);
  ASSERT_TRUE(topology) << topology.error().message;
  EXPECT_EQ(topology->boundary_loops().size(), 1U);
  EXPECT_EQ(topology->boundary_loops()[0].vertices.size(), 4U);
  EXPECT_DOUBLE_EQ(area_mm2(loaded.mesh), 4.0);
}

TEST(Weld, RemovesAChainOfSlivers) {
  // Two sheets that meet along a line, cut there differently, with slivers in the crack.
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, -1, 0}},
                    {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 5, 3}, {0, 2, 1}, {0, 3, 2}}};
  const LoadedMesh loaded = weld(mesh);
  EXPECT_EQ(loaded.repairs.degenerate_triangles_removed, 2);
  const auto topology = MeshTopology::build(loaded.mesh);
  ASSERT_TRUE(topology) << topology.error().message;
  EXPECT_EQ(topology->boundary_loops().size(), 1U);
  EXPECT_DOUBLE_EQ(area_mm2(loaded.mesh), 3.0);
}

TEST(Weld, DropsUnusedVertices) {
  TriangleMesh mesh = sheet(1, 1);
  mesh.vertices_mm.insert(mesh.vertices_mm.begin(), Vec3(9, 9, 9));
  for (Triangle& t : mesh.triangles)
    for (Index& v : t) ++v;
  EXPECT_EQ(weld(mesh).mesh.vertices_mm, sheet(1, 1).vertices_mm);
}

TEST(Orientation, MajorityKeepsItsSide) {
  TriangleMesh mesh = turned(sheet(4, 4), {1, 9, 30});
  const auto count = make_orientation_consistent(mesh);
  ASSERT_TRUE(count);
  EXPECT_EQ(*count, 3);
  ASSERT_TRUE(MeshTopology::build(mesh));
  for (const Vec3& n : triangle_normals(mesh)) EXPECT_DOUBLE_EQ(n.z(), 1.0);
}

TEST(Orientation, RandomTurnsAreUndone) {
  const unsigned seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int i = 0; i < cases(50); ++i) {
    std::vector<Index> chosen;
    for (Index t = 0; t < 512; ++t)
      if (random() % 4 == 0) chosen.push_back(t);
    TriangleMesh mesh = turned(sphere(4.0, 3), chosen);
    const auto count = make_orientation_consistent(mesh);
    ASSERT_TRUE(count);
    EXPECT_EQ(*count, static_cast<Index>(chosen.size()));
    EXPECT_TRUE(MeshTopology::build(mesh));
  }
}

TEST(Orientation, AMoebiusBandHasNone) {
  TriangleMesh mesh = moebius_band(20);
  const auto count = make_orientation_consistent(mesh);
  ASSERT_FALSE(count);
  EXPECT_EQ(count.error().code, "mesh-not-orientable");
}

}  // namespace
}  // namespace volute::geometry::test
