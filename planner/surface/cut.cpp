#include "planner/surface/cut.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "geometry/check.hpp"

namespace volute::planner {

using geometry::MeshTopology;
using geometry::next_halfedge;
using geometry::no_index;
using geometry::previous_halfedge;
using geometry::Triangle;

namespace {

using EdgeKey = std::pair<Index, Index>;
EdgeKey edge_key(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// Twice the area over the longest edge squared: 0 for a sliver, 0.87 for an equilateral triangle.
double shape(const TriangleMesh& mesh, Index a, Index b, Index c) {
  const auto at = [&](Index v) -> const Vec3& { return mesh.vertices_mm[static_cast<std::size_t>(v)]; };
  const double longest_sq =
      std::max({(at(b) - at(a)).squaredNorm(), (at(c) - at(b)).squaredNorm(), (at(a) - at(c)).squaredNorm()});
  return longest_sq > 0.0 ? (at(b) - at(a)).cross(at(c) - at(a)).norm() / longest_sq : 0.0;
}

/// Triangulates a polygon of at most six corners that holds all `wanted` segments, the worst triangle as good as can
/// be.
class PolygonSplit {
 public:
  PolygonSplit(const TriangleMesh& mesh, std::vector<Index> corners, const std::set<EdgeKey>& wanted)
      : mesh_(mesh), corners_(std::move(corners)), wanted_(wanted) {}

  std::vector<Triangle> triangles() {
    std::vector<Triangle> result;
    best(0, corners_.size() - 1, &result);
    return result;
  }

 private:
  /// Does the chord i j cross a wanted chord p q, i < p < j < q or p < i < q < j?
  [[nodiscard]] bool crosses_wanted(std::size_t i, std::size_t j) const {
    for (std::size_t p = 0; p < corners_.size(); ++p)
      for (std::size_t q = p + 2; q < corners_.size(); ++q) {
        if (!wanted_.contains(edge_key(corners_[p], corners_[q]))) continue;
        if ((i < p && p < j && j < q) || (p < i && i < q && q < j)) return true;
      }
    return false;
  }

  /// Worst shape of the best triangulation of corners i..j; appends its triangles when asked.
  double best(std::size_t i, std::size_t j, std::vector<Triangle>* out) const {
    if (j < i + 2) return 1.0;
    double best_worst = -1.0;
    std::size_t apex = i + 1;
    for (std::size_t k = i + 1; k < j; ++k) {
      if (crosses_wanted(i, k) || crosses_wanted(k, j)) continue;
      const double worst =
          std::min({shape(mesh_, corners_[i], corners_[k], corners_[j]), best(i, k, nullptr), best(k, j, nullptr)});
      if (worst > best_worst) {
        best_worst = worst;
        apex = k;
      }
    }
    if (out != nullptr) {
      out->push_back({corners_[i], corners_[apex], corners_[j]});
      best(i, apex, out);
      best(apex, j, out);
    }
    return best_worst;
  }

  const TriangleMesh& mesh_;
  std::vector<Index> corners_;
  const std::set<EdgeKey>& wanted_;
};

/// Gives each point of the path a vertex; `on_edge` tells which edges got one.
std::vector<Index> add_vertices(TriangleMesh& mesh, const SurfacePath& path, std::map<EdgeKey, Index>& on_edge) {
  std::vector<Index> vertices;
  for (const SurfacePoint& p : path) {
    if (p.is_vertex()) {
      vertices.push_back(p.a);
      continue;
    }
    vertices.push_back(static_cast<Index>(mesh.vertices_mm.size()));
    const bool new_on_edge = on_edge.emplace(edge_key(p.a, p.b), vertices.back()).second;
    VOLUTE_CHECK(new_on_edge, p.a, p.b);
    mesh.vertices_mm.push_back(position_mm(mesh, p));
  }
  return vertices;
}

/// The corners of a triangle with the points inside its edges between them.
std::vector<Index> corners_with_points(const Triangle& t, const std::map<EdgeKey, Index>& on_edge) {
  std::vector<Index> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners.push_back(t[k]);
    const auto found = on_edge.find(edge_key(t[k], t[(k + 1) % 3]));
    if (found != on_edge.end()) corners.push_back(found->second);
  }
  return corners;
}

}  // namespace

MeshWithPath insert_path(const TriangleMesh& mesh, const SurfacePath& path) {
  MeshWithPath result;
  result.mesh.vertices_mm = mesh.vertices_mm;
  std::map<EdgeKey, Index> on_edge;
  result.vertices = add_vertices(result.mesh, path, on_edge);
  std::set<EdgeKey> segments;
  for (std::size_t i = 0; i + 1 < result.vertices.size(); ++i)
    segments.insert(edge_key(result.vertices[i], result.vertices[i + 1]));
  std::vector<char> is_split_end(mesh.vertices_mm.size(), 0);
  for (const auto& [edge, middle] : on_edge) is_split_end[static_cast<std::size_t>(edge.first)] = 1;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& old = mesh.triangles[t];
    const bool maybe =
        std::any_of(old.begin(), old.end(), [&](Index v) { return is_split_end[static_cast<std::size_t>(v)] != 0; });
    auto corners = maybe ? corners_with_points(old, on_edge) : std::vector<Index>{};
    if (corners.size() <= 3) {
      result.mesh.triangles.push_back(old);
      result.parent.push_back(static_cast<Index>(t));
      continue;
    }
    for (const Triangle& piece : PolygonSplit(result.mesh, std::move(corners), segments).triangles()) {
      result.mesh.triangles.push_back(piece);
      result.parent.push_back(static_cast<Index>(t));
    }
  }
  return result;
}

CutMesh cut_open(const TriangleMesh& mesh, const MeshTopology& topology, std::span<const std::vector<Index>> chains) {
  std::set<EdgeKey> cut;
  std::set<Index> touched;
  for (const std::vector<Index>& chain : chains) {
    touched.insert(chain.begin(), chain.end());
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) cut.insert(edge_key(chain[i], chain[i + 1]));
  }
  CutMesh result{mesh, {}};
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) result.original.push_back(static_cast<Index>(v));
  const auto corner = [&](Index h) {
    return mesh.triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)];
  };
  const auto is_cut = [&](Index h) {
    return topology.opposite(h) == no_index || cut.contains(edge_key(corner(h), corner(next_halfedge(h))));
  };
  for (Index v : touched) {
    // Around v, counter-clockwise: every cut that is crossed starts a new copy; the sector in which we start is closed
    // last.
    const auto around = topology.outgoing(v);
    std::size_t start = 0;
    while (start < around.size() && !is_cut(around[start])) ++start;
    if (start == around.size()) continue;
    Index copy = v;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Index h = around[(start + i) % around.size()];
      if (i > 0 && is_cut(h)) {
        copy = static_cast<Index>(result.mesh.vertices_mm.size());
        result.mesh.vertices_mm.push_back(mesh.vertices_mm[static_cast<std::size_t>(v)]);
        result.original.push_back(v);
      }
      result.mesh.triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)] = copy;
    }
  }
  return result;
}

}  // namespace volute::planner
