// Where a point or a vertical line meets the surface.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"

namespace volute::planner {

using geometry::Index;
using geometry::TriangleMesh;
using geometry::Vec3;

struct SurfaceHit {
  Vec3 point_mm = Vec3::Zero(), normal = Vec3::UnitZ();
  Index triangle = geometry::no_index;
};

/// Triangles in square cells of their projection along z. Keeps references to the mesh and the normals.
class SurfaceLocator {
 public:
  SurfaceLocator(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals);

  /// The highest point of the surface above or below (x, y) that faces upwards; nothing outside the projection and in
  /// holes.
  [[nodiscard]] std::optional<SurfaceHit> drop(double x_mm, double y_mm) const;
  /// The nearest point of the triangles within `reach_mm`; nothing when there is none.
  [[nodiscard]] std::optional<SurfaceHit> nearest(const Vec3& point_mm, double reach_mm) const;

 private:
  [[nodiscard]] SurfaceHit hit(Index triangle, const Vec3& shares) const;
  template <class Visit>
  void near(double x_mm, double y_mm, double reach_mm, Visit visit) const;

  const TriangleMesh& mesh_;
  std::span<const Vec3> normals_;
  double cell_mm_ = 1.0, least_x_mm_ = 0.0, least_y_mm_ = 0.0;
  long columns_ = 1, rows_ = 1;
  std::vector<std::vector<Index>> cells_;
};

}  // namespace volute::planner
