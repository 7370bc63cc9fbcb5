#include "geometry/mesh.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>

#include "geometry/edge_groups.hpp"
#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"

namespace volute::geometry {

namespace {

std::string text(Index number) { return std::to_string(number); }
Result<void> check_corners(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return bad_input("mesh-empty", "the mesh has no triangle; a surface needs at least one");
  const auto vertices = static_cast<Index>(mesh.vertices_mm.size());
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const Triangle& corners = mesh.triangles[at(t)];
    for (const Index v : corners) {
      if (v < 0 || v >= vertices)
        return bad_input("mesh-index-out-of-range", "triangle " + text(t) + ": vertex " + text(v) +
                                                        " does not exist (the mesh has " + text(vertices) +
                                                        "); export the mesh again");
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
      return bad_input("mesh-degenerate-triangle", "triangle " + text(t) + ": two of its corners are vertex " +
                                                       text(corners[0] == corners[1] ? corners[0] : corners[2]) +
                                                       "; drop triangles without area");
  }
  return {};
}

std::string edge_text(const TriangleMesh& mesh, Index halfedge) {
  return "the edge between vertices " + text(origin(mesh, halfedge)) + " and " + text(target(mesh, halfedge));
}

Result<void> check_edges(const TriangleMesh& mesh, const EdgeGroups& edges) {
  for (Index e = 0; e < edges.count(); ++e) {
    const auto group = edges.group(e);
    if (group.size() > 2)
      return bad_input("mesh-not-manifold", "triangle " + text(halfedge_triangle(group[2])) + ": " +
                                                edge_text(mesh, group[0]) + " has " +
                                                text(static_cast<Index>(group.size())) +
                                                " triangles; an edge of a surface has one or two: repair the mesh");
  }
  for (Index e = 0; e < edges.count(); ++e) {
    const auto group = edges.group(e);
    if (group.size() == 2 && origin(mesh, group[0]) == origin(mesh, group[1]))
      return bad_input("mesh-inconsistent-orientation",
                       "triangle " + text(halfedge_triangle(group[1])) + ": it runs along " +
                           edge_text(mesh, group[0]) + " the same way as triangle " +
                           text(halfedge_triangle(group[0])) +
                           "; all corners must be counter-clockwise seen from outside");
  }
  return {};
}

/// First the outgoing halfedge on the boundary, if any; no_index when a vertex has two of them.
std::optional<Index> fan_start(std::span<const Index> outgoing, const std::vector<Index>& opposite) {
  std::optional<Index> start;
  for (const Index h : outgoing) {
    if (opposite[at(h)] != no_index) continue;
    if (start) return std::nullopt;
    start = h;
  }
  return start ? *start : outgoing.front();
}

/// Puts the halfedges that leave one vertex in counter-clockwise order; false when they are not one fan.
bool order_fan(std::span<Index> outgoing, const std::vector<Index>& opposite) {
  const std::optional<Index> start = fan_start(outgoing, opposite);
  if (!start) return false;
  std::size_t count = 0;
  Index h = *start;
  do {
    if (count == outgoing.size()) return false;
    outgoing[count++] = h;
    h = opposite[at(previous_halfedge(h))];
  } while (h != no_index && h != *start);
  return count == outgoing.size();
}

/// Halfedges by the vertex they leave.
void bucket_outgoing(const TriangleMesh& mesh, std::vector<Index>& start, std::vector<Index>& outgoing) {
  const auto halfedges = static_cast<Index>(3 * mesh.triangles.size());
  start.assign(mesh.vertices_mm.size() + 2, 0);
  for (Index h = 0; h < halfedges; ++h) ++start[at(origin(mesh, h)) + 2];
  std::partial_sum(start.begin(), start.end(), start.begin());
  outgoing.resize(at(halfedges));
  for (Index h = 0; h < halfedges; ++h) outgoing[at(start[at(origin(mesh, h)) + 1]++)] = h;
  start.pop_back();
}

/// Component number of every triangle, in order of the first triangle. Returns their number.
Index flood_components(const std::vector<Index>& opposite, std::vector<Index>& component) {
  component.assign(opposite.size() / 3, no_index);
  std::vector<Index> stack;
  Index count = 0;
  for (Index seed = 0; seed < static_cast<Index>(component.size()); ++seed) {
    if (component[at(seed)] != no_index) continue;
    component[at(seed)] = count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        if (opposite[at(h)] == no_index) continue;
        const Index neighbour = halfedge_triangle(opposite[at(h)]);
        if (component[at(neighbour)] != no_index) continue;
        component[at(neighbour)] = count;
        stack.push_back(neighbour);
      }
    }
    ++count;
  }
  return count;
}

/// Numbers the components again, by falling area (equal areas keep their order).
void order_components_by_area(const TriangleMesh& mesh, Index count, std::vector<Index>& component) {
  if (count == 1) return;
  std::vector<double> areas(at(count), 0.0);
  for (std::size_t t = 0; t < component.size(); ++t)
    areas[at(component[t])] += triangle_area_mm2(mesh, static_cast<Index>(t));
  std::vector<Index> order(at(count));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return areas[at(a)] > areas[at(b)]; });
  std::vector<Index> rank(at(count));
  for (Index i = 0; i < count; ++i) rank[at(order[at(i)])] = i;
  for (Index& c : component) c = rank[at(c)];
}

}  // namespace

std::span<const Index> MeshTopology::outgoing(Index vertex) const {
  const Index first = outgoing_start_[at(vertex)], last = outgoing_start_[at(vertex) + 1];
  return {outgoing_.data() + first, at(last - first)};
}

Result<void> MeshTopology::order_fans(const TriangleMesh& mesh) {
  bucket_outgoing(mesh, outgoing_start_, outgoing_);
  boundary_vertex_.assign(mesh.vertices_mm.size(), 0);
  for (Index v = 0; v < vertex_count_; ++v) {
    const Index first = outgoing_start_[at(v)], last = outgoing_start_[at(v) + 1];
    if (first == last) continue;
    if (!order_fan({outgoing_.data() + first, at(last - first)}, opposite_))
      return bad_input("mesh-not-manifold",
                       "triangle " + text(halfedge_triangle(outgoing_[at(first)])) + ": at its vertex " + text(v) +
                           " the surface touches itself (its triangles do not form one fan); move the vertices apart");
    boundary_vertex_[at(v)] = opposite_[at(outgoing_[at(first)])] == no_index ? 1 : 0;
  }
  return {};
}

void MeshTopology::trace_loops(const TriangleMesh& mesh) {
  std::vector<char> seen(at(vertex_count_), 0);
  for (Index seed = 0; seed < vertex_count_; ++seed) {
    if (!is_boundary_vertex(seed) || seen[at(seed)] != 0) continue;
    BoundaryLoop loop;
    loop.component = component_[at(halfedge_triangle(outgoing(seed).front()))];
    for (Index v = seed; seen[at(v)] == 0; v = target(mesh, outgoing(v).front())) {
      seen[at(v)] = 1;
      loop.vertices.push_back(v);
      loop.length_mm += (mesh.vertices_mm[at(target(mesh, outgoing(v).front()))] - mesh.vertices_mm[at(v)]).norm();
    }
    ++components_[at(loop.component)].boundary_loops;
    loops_.push_back(std::move(loop));
  }
  std::stable_sort(loops_.begin(), loops_.end(),
                   [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.length_mm > b.length_mm; });
}

void MeshTopology::count_handles() {
  std::vector<Index> characteristic(components_.size(), 0);
  for (Index v = 0; v < vertex_count_; ++v)
    if (!outgoing(v).empty()) ++characteristic[at(component_[at(halfedge_triangle(outgoing(v).front()))])];
  for (const Index h : edge_halfedge_) --characteristic[at(component_[at(halfedge_triangle(h))])];
  for (std::size_t c = 0; c < components_.size(); ++c) {
    characteristic[c] += components_[c].triangles;
    components_[c].handles = (2 - components_[c].boundary_loops - characteristic[c]) / 2;
  }
}

Result<MeshTopology> MeshTopology::build(const TriangleMesh& mesh) {
  if (auto corners = check_corners(mesh); !corners) return tl::unexpected(corners.error());
  const EdgeGroups edges = group_edges(mesh);
  if (auto sound = check_edges(mesh, edges); !sound) return tl::unexpected(sound.error());

  MeshTopology topology;
  topology.vertex_count_ = static_cast<Index>(mesh.vertices_mm.size());
  topology.edge_count_ = edges.count();
  topology.opposite_.assign(3 * mesh.triangles.size(), no_index);
  topology.edge_.resize(3 * mesh.triangles.size());
  for (Index e = 0; e < edges.count(); ++e) {
    const auto group = edges.group(e);
    topology.edge_halfedge_.push_back(group[0]);
    for (const Index h : group) topology.edge_[at(h)] = e;
    if (group.size() == 2) {
      topology.opposite_[at(group[0])] = group[1];
      topology.opposite_[at(group[1])] = group[0];
    }
  }
  if (auto fans = topology.order_fans(mesh); !fans) return tl::unexpected(fans.error());
  const Index count = flood_components(topology.opposite_, topology.component_);
  order_components_by_area(mesh, count, topology.component_);
  topology.components_.resize(at(count));
  for (const Index c : topology.component_) ++topology.components_[at(c)].triangles;
  topology.trace_loops(mesh);
  topology.count_handles();
  return topology;
}

}  // namespace volute::geometry
