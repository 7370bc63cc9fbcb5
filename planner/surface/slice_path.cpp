#include "planner/surface/slice_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <string>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"

namespace volute::planner {

using geometry::bad_input;
using geometry::halfedge_triangle;
using geometry::MeshTopology;
using geometry::next_halfedge;
using geometry::no_index;
using geometry::previous_halfedge;

namespace {

constexpr double snap_share = 0.12;
constexpr double detour_max = 3.0;

class Slicer {
 public:
  Slicer(const TriangleMesh& mesh, const MeshTopology& topology, std::span<const Vec3> normals, Index from, Index to)
      : mesh_(mesh), topology_(topology), from_(from), to_(to) {
    towards_ = (at(to) - at(from)).normalized();                                                        // n_A of eq. 1
    const Vec3 mean = normals[static_cast<std::size_t>(from)] + normals[static_cast<std::size_t>(to)];  // n_OG
    plane_normal_ = mean.cross(towards_);
    if (plane_normal_.norm() < 1e-9) plane_normal_ = towards_.unitOrthogonal();
    plane_normal_.normalize();
  }

  /// Nothing when the trace sticks.
  std::optional<SurfacePath> trace() {
    SurfacePath path{SurfacePoint::vertex(from_)};
    Vec3 direction = towards_;
    Index triangle = no_index;
    double length = 0.0;
    const double length_max = detour_max * (at(to_) - at(from_)).norm();
    while (!(path.back().is_vertex() && path.back().a == to_)) {
      const auto step = path.back().is_vertex() ? from_vertex(path.back().a, direction, path.size() == 1)
                                                : from_edge(path.back(), triangle);
      if (!step) return std::nullopt;
      const Vec3 move = position_mm(mesh_, step->point) - position_mm(mesh_, path.back());
      length += move.norm();
      if (length > length_max || (touches_boundary(step->point) && !step->point.touches(to_))) return std::nullopt;
      if (move.norm() > 0.0) direction = move.normalized();
      triangle = step->triangle;
      path.push_back(step->point);
    }
    return path;
  }

 private:
  struct Step {
    SurfacePoint point;
    Index triangle;  ///< the one that was crossed
  };

  [[nodiscard]] const Vec3& at(Index v) const { return mesh_.vertices_mm[static_cast<std::size_t>(v)]; }
  [[nodiscard]] Index origin(Index h) const {
    return mesh_.triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)];
  }
  /// Signed distance from the plane; the two ends lie in it exactly.
  [[nodiscard]] double side_mm(Index v) const {
    return v == from_ || v == to_ ? 0.0 : (at(v) - at(from_)).dot(plane_normal_);
  }
  [[nodiscard]] bool touches_boundary(const SurfacePoint& p) const {
    if (p.is_vertex()) return topology_.is_boundary_vertex(p.a);
    for (Index h : topology_.outgoing(p.a)) {
      if (origin(next_halfedge(h)) == p.b) return topology_.opposite(h) == no_index;
      if (origin(previous_halfedge(h)) == p.b && topology_.opposite(previous_halfedge(h)) == no_index) return true;
    }
    return false;
  }
  /// Where the plane crosses halfedge h, eq. 2; nothing when it does not.
  [[nodiscard]] std::optional<SurfacePoint> crossing(Index h) const {
    const Index p = origin(h), q = origin(next_halfedge(h));
    const double sp = side_mm(p), sq = side_mm(q);
    if (sp == 0.0) return SurfacePoint::vertex(p);
    if (sq == 0.0) return SurfacePoint::vertex(q);
    if ((sp > 0.0) == (sq > 0.0)) return std::nullopt;
    return SurfacePoint{p, q, sp / (sp - sq)};
  }

  /// Case 1: among the edges opposite to the vertex, the crossing that lies farthest ahead.
  [[nodiscard]] std::optional<Step> from_vertex(Index v, const Vec3& direction, bool first) const {
    std::optional<Step> best;
    double best_ahead = first ? -2.0 : 0.0;
    for (Index h : topology_.outgoing(v)) {
      if (origin(next_halfedge(h)) == to_ || origin(previous_halfedge(h)) == to_)
        return Step{SurfacePoint::vertex(to_), halfedge_triangle(h)};
      const auto point = crossing(next_halfedge(h));
      if (!point) continue;
      const double ahead = (position_mm(mesh_, *point) - at(v)).normalized().dot(direction);
      if (ahead > best_ahead) {
        best_ahead = ahead;
        best = Step{*point, halfedge_triangle(h)};
      }
    }
    return best;
  }

  /// Case 2: the next point lies on the other two edges of the triangle on the far side of this edge.
  [[nodiscard]] std::optional<Step> from_edge(const SurfacePoint& p, Index behind) const {
    for (Index h : topology_.outgoing(p.a)) {
      for (Index side : {h, previous_halfedge(h)}) {
        const Index ahead = halfedge_triangle(side);
        const Index other = side == h ? origin(next_halfedge(h)) : origin(previous_halfedge(h));
        if (other != p.b || ahead == behind) continue;
        const Index apex = origin(previous_halfedge(side));
        if (apex == to_ || side_mm(apex) == 0.0) return Step{SurfacePoint::vertex(apex), ahead};
        for (Index exit : {next_halfedge(side), previous_halfedge(side)})
          if (const auto point = crossing(exit)) return Step{*point, ahead};
      }
    }
    return std::nullopt;
  }

  const TriangleMesh& mesh_;
  const MeshTopology& topology_;
  Index from_, to_;
  Vec3 towards_, plane_normal_;
};

/// Moves points near an inner vertex onto it.
void snap_to_vertices(SurfacePath& path, const MeshTopology& topology) {
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    SurfacePoint& p = path[i];
    if (p.is_vertex()) continue;
    const Index nearest = p.t < snap_share ? p.a : p.t > 1.0 - snap_share ? p.b : no_index;
    if (nearest == no_index) continue;
    const bool is_end = nearest == path.front().a || nearest == path.back().a;
    if (is_end || !topology.is_boundary_vertex(nearest)) p = SurfacePoint::vertex(nearest);
  }
}

/// Cuts out what lies between two visits of a vertex, so that no vertex comes twice.
SurfacePath without_loops(const SurfacePath& path) {
  SurfacePath kept;
  for (const SurfacePoint& p : path) {
    const auto seen = std::find_if(kept.begin(), kept.end(),
                                   [&](const SurfacePoint& k) { return p.is_vertex() && k.is_vertex() && k.a == p.a; });
    kept.erase(seen, kept.end());
    kept.push_back(p);
  }
  return kept;
}

/// Drops a point on an edge that starts at the vertex before or behind it: its neighbours share a triangle anyway.
SurfacePath without_spokes(const SurfacePath& path) {
  SurfacePath kept{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const SurfacePoint& p = path[i];
    if (!p.is_vertex() && kept.back().is_vertex() && p.touches(kept.back().a)) continue;
    if (p.is_vertex() && kept.size() > 1 && !kept.back().is_vertex() && kept.back().touches(p.a)) kept.pop_back();
    kept.push_back(p);
  }
  return kept;
}

using Distances = std::vector<double>;

struct QueueItem {
  double distance_mm;
  Index vertex;
  bool operator>(const QueueItem& other) const {
    return distance_mm != other.distance_mm ? distance_mm > other.distance_mm : vertex > other.vertex;
  }
};

SurfacePath walk_back(Index end, const std::vector<Index>& previous) {
  SurfacePath path;
  for (Index v = end; v != no_index; v = previous[static_cast<std::size_t>(v)]) path.push_back(SurfacePoint::vertex(v));
  std::reverse(path.begin(), path.end());
  return path;
}

/// Calls visit(neighbour) for every vertex that shares an edge with v.
template <class Visit>
void for_neighbours(const TriangleMesh& mesh, const MeshTopology& topology, Index v, Visit visit) {
  const auto corner = [&](Index h) {
    return mesh.triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)];
  };
  for (Index h : topology.outgoing(v)) {
    visit(corner(next_halfedge(h)));
    if (topology.opposite(previous_halfedge(h)) == no_index) visit(corner(previous_halfedge(h)));
  }
}

}  // namespace

Result<SurfacePath> slice_path(const TriangleMesh& mesh, const MeshTopology& topology,
                               std::span<const Vec3> vertex_normals, Index from, Index to) {
  VOLUTE_CHECK(from != to, from);
  auto path = Slicer(mesh, topology, vertex_normals, from, to).trace();
  if (!path)
    return bad_input("surface-slice-stuck",
                     "the plane through vertices " + std::to_string(from) + " and " + std::to_string(to) +
                         " leaves the surface between them; take two vertices that see each other");
  snap_to_vertices(*path, topology);
  return without_spokes(without_loops(*path));
}

Result<SurfacePath> shortest_edge_path(const TriangleMesh& mesh, const MeshTopology& topology,
                                       std::span<const Index> sources, std::span<const Index> targets,
                                       const EdgeCost& cost) {
  const std::size_t count = mesh.vertices_mm.size();
  Distances distance(count, std::numeric_limits<double>::infinity());
  std::vector<Index> previous(count, no_index);
  std::vector<char> is_target(count, 0);
  for (Index v : targets) is_target[static_cast<std::size_t>(v)] = 1;
  std::priority_queue<QueueItem, std::vector<QueueItem>, std::greater<>> queue;
  for (Index v : sources) {
    distance[static_cast<std::size_t>(v)] = 0.0;
    queue.push({0.0, v});
  }
  while (!queue.empty()) {
    const auto [reached_mm, v] = queue.top();
    queue.pop();
    if (reached_mm > distance[static_cast<std::size_t>(v)]) continue;
    if (is_target[static_cast<std::size_t>(v)]) return walk_back(v, previous);
    if (reached_mm > 0.0 && topology.is_boundary_vertex(v)) continue;  // a path may end on a boundary, not touch it
    for_neighbours(mesh, topology, v, [&](Index w) {
      const double along_mm =
          cost ? cost(v, w)
               : (mesh.vertices_mm[static_cast<std::size_t>(w)] - mesh.vertices_mm[static_cast<std::size_t>(v)]).norm();
      const double through_mm = reached_mm + along_mm;
      if (through_mm >= distance[static_cast<std::size_t>(w)]) return;
      distance[static_cast<std::size_t>(w)] = through_mm;
      previous[static_cast<std::size_t>(w)] = v;
      queue.push({through_mm, w});
    });
  }
  return bad_input("surface-no-path", "no chain of edges joins vertex " +
                                          std::to_string(sources.empty() ? no_index : sources.front()) + " to vertex " +
                                          std::to_string(targets.empty() ? no_index : targets.front()) +
                                          " without touching a boundary; refine the mesh between the holes");
}

Result<BridgePath> bridge_path(const TriangleMesh& mesh, const MeshTopology& topology,
                               std::span<const Vec3> vertex_normals, Index from, Index to) {
  if (auto sliced = slice_path(mesh, topology, vertex_normals, from, to)) return BridgePath{std::move(*sliced), true};
  auto along_edges = shortest_edge_path(mesh, topology, std::span(&from, 1), std::span(&to, 1));
  if (!along_edges) return tl::unexpected(along_edges.error());
  return BridgePath{std::move(*along_edges), false};
}

}  // namespace volute::planner
