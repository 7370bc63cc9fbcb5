#include "view/solids.hpp"

#include <cmath>
#include <numbers>

#include "geometry/check.hpp"

namespace volute::view {

namespace {

/// A band between two points of the profile.
void add_band(geometry::TriangleMesh& mesh, const kinematics::ProfilePoint& low, const kinematics::ProfilePoint& high,
              int sectors) {
  const auto first = static_cast<geometry::Index>(mesh.vertices_mm.size());
  for (int k = 0; k < sectors; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / sectors;
    for (const auto& point : {low, high})
      mesh.vertices_mm.emplace_back(point.radius_mm * std::cos(angle), point.radius_mm * std::sin(angle), point.z_mm);
  }
  for (int k = 0; k < sectors; ++k) {
    const geometry::Index a = first + 2 * k, b = first + 2 * ((k + 1) % sectors);
    if (low.radius_mm > 0.0) mesh.triangles.push_back({a, b, a + 1});
    if (high.radius_mm > 0.0) mesh.triangles.push_back({b, b + 1, a + 1});
  }
}

}  // namespace

geometry::TriangleMesh revolution_mesh(std::span<const kinematics::ProfilePoint> profile, int sectors) {
  VOLUTE_CHECK(sectors >= 3, sectors);
  geometry::TriangleMesh mesh;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) add_band(mesh, profile[i], profile[i + 1], sectors);
  return mesh;
}

geometry::TriangleMesh moved_mesh(const geometry::TriangleMesh& mesh, const geometry::Transform& motion) {
  geometry::TriangleMesh out = mesh;
  for (geometry::Vec3& vertex : out.vertices_mm) vertex = motion * vertex;
  return out;
}

}  // namespace volute::view
