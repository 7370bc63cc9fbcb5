// Halfedges that lie on the same undirected edge, found without sorting the whole mesh. Internal to `geometry`.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.hpp"

namespace volute::geometry {

/// Group g is one undirected edge; its halfedges are in rising order. Groups are ordered by (lower vertex, upper
/// vertex).
struct EdgeGroups {
  std::vector<Index> halfedges;
  std::vector<Index> start;  ///< group g is halfedges[start[g]] .. halfedges[start[g + 1]]

  [[nodiscard]] Index count() const { return static_cast<Index>(start.size()) - 1; }
  [[nodiscard]] std::span<const Index> group(Index edge) const {
    const auto first = static_cast<std::size_t>(start[static_cast<std::size_t>(edge)]);
    const auto last = static_cast<std::size_t>(start[static_cast<std::size_t>(edge) + 1]);
    return {halfedges.data() + first, last - first};
  }
};

inline Index origin(const TriangleMesh& mesh, Index halfedge) {
  return mesh.triangles[static_cast<std::size_t>(halfedge / 3)][static_cast<std::size_t>(halfedge % 3)];
}
inline Index target(const TriangleMesh& mesh, Index halfedge) { return origin(mesh, next_halfedge(halfedge)); }

/// Requires: every vertex index of `mesh` is in range.
EdgeGroups group_edges(const TriangleMesh& mesh);

}  // namespace volute::geometry
