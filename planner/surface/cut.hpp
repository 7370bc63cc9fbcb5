// Makes a path on the surface part of the mesh's edges, and cuts the mesh open along chains of edges.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "planner/surface/surface_path.hpp"

namespace volute::planner {

struct MeshWithPath {
  TriangleMesh mesh;            ///< old vertices keep their numbers; points inside edges stand behind them
  std::vector<Index> vertices;  ///< the path's points as vertices; consecutive ones are joined by an edge
  std::vector<Index> parent;    ///< for each triangle of `mesh`, the triangle of the old mesh that it is or lies in
};
/// Splits the triangles that the path crosses. The surface does not move.
/// Requires: `path` as SurfacePath says, at most one segment inside any triangle.
MeshWithPath insert_path(const TriangleMesh& mesh, const SurfacePath& path);

struct CutMesh {
  TriangleMesh mesh;            ///< the same triangles in the same order
  std::vector<Index> original;  ///< for each vertex, its number before the cut; original[v] = v for all old vertices
};
/// Doubles the vertices along the chains so that both sides come apart; an end inside the surface stays one vertex.
/// Requires: consecutive vertices of each chain are joined by an edge.
CutMesh cut_open(const TriangleMesh& mesh, const geometry::MeshTopology& topology,
                 std::span<const std::vector<Index>> chains);

}  // namespace volute::planner
