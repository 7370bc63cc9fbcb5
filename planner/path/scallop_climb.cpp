#include "planner/path/scallop_climb.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/index.hpp"

namespace volute::planner {

using geometry::at;

Facet::Facet(const TriangleMesh& mesh, std::size_t triangle) {
  for (std::size_t k = 0; k < 3; ++k) corner_mm_[k] = mesh.vertices_mm[at(mesh.triangles[triangle][k])];
  const Vec3 twice_area = (corner_mm_[1] - corner_mm_[0]).cross(corner_mm_[2] - corner_mm_[0]);
  normal_ = twice_area.normalized();
  size_mm_ = std::sqrt(twice_area.norm());
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = corner_mm_[(k + 2) % 3] - corner_mm_[(k + 1) % 3];
    hat_per_mm_[k] = size_mm_ > 0.0 ? Vec3(normal_.cross(side) / twice_area.norm()) : Vec3(Vec3::Zero());
  }
}

Vec3 Facet::walked(const Vec3& from, const Vec3& direction, double step_mm) const {
  constexpr double on_edge = 1e-9;
  Vec3 way = step_mm * shares(in_plane(direction).normalized());
  for (std::size_t k = 0; k < 3; ++k) {
    const auto corner = static_cast<Eigen::Index>(k);
    if (from[corner] > on_edge || way[corner] >= 0.0) continue;
    const Vec3 side = corner_mm_[(k + 2) % 3] - corner_mm_[(k + 1) % 3];
    way = step_mm * shares(side.normalized() * (side.dot(direction) < 0.0 ? -1.0 : 1.0));
    way[corner] = 0.0;
  }
  double part = 1.0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (way[k] < 0.0) part = std::min(part, from[k] / -way[k]);
  }
  const Vec3 to = (from + std::max(part, 0.0) * way).cwiseMax(0.0);
  return to / to.sum();
}

Vec3 Facet::shares(const Vec3& way_mm) const {
  return {hat_per_mm_[0].dot(way_mm), hat_per_mm_[1].dot(way_mm), hat_per_mm_[2].dot(way_mm)};
}

Vec3 height_slope(const ScallopBalls& balls, const Facet& facet, const ScallopEntry& entry, Index ball) {
  constexpr double steepest = 10.0;
  const Vec3 off = balls.centre_mm(ball) - entry.entered_mm();
  return facet.in_plane(-off) / std::max(off.dot(entry.normal), balls.radius_mm() / steepest);
}

Vec3 along_crest(const Vec3& a, const Vec3& b) {
  const Vec3 between = b - a;
  const double length_sq = between.squaredNorm();
  return length_sq > 0.0 ? Vec3(a + std::clamp(-a.dot(between) / length_sq, 0.0, 1.0) * between) : a;
}

double crest_share(const ScallopBalls& balls, const ScallopEntry& from, const ScallopEntry& to) {
  const double sum = balls.height_mm(to.ball, from) - from.height_mm + balls.height_mm(from.ball, to) - to.height_mm;
  if (!(sum > 0.0) || !std::isfinite(sum)) return 0.5;
  // Low heights may be settled by a ball that is not the lowest: the crest then seems to lie beyond the two.
  return std::clamp((balls.height_mm(to.ball, from) - from.height_mm) / sum, 0.0, 1.0);
}

}  // namespace volute::planner
