// The triangle mesh and what belongs together in it: neighbours, boundary loops, components, handles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/result.hpp"
#include "geometry/vector.hpp"

namespace volute::geometry {

using Index = std::int32_t;
constexpr Index no_index = -1;
using Triangle = std::array<Index, 3>;

/// Corners counter-clockwise seen from outside. Plain data: no rule is enforced here; MeshTopology::build checks them.
struct TriangleMesh {
  std::vector<Vec3> vertices_mm;
  std::vector<Triangle> triangles;
};

/// A halfedge is corner k of triangle t, numbered 3 t + k; it runs from corner k to corner (k + 1) % 3.
constexpr Index halfedge_triangle(Index halfedge) { return halfedge / 3; }
constexpr Index next_halfedge(Index halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
constexpr Index previous_halfedge(Index halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }

/// A closed chain of boundary vertices. The surface lies on the left of vertex i -> vertex i + 1 (last joins first):
/// seen from outside, the outer loop of a sheet runs counter-clockwise and a hole clockwise ([Sun2016] section 2).
struct BoundaryLoop {
  std::vector<Index> vertices;
  double length_mm = 0.0;
  Index component = 0;
};

/// One edge-connected part of the mesh.
struct Component {
  Index triangles = 0;
  Index boundary_loops = 0;
  Index handles = 0;  ///< genus: (2 - boundary_loops - Euler characteristic) / 2
};

/// Neighbourhood of an oriented 2-manifold with or without boundary.
/// Properties, each with a test of that name:
/// 1. opposite(opposite(h)) == h on inner edges. 2. Every vertex of a boundary loop has exactly one loop through it.
/// 3. The Euler characteristic summed from components equals V - E + F (V: vertices that a triangle uses).
/// Components are numbered by falling area. A vertex that no triangle uses is allowed; `outgoing` of it is empty.
class MeshTopology {
 public:
  /// Errors (bad_input): mesh-empty, mesh-index-out-of-range, mesh-degenerate-triangle, mesh-not-manifold (edge with
  /// more than two triangles, or vertex whose triangles do not form one fan), mesh-inconsistent-orientation. Each names
  /// a triangle.
  static Result<MeshTopology> build(const TriangleMesh& mesh);

  [[nodiscard]] Index vertex_count() const { return vertex_count_; }
  [[nodiscard]] Index triangle_count() const { return static_cast<Index>(opposite_.size() / 3); }
  [[nodiscard]] Index edge_count() const { return edge_count_; }

  /// The halfedge on the other side, or no_index on the boundary.
  [[nodiscard]] Index opposite(Index halfedge) const { return opposite_[static_cast<std::size_t>(halfedge)]; }
  /// Undirected edge of a halfedge, 0 <= edge < edge_count().
  [[nodiscard]] Index edge(Index halfedge) const { return edge_[static_cast<std::size_t>(halfedge)]; }
  /// One halfedge of the edge (the only one when the edge is on the boundary).
  [[nodiscard]] Index edge_halfedge(Index edge) const { return edge_halfedge_[static_cast<std::size_t>(edge)]; }
  /// Halfedges that leave the vertex, in counter-clockwise order; at a boundary vertex the first one lies on the
  /// boundary.
  [[nodiscard]] std::span<const Index> outgoing(Index vertex) const;
  [[nodiscard]] bool is_boundary_vertex(Index vertex) const {
    return boundary_vertex_[static_cast<std::size_t>(vertex)] != 0;
  }

  /// Loops by falling length: [0] is the longest of the mesh.
  [[nodiscard]] const std::vector<BoundaryLoop>& boundary_loops() const { return loops_; }
  [[nodiscard]] const std::vector<Component>& components() const { return components_; }
  [[nodiscard]] Index component_of_triangle(Index triangle) const {
    return component_[static_cast<std::size_t>(triangle)];
  }

 private:
  Result<void> order_fans(const TriangleMesh& mesh);
  void trace_loops(const TriangleMesh& mesh);
  void count_handles();

  Index vertex_count_ = 0;
  Index edge_count_ = 0;
  std::vector<Index> opposite_, edge_, edge_halfedge_, outgoing_start_, outgoing_, component_;
  std::vector<char> boundary_vertex_;
  std::vector<BoundaryLoop> loops_;
  std::vector<Component> components_;
};

}  // namespace volute::geometry
