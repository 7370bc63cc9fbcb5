#include "sim/machining/surface_facets.hpp"

#include <algorithm>
#include <cmath>

namespace volute::sim {
namespace {

double to_segment_sq(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double share = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (p - a - share * ab).squaredNorm();
}

}  // namespace

SurfaceFacets::SurfaceFacets(const geometry::TriangleMesh& surface) : surface_(&surface) {
  std::vector<Box> boxes;
  boxes.reserve(surface.triangles.size());
  normals_.reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Box box;
    for (std::size_t k = 0; k < 3; ++k) box.extend(corner(t, k));
    boxes.push_back(box);
    normals_.push_back((corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).normalized());
  }
  tree_ = BoxTree(boxes);
}

double SurfaceFacets::distance_mm(const Vec3& point_mm, double within_mm) const {
  return std::sqrt(tree_.nearest_sq(point_mm, within_mm * within_mm, [&](std::int32_t item) {
    const auto t = static_cast<std::size_t>(item);
    bool above = true;
    double edges_sq = within_mm * within_mm;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = corner(t, k), &b = corner(t, (k + 1) % 3);
      if ((b - a).cross(point_mm - a).dot(normals_[t]) >= 0.0) continue;
      above = false;
      edges_sq = std::min(edges_sq, to_segment_sq(point_mm, a, b));
    }
    const double height = normals_[t].dot(point_mm - corner(t, 0));
    return above ? height * height : edges_sq;
  }));
}

double SurfaceFacets::buried_mm(const Vec3& foot_mm, const Vec3& normal, double depth_mm) const {
  constexpr int parts = 16;
  double deepest = distance_mm(foot_mm - depth_mm * normal, depth_mm);
  for (int k = parts - 1; k > 0; --k) {
    const double way = depth_mm * k / parts;
    if (way <= deepest) break;  // no point is farther from the surface than from its foot
    deepest = std::max(deepest, distance_mm(foot_mm - way * normal, way));
  }
  return deepest;
}

}  // namespace volute::sim
