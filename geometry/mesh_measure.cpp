#include "geometry/mesh_measure.hpp"

#include "geometry/index.hpp"

#include <cmath>

namespace volute::geometry {

namespace {

/// Twice the area along the normal.
Vec3 area_vector(const TriangleMesh& mesh, const Triangle& corners) {
  const Vec3& p = mesh.vertices_mm[at(corners[0])];
  return (mesh.vertices_mm[at(corners[1])] - p).cross(mesh.vertices_mm[at(corners[2])] - p);
}

/// The corner's angle; atan2 stays accurate for needles, where acos does not.
double corner_angle_rad(const Vec3& to_next, const Vec3& to_previous) {
  return std::atan2(to_next.cross(to_previous).norm(), to_next.dot(to_previous));
}

}  // namespace

double triangle_area_mm2(const TriangleMesh& mesh, Index triangle) {
  return 0.5 * area_vector(mesh, mesh.triangles[at(triangle)]).norm();
}

double area_mm2(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& corners : mesh.triangles) sum += 0.5 * area_vector(mesh, corners).norm();
  return sum;
}

std::vector<Vec3> triangle_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles.size());
  for (const Triangle& corners : mesh.triangles) normals.push_back(area_vector(mesh, corners).normalized());
  return normals;
}

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices_mm.size(), Vec3::Zero());
  std::vector<Vec3> fallback(mesh.vertices_mm.size(), Vec3::UnitZ());
  for (const Triangle& corners : mesh.triangles) {
    const Vec3 normal = area_vector(mesh, corners).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.vertices_mm[at(corners[k])];
      const Vec3 to_next = mesh.vertices_mm[at(corners[(k + 1) % 3])] - p;
      const Vec3 to_previous = mesh.vertices_mm[at(corners[(k + 2) % 3])] - p;
      normals[at(corners[k])] += corner_angle_rad(to_next, to_previous) * normal;
      fallback[at(corners[k])] = normal;
    }
  }
  for (std::size_t v = 0; v < normals.size(); ++v)
    normals[v] = normals[v].norm() > 1e-12 ? normals[v].normalized() : fallback[v];
  return normals;
}

}  // namespace volute::geometry
