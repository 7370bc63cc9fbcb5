#include "planner/path/surface_locator.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/index.hpp"

namespace volute::planner {

using geometry::at;

namespace {

/// Barycentric shares of the point of triangle a b c nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 nearest_shares(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0.0};
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {1.0 - d2 / (d2 - d6), 0.0, d2 / (d2 - d6)};
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

}  // namespace

SurfaceLocator::SurfaceLocator(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals)
    : mesh_(mesh), normals_(vertex_normals) {
  Vec3 low = mesh.vertices_mm.front(), high = low;
  for (const Vec3& v : mesh.vertices_mm) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  least_x_mm_ = low.x();
  least_y_mm_ = low.y();
  const double width = high.x() - low.x(), depth = high.y() - low.y();
  cell_mm_ = std::max(std::sqrt(2.0 * width * depth / static_cast<double>(mesh.triangles.size())),
                      1e-9 * (width + depth) + 1e-12);
  columns_ = static_cast<long>(width / cell_mm_) + 1;
  rows_ = static_cast<long>(depth / cell_mm_) + 1;
  cells_.resize(at(columns_ * rows_));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec3 least = mesh.vertices_mm[at(mesh.triangles[t][0])], greatest = least;
    for (Index v : mesh.triangles[t]) {
      least = least.cwiseMin(mesh.vertices_mm[at(v)]);
      greatest = greatest.cwiseMax(mesh.vertices_mm[at(v)]);
    }
    const long i1 = static_cast<long>((greatest.x() - least_x_mm_) / cell_mm_),
               j1 = static_cast<long>((greatest.y() - least_y_mm_) / cell_mm_);
    for (long i = static_cast<long>((least.x() - least_x_mm_) / cell_mm_); i <= i1; ++i)
      for (long j = static_cast<long>((least.y() - least_y_mm_) / cell_mm_); j <= j1; ++j)
        cells_[at(i * rows_ + j)].push_back(static_cast<Index>(t));
  }
}

SurfaceHit SurfaceLocator::hit(Index triangle, const Vec3& shares) const {
  SurfaceHit result;
  result.triangle = triangle;
  result.normal = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    const auto v = at(mesh_.triangles[at(triangle)][static_cast<std::size_t>(k)]);
    result.point_mm += shares[k] * mesh_.vertices_mm[v];
    result.normal += shares[k] * normals_[v];
  }
  result.normal.normalize();
  return result;
}

template <class Visit>
void SurfaceLocator::near(double x_mm, double y_mm, double reach_mm, Visit visit) const {
  const auto cell = [&](double offset, long count) {
    return std::clamp(static_cast<long>(std::floor(offset / cell_mm_)), 0L, count - 1);
  };
  const long i0 = cell(x_mm - reach_mm - least_x_mm_, columns_), i1 = cell(x_mm + reach_mm - least_x_mm_, columns_);
  const long j0 = cell(y_mm - reach_mm - least_y_mm_, rows_), j1 = cell(y_mm + reach_mm - least_y_mm_, rows_);
  for (long i = i0; i <= i1; ++i)
    for (long j = j0; j <= j1; ++j)
      for (Index t : cells_[at(i * rows_ + j)]) visit(t);
}

std::optional<SurfaceHit> SurfaceLocator::drop(double x_mm, double y_mm) const {
  std::optional<SurfaceHit> highest;
  near(x_mm, y_mm, 0.0, [&](Index t) {
    const auto& corners = mesh_.triangles[at(t)];
    const Vec3 &a = mesh_.vertices_mm[at(corners[0])], &b = mesh_.vertices_mm[at(corners[1])],
               &c = mesh_.vertices_mm[at(corners[2])];
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
    if (area <= 0.0) return;  // faces sideways or down
    const double sb = ((x_mm - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (y_mm - a.y())) / area;
    const double sc = ((b.x() - a.x()) * (y_mm - a.y()) - (x_mm - a.x()) * (b.y() - a.y())) / area;
    constexpr double edge = -1e-9;
    if (sb < edge || sc < edge || 1.0 - sb - sc < edge) return;
    const SurfaceHit found = hit(t, {1.0 - sb - sc, sb, sc});
    if (!highest || found.point_mm.z() > highest->point_mm.z()) highest = found;
  });
  return highest;
}

std::optional<SurfaceHit> SurfaceLocator::nearest(const Vec3& point_mm, double reach_mm) const {
  std::optional<SurfaceHit> best;
  double best_sq = reach_mm * reach_mm;
  near(point_mm.x(), point_mm.y(), reach_mm, [&](Index t) {
    const auto& corners = mesh_.triangles[at(t)];
    const Vec3 &a = mesh_.vertices_mm[at(corners[0])], &b = mesh_.vertices_mm[at(corners[1])],
               &c = mesh_.vertices_mm[at(corners[2])];
    const Vec3 shares = nearest_shares(point_mm, a, b, c);
    const double distance_sq = (shares[0] * a + shares[1] * b + shares[2] * c - point_mm).squaredNorm();
    if (distance_sq >= best_sq) return;
    best_sq = distance_sq;
    best = hit(t, shares);
  });
  return best;
}

}  // namespace volute::planner
