#include "geometry/edge_groups.hpp"

#include <algorithm>

namespace volute::geometry {

namespace {

struct EdgeEntry {
  Index upper = 0, halfedge = 0;
  friend bool operator<(const EdgeEntry& a, const EdgeEntry& b) {
    return a.upper != b.upper ? a.upper < b.upper : a.halfedge < b.halfedge;
  }
};

struct Buckets {
  std::vector<EdgeEntry> entries;
  std::vector<std::size_t> start;
};

/// Counting sort of all halfedges by the lower of their two vertices.
Buckets bucket_by_lower_vertex(const TriangleMesh& mesh) {
  Buckets buckets;
  const auto halfedges = static_cast<Index>(3 * mesh.triangles.size());
  buckets.start.assign(mesh.vertices_mm.size() + 2, 0);
  const auto lower = [&](Index h) { return static_cast<std::size_t>(std::min(origin(mesh, h), target(mesh, h))); };
  for (Index h = 0; h < halfedges; ++h) ++buckets.start[lower(h) + 2];
  for (std::size_t i = 2; i < buckets.start.size(); ++i) buckets.start[i] += buckets.start[i - 1];
  buckets.entries.resize(static_cast<std::size_t>(halfedges));
  for (Index h = 0; h < halfedges; ++h)
    buckets.entries[buckets.start[lower(h) + 1]++] = {std::max(origin(mesh, h), target(mesh, h)), h};
  return buckets;
}

}  // namespace

EdgeGroups group_edges(const TriangleMesh& mesh) {
  Buckets buckets = bucket_by_lower_vertex(mesh);
  EdgeGroups groups;
  groups.halfedges.reserve(buckets.entries.size());
  groups.start.reserve(buckets.entries.size() / 2 + 2);
  for (std::size_t v = 0; v + 1 < buckets.start.size(); ++v) {
    const auto first = buckets.entries.begin() + static_cast<std::ptrdiff_t>(buckets.start[v]);
    const auto last = buckets.entries.begin() + static_cast<std::ptrdiff_t>(buckets.start[v + 1]);
    std::sort(first, last);
    for (auto entry = first; entry != last; ++entry) {
      if (entry == first || entry->upper != (entry - 1)->upper)
        groups.start.push_back(static_cast<Index>(groups.halfedges.size()));
      groups.halfedges.push_back(entry->halfedge);
    }
  }
  groups.start.push_back(static_cast<Index>(groups.halfedges.size()));
  return groups;
}

}  // namespace volute::geometry
