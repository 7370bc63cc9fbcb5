#include "planner/surface/condition.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace volute::planner {

using geometry::halfedge_triangle;
using geometry::MeshTopology;
using geometry::next_halfedge;
using geometry::no_index;
using geometry::previous_halfedge;
using geometry::Triangle;

namespace {

/// Corner angle at `corner` between the directions to `p` and `q`, rad.
double angle_at(const Vec3& corner, const Vec3& p, const Vec3& q) {
  const Vec3 u = p - corner, w = q - corner;
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

/// The two triangles of an inner edge a b: (a, b, c) and (b, a, d).
struct Diamond {
  Index a, b, c, d;
};

/// A mesh whose inner edges can be flipped in place.
class FlipMesh {
 public:
  FlipMesh(TriangleMesh& mesh, const MeshTopology& topology, const ConditionOptions& options)
      : mesh_(mesh), options_(options) {
    const std::size_t halfedges = 3 * mesh.triangles.size();
    opposite_.resize(halfedges);
    for (std::size_t h = 0; h < halfedges; ++h) opposite_[h] = topology.opposite(static_cast<Index>(h));
  }

  /// Returns how many edges were flipped.
  Index flip_to_delaunay() {
    Index flips = 0;
    const auto limit = static_cast<Index>(20 * mesh_.triangles.size());
    std::vector<Index> stack;
    for (Index h = static_cast<Index>(opposite_.size()) - 1; h >= 0; --h)
      if (opposite(h) > h) stack.push_back(h);
    while (!stack.empty() && flips < limit) {
      const Index h = stack.back();
      stack.pop_back();
      if (opposite(h) == no_index || !breaks_delaunay(h) || !may_flip(h)) continue;
      flip(h, stack);
      ++flips;
    }
    return flips;
  }

  [[nodiscard]] Index count_not_delaunay() const {
    Index count = 0;
    for (Index h = 0; h < static_cast<Index>(opposite_.size()); ++h)
      if (opposite(h) > h && breaks_delaunay(h)) ++count;
    return count;
  }

 private:
  [[nodiscard]] Index opposite(Index h) const { return opposite_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] Index origin(Index h) const {
    return mesh_.triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)];
  }
  [[nodiscard]] const Vec3& at(Index v) const { return mesh_.vertices_mm[static_cast<std::size_t>(v)]; }
  [[nodiscard]] Diamond diamond(Index h) const {
    const Index g = opposite(h);
    return {origin(h), origin(g), origin(previous_halfedge(h)), origin(previous_halfedge(g))};
  }

  [[nodiscard]] bool breaks_delaunay(Index h) const {
    const Diamond q = diamond(h);
    return angle_at(at(q.c), at(q.a), at(q.b)) + angle_at(at(q.d), at(q.a), at(q.b)) > std::numbers::pi + 1e-7;
  }

  [[nodiscard]] bool may_flip(Index h) const {
    const Diamond q = diamond(h);
    if (q.c == q.d || joined(h, q)) return false;
    const Vec3 n0 = (at(q.b) - at(q.a)).cross(at(q.c) - at(q.a)), n1 = (at(q.a) - at(q.b)).cross(at(q.d) - at(q.b));
    // A needle has no direction of its own: its normal is noise, so it does not vote on the bend.
    const double longest = std::max((at(q.b) - at(q.a)).squaredNorm(), 1e-30);
    const bool flat0 = n0.norm() < 1e-3 * longest, flat1 = n1.norm() < 1e-3 * longest;
    const double bend = std::atan2(n0.cross(n1).norm(), n0.dot(n1));
    if (!flat0 && !flat1 && bend > options_.dihedral_max_rad) return false;
    const Vec3 mean = n0 + n1;
    const Vec3 m0 = (at(q.d) - at(q.a)).cross(at(q.c) - at(q.a)), m1 = (at(q.c) - at(q.b)).cross(at(q.d) - at(q.b));
    const double least = 1e-6 * mean.squaredNorm();
    if (m0.dot(mean) <= least || m1.dot(mean) <= least) return false;
    return diagonal_distance_mm(q) <= options_.deviation_max_mm;
  }

  /// How far apart the two diagonals pass: the height by which a flip moves the surface.
  [[nodiscard]] double diagonal_distance_mm(const Diamond& q) const {
    const Vec3 across = (at(q.b) - at(q.a)).cross(at(q.d) - at(q.c));
    const double length = across.norm();
    return length > 0.0 ? std::abs((at(q.c) - at(q.a)).dot(across)) / length : 0.0;
  }

  /// Are c and d joined by an edge already? Walks the triangles around c.
  [[nodiscard]] bool joined(Index h, const Diamond& q) const {
    const Index first = previous_halfedge(h);  // leaves c
    for (Index x = first;;) {
      if (origin(next_halfedge(x)) == q.d || origin(previous_halfedge(x)) == q.d) return true;
      x = opposite(previous_halfedge(x));
      if (x == first) return false;
      if (x == no_index) break;
    }
    for (Index x = opposite(first); x != no_index; x = opposite(x)) {
      x = next_halfedge(x);
      if (origin(next_halfedge(x)) == q.d || origin(previous_halfedge(x)) == q.d) return true;
    }
    return false;
  }

  void join(Index h, Index g) {
    opposite_[static_cast<std::size_t>(h)] = g;
    if (g != no_index) opposite_[static_cast<std::size_t>(g)] = h;
  }

  void flip(Index h, std::vector<Index>& stack) {
    const Diamond q = diamond(h);
    const Index g = opposite(h), t0 = halfedge_triangle(h), t1 = halfedge_triangle(g);
    const Index bc = opposite(next_halfedge(h)), ca = opposite(previous_halfedge(h));
    const Index ad = opposite(next_halfedge(g)), db = opposite(previous_halfedge(g));
    mesh_.triangles[static_cast<std::size_t>(t0)] = {q.a, q.d, q.c};
    mesh_.triangles[static_cast<std::size_t>(t1)] = {q.b, q.c, q.d};
    join(3 * t0, ad);
    join(3 * t0 + 1, 3 * t1 + 1);
    join(3 * t0 + 2, ca);
    join(3 * t1, bc);
    join(3 * t1 + 2, db);
    for (Index changed : {3 * t0, 3 * t0 + 2, 3 * t1, 3 * t1 + 2}) stack.push_back(changed);
  }

  TriangleMesh& mesh_;
  const ConditionOptions& options_;
  std::vector<Index> opposite_;
};

/// Which loop each vertex lies on, or no_index.
std::vector<Index> loop_of_vertex(const MeshTopology& topology) {
  std::vector<Index> loop(static_cast<std::size_t>(topology.vertex_count()), no_index);
  for (std::size_t l = 0; l < topology.boundary_loops().size(); ++l)
    for (Index v : topology.boundary_loops()[l].vertices) loop[static_cast<std::size_t>(v)] = static_cast<Index>(l);
  return loop;
}

/// Replaces the triangle of halfedge h (p -> q, apex o) by (p, m, o) and appends (m, q, o).
void split_triangle(TriangleMesh& mesh, Index h, Index middle) {
  Triangle& t = mesh.triangles[static_cast<std::size_t>(halfedge_triangle(h))];
  const auto k = static_cast<std::size_t>(h % 3);
  const Index p = t[k], q = t[(k + 1) % 3], o = t[(k + 2) % 3];
  t = {p, middle, o};
  mesh.triangles.push_back({middle, q, o});
}

/// One sweep: halves the chords of which no triangle was touched in this sweep.
Index split_chords_once(TriangleMesh& mesh, const MeshTopology& topology, std::vector<std::array<Index, 2>>& parents) {
  const std::vector<Index> loop = loop_of_vertex(topology);
  std::vector<char> touched(mesh.triangles.size(), 0);
  Index found = 0;
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const Index h = topology.edge_halfedge(e), g = topology.opposite(h);
    if (g == no_index) continue;
    char& touched_h = touched[static_cast<std::size_t>(halfedge_triangle(h))];
    char& touched_g = touched[static_cast<std::size_t>(halfedge_triangle(g))];
    // Such a triangle is no more the one that the topology and `loop` know; the next sweep sees what it became.
    if (touched_h || touched_g) continue;
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(halfedge_triangle(h))];
    const Index a = t[static_cast<std::size_t>(h % 3)], b = t[static_cast<std::size_t>((h + 1) % 3)];
    if (loop[static_cast<std::size_t>(a)] == no_index ||
        loop[static_cast<std::size_t>(a)] != loop[static_cast<std::size_t>(b)])
      continue;
    ++found;
    touched_h = touched_g = 1;
    const auto middle = static_cast<Index>(mesh.vertices_mm.size());
    mesh.vertices_mm.emplace_back(
        0.5 * (mesh.vertices_mm[static_cast<std::size_t>(a)] + mesh.vertices_mm[static_cast<std::size_t>(b)]));
    parents.push_back({a, b});
    split_triangle(mesh, h, middle);
    split_triangle(mesh, g, middle);
  }
  return found;
}

}  // namespace

Result<std::vector<std::array<Index, 2>>> split_chords(TriangleMesh& mesh) {
  std::vector<std::array<Index, 2>> parents;
  while (true) {
    const auto topology = MeshTopology::build(mesh);
    if (!topology) return tl::unexpected(topology.error());
    if (split_chords_once(mesh, *topology, parents) == 0) return parents;
  }
}

Result<Index> flip_to_delaunay(TriangleMesh& mesh, const ConditionOptions& options) {
  const auto topology = MeshTopology::build(mesh);
  if (!topology) return tl::unexpected(topology.error());
  return FlipMesh(mesh, *topology, options).flip_to_delaunay();
}

Result<ConditionedMesh> condition(const TriangleMesh& surface, const ConditionOptions& options) {
  ConditionedMesh result;
  result.mesh = surface;
  const auto topology = MeshTopology::build(surface);
  if (!topology) return tl::unexpected(topology.error());
  FlipMesh flips(result.mesh, *topology, options);
  result.edges_flipped = flips.flip_to_delaunay();
  result.edges_not_delaunay = flips.count_not_delaunay();
  const auto chords = split_chords(result.mesh);
  if (!chords) return tl::unexpected(chords.error());
  result.chords_split = static_cast<Index>(chords->size());
  return result;
}

}  // namespace volute::planner
