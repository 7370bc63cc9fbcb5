#include "geometry/mesh_clean.hpp"

#include <algorithm>
#include <optional>

#include "geometry/edge_groups.hpp"
#include "geometry/index.hpp"

namespace volute::geometry {

namespace {

bool has_equal_corners(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Corner that the longest edge leaves, when the triangle is no higher over that edge than the tolerance.
std::optional<Index> sliver_edge(const TriangleMesh& mesh, const Triangle& t, double tolerance_mm) {
  const Vec3 &a = mesh.vertices_mm[at(t[0])], &b = mesh.vertices_mm[at(t[1])], &c = mesh.vertices_mm[at(t[2])];
  const double lengths_sq[3] = {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()};
  const auto longest = std::max_element(lengths_sq, lengths_sq + 3) - lengths_sq;
  const double double_area = (b - a).cross(c - a).norm();
  if (double_area * double_area > tolerance_mm * tolerance_mm * lengths_sq[longest]) return std::nullopt;
  return static_cast<Index>(longest);
}

Index erase_marked(TriangleMesh& mesh, const std::vector<char>& marked) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (marked[t] == 0) mesh.triangles[kept++] = mesh.triangles[t];
  const auto removed = static_cast<Index>(mesh.triangles.size() - kept);
  mesh.triangles.resize(kept);
  return removed;
}

Index remove_equal_corners(TriangleMesh& mesh) {
  std::vector<char> marked(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), marked.begin(),
                 [](const Triangle& t) { return has_equal_corners(t) ? 1 : 0; });
  return erase_marked(mesh, marked);
}

/// The long edges of all slivers, as halfedges.
std::vector<Index> sliver_halfedges(const TriangleMesh& mesh, double tolerance_mm) {
  std::vector<Index> halfedges;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    if (const auto corner = sliver_edge(mesh, mesh.triangles[at(t)], tolerance_mm))
      halfedges.push_back(3 * t + *corner);
  return halfedges;
}

/// The triangle across a sliver's long edge, unless there is none, several, or one that this pass has changed.
std::optional<Index> partner_halfedge(const EdgeGroups& edges, const std::vector<Index>& edge_of, Index halfedge) {
  const auto group = edges.group(edge_of[at(halfedge)]);
  if (group.size() != 2) return std::nullopt;
  return group[0] == halfedge ? group[1] : group[0];
}

/// One pass: every sliver goes, its neighbour is split; slivers next to each other wait for the next pass.
void remove_slivers_once(TriangleMesh& mesh, const std::vector<Index>& slivers) {
  const EdgeGroups edges = group_edges(mesh);
  std::vector<Index> edge_of(3 * mesh.triangles.size());
  for (Index e = 0; e < edges.count(); ++e)
    for (const Index h : edges.group(e)) edge_of[at(h)] = e;
  std::vector<char> touched(mesh.triangles.size(), 0), gone(mesh.triangles.size(), 0);
  for (const Index h : slivers) {
    const Index sliver = halfedge_triangle(h);
    if (touched[at(sliver)] != 0) continue;
    const std::optional<Index> across = partner_halfedge(edges, edge_of, h);
    if (across && touched[at(halfedge_triangle(*across))] != 0) continue;
    touched[at(sliver)] = 1;
    if (!across) {
      gone[at(sliver)] = 1;
      continue;
    }
    const Index middle = origin(mesh, previous_halfedge(h)), apex = origin(mesh, previous_halfedge(*across));
    const Index from = origin(mesh, *across), to = target(mesh, *across);
    touched[at(halfedge_triangle(*across))] = 1;
    mesh.triangles[at(sliver)] = {from, middle, apex};
    mesh.triangles[at(halfedge_triangle(*across))] = {middle, to, apex};
  }
  erase_marked(mesh, gone);
}

struct KeyedTriangle {
  Triangle key;
  Index triangle;
  friend bool operator<(const KeyedTriangle& a, const KeyedTriangle& b) {
    return a.key != b.key ? a.key < b.key : a.triangle < b.triangle;
  }
};

/// All triangles by the lowest of their corners, each bucket in order of the sorted corners.
std::vector<KeyedTriangle> keyed_by_corners(const TriangleMesh& mesh) {
  std::vector<std::size_t> start(mesh.vertices_mm.size() + 1, 0);
  for (const Triangle& t : mesh.triangles) ++start[at(*std::min_element(t.begin(), t.end())) + 1];
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<std::size_t> fill(start.begin(), start.end() - 1);
  std::vector<KeyedTriangle> keyed(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle key = mesh.triangles[t];
    std::sort(key.begin(), key.end());
    keyed[fill[at(key[0])]++] = {key, static_cast<Index>(t)};
  }
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
    std::sort(keyed.begin() + static_cast<std::ptrdiff_t>(start[v]),
              keyed.begin() + static_cast<std::ptrdiff_t>(start[v + 1]));
  return keyed;
}

}  // namespace

Index remove_degenerate(TriangleMesh& mesh, double tolerance_mm) {
  constexpr int most_passes = 20;  // a fan of slivers loses at least every second one in each pass
  Index removed = remove_equal_corners(mesh);
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::vector<Index> slivers = sliver_halfedges(mesh, tolerance_mm);
    if (slivers.empty()) return removed;
    if (pass == 0) removed += static_cast<Index>(slivers.size());  // later ones come from splitting these
    remove_slivers_once(mesh, slivers);
    remove_equal_corners(mesh);
  }
  std::vector<char> marked(mesh.triangles.size(), 0);
  for (const Index h : sliver_halfedges(mesh, tolerance_mm)) marked[at(halfedge_triangle(h))] = 1;
  erase_marked(mesh, marked);
  return removed;
}

Index remove_duplicates(TriangleMesh& mesh) {
  const std::vector<KeyedTriangle> keyed = keyed_by_corners(mesh);
  std::vector<char> marked(mesh.triangles.size(), 0);
  for (std::size_t i = 1; i < keyed.size(); ++i)
    if (keyed[i].key == keyed[i - 1].key) marked[at(keyed[i].triangle)] = 1;
  return erase_marked(mesh, marked);
}

}  // namespace volute::geometry
