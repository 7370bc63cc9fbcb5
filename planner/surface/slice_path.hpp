// Paths on the surface between two vertices: by a slicing plane ([Sun2016] 2.2), or along edges where slicing sticks.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/result.hpp"
#include "planner/surface/surface_path.hpp"

namespace volute::planner {

using geometry::Result;

/// The plane through both vertices that holds the mean of their normals cuts the surface; the cut is traced from
/// `from`. [Sun2016] eq. 1, 2; case 1 (through a vertex) and case 2 (through an edge) of 2.2.2. Points closer to an
/// inner vertex than a share of 0.12 of their edge are moved there, so that no sliver appears. Requires: from != to.
/// Errors (bad_input): surface-slice-stuck (the plane leaves the surface before it reaches `to`, touches a boundary
/// between its ends, or makes a detour of over three times the distance). Properties: 1. First and last points are the
/// two vertices, no other point lies on the boundary.
/// 2. Before points are moved to vertices, all lie in one plane. 3. Consecutive points share a triangle.
Result<SurfacePath> slice_path(const TriangleMesh& mesh, const geometry::MeshTopology& topology,
                               std::span<const Vec3> vertex_normals, Index from, Index to);

/// What an edge from one vertex to another costs, mm; infinite: it is not taken. Requires: no less than 0.
using EdgeCost = std::function<double(Index, Index)>;

/// The shortest (or with `cost` the cheapest) chain of edges from any of `sources` to any of `targets` whose inner
/// vertices are no boundary vertices (Dijkstra; ties by vertex number). Errors (bad_input): surface-no-path.
Result<SurfacePath> shortest_edge_path(const TriangleMesh& mesh, const geometry::MeshTopology& topology,
                                       std::span<const Index> sources, std::span<const Index> targets,
                                       const EdgeCost& cost = {});

struct BridgePath {
  SurfacePath path;
  bool sliced = true;  ///< false: the plane stuck and the path runs along edges
};
/// slice_path, else shortest_edge_path. Errors: surface-no-path.
Result<BridgePath> bridge_path(const TriangleMesh& mesh, const geometry::MeshTopology& topology,
                               std::span<const Vec3> vertex_normals, Index from, Index to);

}  // namespace volute::planner
