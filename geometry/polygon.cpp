#include "geometry/polygon.hpp"

#include "geometry/index.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace volute::geometry {

namespace {

/// Newell's normal: right for concave and slightly bent polygons too.
Vec3 polygon_normal(const TriangleMesh& mesh, std::span<const Index> corners) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += mesh.vertices_mm[at(corners[i])].cross(mesh.vertices_mm[at(corners[(i + 1) % corners.size()])]);
  return normal.norm() > 0.0 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitZ());
}

double least_angle_rad(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto angle = [](const Vec3& u, const Vec3& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); };
  return std::min({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
}

bool is_inside(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  const auto left_of = [&](const Vec3& from, const Vec3& to) { return (to - from).cross(p - from).dot(normal) >= 0.0; };
  return left_of(a, b) && left_of(b, c) && left_of(c, a);
}

/// Least angle of the ear at corner i of the ring, or a negative number when it is none.
double ear_quality(const TriangleMesh& mesh, const std::vector<Index>& ring, std::size_t i, const Vec3& normal) {
  const Index ia = ring[(i + ring.size() - 1) % ring.size()], ib = ring[i], ic = ring[(i + 1) % ring.size()];
  const Vec3 &a = mesh.vertices_mm[at(ia)], &b = mesh.vertices_mm[at(ib)], &c = mesh.vertices_mm[at(ic)];
  if ((b - a).cross(c - a).dot(normal) <= 0.0) return -1.0;
  for (const Index other : ring)
    if (other != ia && other != ib && other != ic && is_inside(mesh.vertices_mm[at(other)], a, b, c, normal))
      return -1.0;
  return least_angle_rad(a, b, c);
}

}  // namespace

void append_polygon(TriangleMesh& mesh, std::span<const Index> corners) {
  std::vector<Index> ring(corners.begin(), corners.end());
  const Vec3 normal = corners.size() > 3 ? polygon_normal(mesh, corners) : Vec3(Vec3::UnitZ());
  while (ring.size() > 3) {
    std::size_t best = 1;
    double best_quality = -1.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      double quality = ear_quality(mesh, ring, i, normal);
      if (ring.size() == 4) quality = std::min(quality, ear_quality(mesh, ring, (i + 2) % 4, normal));
      if (quality > best_quality) {
        best = i;
        best_quality = quality;
      }
    }
    mesh.triangles.push_back(
        {ring[(best + ring.size() - 1) % ring.size()], ring[best], ring[(best + 1) % ring.size()]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
  }
  mesh.triangles.push_back({ring[0], ring[1], ring[2]});
}

Result<void> check_polygon(std::span<const Index> corners, std::size_t vertices, const std::string& place) {
  if (corners.size() < 3 || corners.size() > most_polygon_corners)
    return bad_input("mesh-syntax", place + "a face with " + std::to_string(corners.size()) + " corners; 3 to " +
                                        std::to_string(most_polygon_corners) + " are allowed, export the file again");
  for (const Index v : corners)
    if (v < 0 || at(v) >= vertices)
      return bad_input("mesh-index-out-of-range", place + "vertex " + std::to_string(v) +
                                                      " (counted from 0) does not exist (the file has " +
                                                      std::to_string(vertices) + "); export the file again");
  return {};
}

}  // namespace volute::geometry
