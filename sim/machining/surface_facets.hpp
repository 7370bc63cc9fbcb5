// The design surface's triangles as a neighbourhood: which are near, and how far below them a point lies.
#pragma once

#include <vector>

#include "geometry/mesh.hpp"
#include "sim/machining/box_tree.hpp"

namespace volute::sim {

using geometry::Vec3;

/// Requires: triangles that are not degenerate. Refers to the mesh, which must outlive it.
class SurfaceFacets {
 public:
  explicit SurfaceFacets(const geometry::TriangleMesh& surface);

  [[nodiscard]] const Vec3& corner(std::size_t triangle, std::size_t k) const {
    return surface_->vertices_mm[static_cast<std::size_t>(surface_->triangles[triangle][k])];
  }
  /// Unit, outward.
  [[nodiscard]] const Vec3& normal(std::size_t triangle) const { return normals_[triangle]; }
  [[nodiscard]] const BoxTree& tree() const { return tree_; }

  /// Distance to the nearest triangle, or `within_mm` where none is nearer.
  [[nodiscard]] double distance_mm(const Vec3& point_mm, double within_mm) const;

  /// How deep the material lay that was taken from `foot_mm` on the surface `depth_mm` down against `normal`: the
  /// greatest distance from the whole surface on that way. Equal to depth_mm on a plane; at a convex edge a way along
  /// the one face lies just under the other however long it is. Accuracy: no more than the true value, and less by at
  /// most depth_mm / 16. Property: never more than depth_mm.
  [[nodiscard]] double buried_mm(const Vec3& foot_mm, const Vec3& normal, double depth_mm) const;

 private:
  const geometry::TriangleMesh* surface_;
  std::vector<Vec3> normals_;
  BoxTree tree_;
};

}  // namespace volute::sim
