// A polyline on a mesh whose points lie on vertices or edges, so that it can become edges of the mesh.
#pragma once

#include <vector>

#include "geometry/mesh.hpp"

namespace volute::planner {

using geometry::Index;
using geometry::TriangleMesh;
using geometry::Vec3;

/// Vertex a (b = no_index), or the point a + t (b - a) inside the edge of a and b, 0 < t < 1.
struct SurfacePoint {
  Index a = geometry::no_index, b = geometry::no_index;
  double t = 0.0;

  static SurfacePoint vertex(Index v) { return {v, geometry::no_index, 0.0}; }
  [[nodiscard]] bool is_vertex() const { return b == geometry::no_index; }
  [[nodiscard]] bool touches(Index v) const { return a == v || b == v; }
};

/// Consecutive points share a triangle. No point comes twice.
using SurfacePath = std::vector<SurfacePoint>;

Vec3 position_mm(const TriangleMesh& mesh, const SurfacePoint& point);
double length_mm(const TriangleMesh& mesh, const SurfacePath& path);

}  // namespace volute::planner
