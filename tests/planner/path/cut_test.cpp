#include "planner/surface/cut.hpp"

#include <gtest/gtest.h>

#include "geometry/mesh_measure.hpp"
#include "planner/surface/slice_path.hpp"
#include "sample_surfaces.hpp"

namespace volute::planner {
namespace {

using geometry::MeshTopology;

Index nearest_vertex(const TriangleMesh& mesh, double x, double y) {
  Index best = 0;
  for (Index v = 1; v < static_cast<Index>(mesh.vertices_mm.size()); ++v)
    if ((mesh.vertices_mm[static_cast<std::size_t>(v)] - Vec3(x, y, 0)).norm() <
        (mesh.vertices_mm[static_cast<std::size_t>(best)] - Vec3(x, y, 0)).norm())
      best = v;
  return best;
}

MeshWithPath plate_with_path(double x0, double y0, double x1, double y1) {
  samples::PlateOptions o;
  o.jitter = 0.3;
  o.random_diagonals = true;
  o.holes = {{0.0, 0.0, 6.0}};
  const TriangleMesh mesh = samples::plate(o);
  const auto topology = MeshTopology::build(mesh).value();
  const auto path = slice_path(mesh, topology, geometry::vertex_normals(mesh), nearest_vertex(mesh, x0, y0),
                               nearest_vertex(mesh, x1, y1));
  return insert_path(mesh, path.value());
}

TEST(Cut, AnInsertedPathIsMadeOfEdgesAndMovesNothing) {
  const MeshWithPath with = plate_with_path(-15, 10, 14, 12);
  const auto topology = MeshTopology::build(with.mesh);
  ASSERT_TRUE(topology) << topology.error().message;
  samples::PlateOptions o;
  EXPECT_NEAR(geometry::area_mm2(with.mesh), 1600.0 - 113.1, 2.0);
  ASSERT_GT(with.vertices.size(), 20U);
  for (std::size_t i = 0; i + 1 < with.vertices.size(); ++i) {
    bool joined = false;
    for (const geometry::Triangle& t : with.mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = t[k], b = t[(k + 1) % 3];
        joined = joined || (a == with.vertices[i] && b == with.vertices[i + 1]) ||
                 (b == with.vertices[i] && a == with.vertices[i + 1]);
      }
    EXPECT_TRUE(joined) << i;
  }
  for (const geometry::Triangle& t : with.mesh.triangles) {
    const auto at = [&](std::size_t k) { return with.mesh.vertices_mm[static_cast<std::size_t>(t[k])]; };
    EXPECT_GT((at(1) - at(0)).cross(at(2) - at(0)).z(), 0.0);
  }
}

TEST(Cut, ASlitInsideIsANewLoopOfTwiceItsInnerLength) {
  const MeshWithPath with = plate_with_path(-15, 10, 14, 12);
  const auto before = MeshTopology::build(with.mesh).value();
  const CutMesh cut = cut_open(with.mesh, before, std::span(&with.vertices, 1));
  const auto after = MeshTopology::build(cut.mesh);
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->boundary_loops().size(), before.boundary_loops().size() + 1);
  EXPECT_EQ(cut.mesh.vertices_mm.size(), with.mesh.vertices_mm.size() + with.vertices.size() - 2)
      << "the slit's tips stay one vertex";
  EXPECT_EQ(after->components()[0].handles, 0);
  for (std::size_t v = 0; v < cut.original.size(); ++v)
    EXPECT_EQ(cut.mesh.vertices_mm[v], with.mesh.vertices_mm[static_cast<std::size_t>(cut.original[v])]);
}

TEST(Cut, ACutFromHoleToRimLeavesOneLoop) {
  const MeshWithPath with = plate_with_path(-20, 0.5, -6, 0);
  const auto before = MeshTopology::build(with.mesh).value();
  const CutMesh cut = cut_open(with.mesh, before, std::span(&with.vertices, 1));
  const auto after = MeshTopology::build(cut.mesh);
  ASSERT_TRUE(after);
  EXPECT_EQ(before.boundary_loops().size(), 2U);
  EXPECT_EQ(after->boundary_loops().size(), 1U);
  EXPECT_EQ(cut.mesh.vertices_mm.size(), with.mesh.vertices_mm.size() + with.vertices.size());
}

}  // namespace
}  // namespace volute::planner
