#include "kinematics/model/link_shapes.hpp"

#include <cmath>
#include <numbers>

#include "geometry/check.hpp"

namespace volute::kinematics {

using geometry::Index;
using geometry::TriangleMesh;
using geometry::Vec3;

TriangleMesh box_mesh(const Vec3& min_mm, const Vec3& max_mm) {
  VOLUTE_CHECK((min_mm.array() < max_mm.array()).all(), min_mm.transpose(), max_mm.transpose());
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)  // bit 0: x, bit 1: y, bit 2: z
    mesh.vertices_mm.emplace_back(corner & 1 ? max_mm.x() : min_mm.x(), corner & 2 ? max_mm.y() : min_mm.y(),
                                  corner & 4 ? max_mm.z() : min_mm.z());
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh cone_mesh(const Vec3& from_mm, const Vec3& to_mm, double from_radius_mm, double to_radius_mm) {
  VOLUTE_CHECK(from_mm != to_mm && from_radius_mm > 0.0 && to_radius_mm > 0.0, from_radius_mm, to_radius_mm);
  constexpr Index sides = 32;
  const double circumscribed = 1.0 / std::cos(std::numbers::pi / sides);
  const Vec3 along = (to_mm - from_mm).normalized();
  const Vec3 u = along.unitOrthogonal();
  const Vec3 v = along.cross(u);
  TriangleMesh mesh;
  for (Index k = 0; k < sides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / sides;
    const Vec3 outward = circumscribed * (std::cos(angle) * u + std::sin(angle) * v);
    mesh.vertices_mm.push_back(from_mm + from_radius_mm * outward);
    mesh.vertices_mm.push_back(to_mm + to_radius_mm * outward);
  }
  const Index bottom = 2 * sides;
  mesh.vertices_mm.push_back(from_mm);
  mesh.vertices_mm.push_back(to_mm);
  for (Index k = 0; k < sides; ++k) {
    const Index a = 2 * k, b = 2 * ((k + 1) % sides);
    mesh.triangles.insert(mesh.triangles.end(),
                          {{a, b, b + 1}, {a, b + 1, a + 1}, {bottom, b, a}, {bottom + 1, a + 1, b + 1}});
  }
  return mesh;
}

}  // namespace volute::kinematics
