#include "planner/surface/condition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "geometry/mesh_measure.hpp"
#include "sample_surfaces.hpp"

namespace volute::planner {
namespace {

using geometry::MeshTopology;

samples::PlateOptions stretched() {
  samples::PlateOptions o;
  o.width_mm = 120.0;  // cells 3 to 1
  o.jitter = 0.3;
  o.random_diagonals = true;
  o.holes = {{0.0, 0.0, 8.0}};
  return o;
}

/// Sum of the two angles opposite to an inner edge, from the law of cosines.
double opposite_angles_rad(const TriangleMesh& mesh, const MeshTopology& topology, Index edge) {
  double sum = 0.0;
  for (Index h : {topology.edge_halfedge(edge), topology.opposite(topology.edge_halfedge(edge))}) {
    const auto& t = mesh.triangles[static_cast<std::size_t>(h / 3)];
    const auto at = [&](int k) -> const Vec3& {
      return mesh.vertices_mm[static_cast<std::size_t>(t[static_cast<std::size_t>((h % 3 + k) % 3)])];
    };
    const double c = (at(1) - at(0)).norm(), a = (at(2) - at(1)).norm(), b = (at(0) - at(2)).norm();
    sum += std::acos(std::clamp((a * a + b * b - c * c) / (2.0 * a * b), -1.0, 1.0));
  }
  return sum;
}

TEST(Condition, EveryEdgeOfAFlatSurfaceBecomesDelaunay) {
  const TriangleMesh surface = samples::plate(stretched());
  const auto result = condition(surface);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_GT(result->edges_flipped, 500);
  EXPECT_EQ(result->edges_not_delaunay, 0);
  TriangleMesh flipped = surface;
  ASSERT_TRUE(flip_to_delaunay(flipped));
  const auto topology = MeshTopology::build(flipped);
  ASSERT_TRUE(topology) << topology.error().message;
  for (Index e = 0; e < topology->edge_count(); ++e) {
    if (topology->opposite(topology->edge_halfedge(e)) == geometry::no_index) continue;
    ASSERT_LE(opposite_angles_rad(flipped, *topology, e), std::numbers::pi + 1e-6) << "edge " << e;
  }
}

TEST(Condition, TheSurfaceAndItsBoundaryStay) {
  const TriangleMesh surface = samples::plate(stretched());
  const auto result = condition(surface);
  ASSERT_TRUE(result);
  const auto before = MeshTopology::build(surface), after = MeshTopology::build(result->mesh);
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(geometry::area_mm2(result->mesh), geometry::area_mm2(surface), 1e-9 * geometry::area_mm2(surface));
  ASSERT_EQ(after->boundary_loops().size(), before->boundary_loops().size());
  for (std::size_t l = 0; l < before->boundary_loops().size(); ++l)
    EXPECT_NEAR(after->boundary_loops()[l].length_mm, before->boundary_loops()[l].length_mm, 1e-9);
}

TEST(Condition, AFeatureEdgeIsNotFlipped) {
  // Two obtuse triangles over a ridge of 90 degrees: flipping would cut the ridge off.
  const TriangleMesh ridge{{{0, 0, 0}, {10, 0, 0}, {5, 1, -1}, {5, -1, -1}}, {{0, 1, 2}, {1, 0, 3}}};
  TriangleMesh mesh = ridge;
  const auto flips = flip_to_delaunay(mesh);
  ASSERT_TRUE(flips);
  EXPECT_EQ(*flips, 0);
  TriangleMesh flat = ridge;
  flat.vertices_mm[2].z() = flat.vertices_mm[3].z() = 0.0;
  EXPECT_EQ(flip_to_delaunay(flat).value(), 1);
}

TEST(Condition, NoChordIsLeft) {
  TriangleMesh mesh = samples::ring(3.0, 5.0, 24, 1);  // one cell wide: no inner vertex
  mesh.triangles.erase(mesh.triangles.begin(),
                       mesh.triangles.begin() + 2);  // open it: one loop, every inner edge a chord
  const auto parents = split_chords(mesh);
  ASSERT_TRUE(parents);
  EXPECT_GE(parents->size(), 40U);
  const auto topology = MeshTopology::build(mesh);
  ASSERT_TRUE(topology);
  for (Index e = 0; e < topology->edge_count(); ++e) {
    const Index h = topology->edge_halfedge(e);
    if (topology->opposite(h) == geometry::no_index) continue;
    const auto& t = mesh.triangles[static_cast<std::size_t>(h / 3)];
    const Index a = t[static_cast<std::size_t>(h % 3)], b = t[static_cast<std::size_t>((h % 3 + 1) % 3)];
    EXPECT_FALSE(topology->is_boundary_vertex(a) && topology->is_boundary_vertex(b)) << a << ' ' << b;
  }
}

TEST(Condition, TheSameInputGivesTheSameTriangles) {
  const TriangleMesh surface = samples::plate(stretched());
  EXPECT_EQ(condition(surface)->mesh.triangles, condition(surface)->mesh.triangles);
}

}  // namespace
}  // namespace volute::planner
