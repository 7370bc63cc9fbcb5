#include <gtest/gtest.h>

#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

std::vector<TriangleMesh> sound_meshes() {
  return {sheet(4, 3),
          sheet_with_hole(5, 4, 2, 1),
          tetrahedron(),
          sphere(3.0, 2),
          tube(2.0, 5.0, 12, 4),
          torus(5.0, 2.0, 16, 9),
          together(sheet(6, 6), torus(5.0, 2.0, 8, 7))};
}

TEST(MeshTopology, OppositeOfOppositeIsTheHalfedgeOnInnerEdges) {
  for (const TriangleMesh& mesh : sound_meshes()) {
    const auto topology = MeshTopology::build(mesh);
    ASSERT_TRUE(topology) << topology.error().message;
    for (Index h = 0; h < 3 * topology->triangle_count(); ++h) {
      if (topology->opposite(h) == no_index) continue;
      EXPECT_EQ(topology->opposite(topology->opposite(h)), h);
      EXPECT_EQ(topology->edge(topology->opposite(h)), topology->edge(h));
    }
  }
}

TEST(MeshTopology, EveryBoundaryVertexHasExactlyOneLoopThroughIt) {
  for (const TriangleMesh& mesh : sound_meshes()) {
    const auto topology = MeshTopology::build(mesh);
    ASSERT_TRUE(topology);
    std::vector<int> loops(mesh.vertices_mm.size(), 0);
    for (const BoundaryLoop& loop : topology->boundary_loops())
      for (const Index v : loop.vertices) ++loops[static_cast<std::size_t>(v)];
    for (Index v = 0; v < topology->vertex_count(); ++v)
      EXPECT_EQ(loops[static_cast<std::size_t>(v)], topology->is_boundary_vertex(v) ? 1 : 0);
  }
}

TEST(MeshTopology, EulerCharacteristicOfComponentsIsVertexMinusEdgesPlusFaces) {
  for (const TriangleMesh& mesh : sound_meshes()) {
    const auto topology = MeshTopology::build(mesh);
    ASSERT_TRUE(topology);
    Index sum = 0;
    for (const Component& c : topology->components()) sum += 2 - c.boundary_loops - 2 * c.handles;
    EXPECT_EQ(sum, topology->vertex_count() - topology->edge_count() + topology->triangle_count());
  }
}

TEST(MeshTopology, TurnsOutgoingHalfedgesCounterClockwiseFromTheBoundary) {
  const TriangleMesh mesh = sheet_with_hole(5, 4, 2, 1);
  const auto topology = MeshTopology::build(mesh);
  ASSERT_TRUE(topology);
  for (Index v = 0; v < topology->vertex_count(); ++v) {
    const auto fan = topology->outgoing(v);
    EXPECT_EQ(topology->opposite(fan.front()) == no_index, topology->is_boundary_vertex(v));
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
      const auto direction = [&](Index h) {
        const Triangle& t = mesh.triangles[static_cast<std::size_t>(halfedge_triangle(h))];
        return Vec3(mesh.vertices_mm[static_cast<std::size_t>(t[static_cast<std::size_t>((h + 1) % 3)])] -
                    mesh.vertices_mm[static_cast<std::size_t>(v)]);
      };
      EXPECT_GT(direction(fan[i]).cross(direction(fan[i + 1])).z(), 0.0);
    }
  }
}

double signed_area(const TriangleMesh& mesh, const BoundaryLoop& loop) {
  double area = 0.0;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const Vec3& a = mesh.vertices_mm[static_cast<std::size_t>(loop.vertices[i])];
    const Vec3& b = mesh.vertices_mm[static_cast<std::size_t>(loop.vertices[(i + 1) % loop.vertices.size()])];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

TEST(MeshTopology, KeepsTheSurfaceOnTheLeftOfItsLoopsLongestFirst) {
  const TriangleMesh mesh = sheet_with_hole(5, 4, 2, 1);
  const auto topology = MeshTopology::build(mesh);
  ASSERT_TRUE(topology);
  ASSERT_EQ(topology->boundary_loops().size(), 2U);
  EXPECT_DOUBLE_EQ(topology->boundary_loops()[0].length_mm, 18.0);
  EXPECT_DOUBLE_EQ(topology->boundary_loops()[1].length_mm, 4.0);
  EXPECT_DOUBLE_EQ(signed_area(mesh, topology->boundary_loops()[0]), 20.0);
  EXPECT_DOUBLE_EQ(signed_area(mesh, topology->boundary_loops()[1]), -1.0);
}

TEST(MeshTopology, CountsHandlesAndOrdersComponentsByArea) {
  const auto topology = MeshTopology::build(together(sheet(3, 3), torus(50.0, 20.0, 30, 20)));
  ASSERT_TRUE(topology);
  ASSERT_EQ(topology->components().size(), 2U);
  EXPECT_EQ(topology->components()[0].handles, 1);
  EXPECT_EQ(topology->components()[0].boundary_loops, 0);
  EXPECT_EQ(topology->components()[0].triangles, 1200);
  EXPECT_EQ(topology->components()[1].handles, 0);
  EXPECT_EQ(topology->components()[1].boundary_loops, 1);
  EXPECT_EQ(topology->component_of_triangle(0), 1);
  EXPECT_EQ(topology->boundary_loops()[0].component, 1);
}

std::string refusal(const TriangleMesh& mesh) {
  const auto topology = MeshTopology::build(mesh);
  return topology ? "" : topology.error().code;
}

TEST(MeshTopology, NamesWhatIsNoManifold) {
  TriangleMesh fin = sheet(2, 1);
  fin.vertices_mm.emplace_back(1.0, 0.5, 1.0);
  fin.triangles.push_back({1, 4, 6});  // a third triangle on the inner edge between vertices 1 and 4
  EXPECT_EQ(refusal(fin), "mesh-not-manifold");

  TriangleMesh bow_tie = together(sheet(1, 1), sheet(1, 1));
  for (Triangle& t : bow_tie.triangles)
    for (Index& v : t)
      if (v == 4) v = 3;  // two squares that share one corner
  EXPECT_EQ(refusal(bow_tie), "mesh-not-manifold");

  TriangleMesh cones = together(tetrahedron(), tetrahedron());
  for (Triangle& t : cones.triangles)
    for (Index& v : t)
      if (v == 7) v = 3;  // two closed solids that share one corner
  EXPECT_EQ(refusal(cones), "mesh-not-manifold");
}

TEST(MeshTopology, NamesBadTriangles) {
  EXPECT_EQ(refusal({}), "mesh-empty");
  TriangleMesh mesh = sheet(2, 2);
  mesh.triangles[3][1] = 99;
  EXPECT_EQ(refusal(mesh), "mesh-index-out-of-range");
  mesh.triangles[3][1] = -1;
  EXPECT_EQ(refusal(mesh), "mesh-index-out-of-range");
  mesh.triangles[3][1] = mesh.triangles[3][2];
  EXPECT_EQ(refusal(mesh), "mesh-degenerate-triangle");
  EXPECT_EQ(refusal(turned(sheet(2, 2), {3})), "mesh-inconsistent-orientation");
}

TEST(MeshTopology, AllowsVerticesThatNoTriangleUses) {
  TriangleMesh mesh = sheet(2, 2);
  mesh.vertices_mm.emplace_back(9, 9, 9);
  const auto topology = MeshTopology::build(mesh);
  ASSERT_TRUE(topology);
  EXPECT_TRUE(topology->outgoing(9).empty());
  EXPECT_EQ(topology->components()[0].handles, 0);
}

}  // namespace
}  // namespace volute::geometry::test
