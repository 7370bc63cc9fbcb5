#include "planner/surface/slice_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geometry/mesh_measure.hpp"
#include "sample_surfaces.hpp"

namespace volute::planner {
namespace {

using geometry::MeshTopology;

Index nearest_vertex(const TriangleMesh& mesh, const Vec3& place) {
  Index best = 0;
  for (Index v = 1; v < static_cast<Index>(mesh.vertices_mm.size()); ++v)
    if ((mesh.vertices_mm[static_cast<std::size_t>(v)] - place).norm() <
        (mesh.vertices_mm[static_cast<std::size_t>(best)] - place).norm())
      best = v;
  return best;
}

/// Do two points of a path share a triangle?
bool share_triangle(const TriangleMesh& mesh, const SurfacePoint& p, const SurfacePoint& q) {
  for (const geometry::Triangle& t : mesh.triangles) {
    const std::set<Index> corners(t.begin(), t.end());
    const auto holds = [&](const SurfacePoint& x) {
      return corners.contains(x.a) && (x.is_vertex() || corners.contains(x.b));
    };
    if (holds(p) && holds(q)) return true;
  }
  return false;
}

class SlicePathTest : public testing::Test {
 protected:
  SlicePathTest() {
    samples::PlateOptions o;
    o.holes = {{-8.0, 0.0, 5.0}, {9.0, 2.0, 5.0}};
    o.jitter = 0.25;
    o.height = [](double x, double y) { return 0.02 * (x * x + y * y); };
    mesh_ = samples::plate(o);
    topology_ = MeshTopology::build(mesh_).value();
    normals_ = geometry::vertex_normals(mesh_);
  }
  TriangleMesh mesh_;
  MeshTopology topology_;
  std::vector<Vec3> normals_;
};

TEST_F(SlicePathTest, RunsFromEndToEndInsideAndNearThePlane) {
  const Index from = nearest_vertex(mesh_, {-3.2, 0.5, 0.2}), to = nearest_vertex(mesh_, {4.2, 1.0, 0.3});
  const auto path = slice_path(mesh_, topology_, normals_, from, to);
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_EQ(path->front().a, from);
  EXPECT_EQ(path->back().a, to);
  const Vec3 &p = mesh_.vertices_mm[static_cast<std::size_t>(from)],
             &q = mesh_.vertices_mm[static_cast<std::size_t>(to)];
  const Vec3 plane =
      (normals_[static_cast<std::size_t>(from)] + normals_[static_cast<std::size_t>(to)]).cross(q - p).normalized();
  for (std::size_t i = 0; i + 1 < path->size(); ++i) {
    EXPECT_TRUE(share_triangle(mesh_, (*path)[i], (*path)[i + 1])) << i;
    EXPECT_FALSE(i > 0 && (*path)[i].is_vertex() && topology_.is_boundary_vertex((*path)[i].a)) << i;
    const double off = std::abs((position_mm(mesh_, (*path)[i]) - p).dot(plane));
    EXPECT_LT(off, (*path)[i].is_vertex() ? 0.13 * 2.0 : 1e-12) << "moved to a vertex by at most 0.12 of an edge";
  }
  EXPECT_LT(length_mm(mesh_, *path), 1.1 * (q - p).norm());
}

TEST_F(SlicePathTest, AHoleInTheWayIsAnErrorAndTheBridgeRunsAlongEdges) {
  const Index from = nearest_vertex(mesh_, {-20.0, 0.0, 8.0}), to = nearest_vertex(mesh_, {20.0, 1.0, 8.0});
  const auto sliced = slice_path(mesh_, topology_, normals_, from, to);
  ASSERT_FALSE(sliced);
  EXPECT_EQ(sliced.error().code, "surface-slice-stuck");
  const auto bridge = bridge_path(mesh_, topology_, normals_, from, to);
  ASSERT_TRUE(bridge);
  EXPECT_FALSE(bridge->sliced);
  for (std::size_t i = 1; i + 1 < bridge->path.size(); ++i)
    EXPECT_FALSE(topology_.is_boundary_vertex(bridge->path[i].a));
}

TEST_F(SlicePathTest, BothCasesOfThePaper) {
  // [Sun2016] 2.2.2: through vertices where the plane meets them (case 1), else through edges (case 2).
  samples::PlateOptions o;
  o.columns = o.rows = 10;
  o.width_mm = o.depth_mm = 10.0;
  const TriangleMesh grid = samples::plate(o);
  const auto topology = MeshTopology::build(grid).value();
  const auto normals = geometry::vertex_normals(grid);
  const auto through = [&](const Vec3& from, const Vec3& to) {
    return slice_path(grid, topology, normals, nearest_vertex(grid, from), nearest_vertex(grid, to)).value();
  };
  const SurfacePath along_row = through({-5, 1, 0}, {5, 1, 0});
  EXPECT_EQ(along_row.size(), 11U);
  for (const SurfacePoint& p : along_row) EXPECT_TRUE(p.is_vertex());
  const SurfacePath across = through({-5, -3, 0}, {5, 4, 0});
  int on_edges = 0;
  for (const SurfacePoint& p : across) {
    on_edges += p.is_vertex() ? 0 : 1;
    const Vec3 at = position_mm(grid, p);
    if (!p.is_vertex()) {
      EXPECT_NEAR(at.y() + 3.0, 0.7 * (at.x() + 5.0), 1e-12) << "in the plane";
    }
  }
  EXPECT_GT(on_edges, 10);
  EXPECT_LT(length_mm(grid, across), 1.02 * std::hypot(10.0, 7.0)) << "some points moved to vertices";
}

TEST_F(SlicePathTest, TheShortestEdgePathOfAGridIsItsTaxiLength) {
  samples::PlateOptions o;
  o.columns = o.rows = 10;
  o.width_mm = o.depth_mm = 10.0;
  const TriangleMesh grid = samples::plate(o);
  const auto topology = MeshTopology::build(grid).value();
  const Index from = nearest_vertex(grid, {-5, 0, 0}), to = nearest_vertex(grid, {5, 0, 0});
  const auto path = shortest_edge_path(grid, topology, std::span(&from, 1), std::span(&to, 1));
  ASSERT_TRUE(path);
  EXPECT_NEAR(length_mm(grid, *path), 10.0, 1e-12);
}

}  // namespace
}  // namespace volute::planner
