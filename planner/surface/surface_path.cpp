#include "planner/surface/surface_path.hpp"

namespace volute::planner {

Vec3 position_mm(const TriangleMesh& mesh, const SurfacePoint& point) {
  const Vec3& a = mesh.vertices_mm[static_cast<std::size_t>(point.a)];
  return point.is_vertex() ? a : Vec3(a + point.t * (mesh.vertices_mm[static_cast<std::size_t>(point.b)] - a));
}

double length_mm(const TriangleMesh& mesh, const SurfacePath& path) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    length += (position_mm(mesh, path[i + 1]) - position_mm(mesh, path[i])).norm();
  return length;
}

}  // namespace volute::planner
