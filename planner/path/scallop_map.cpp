#include "planner/path/scallop_map.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/check.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/point_grid.hpp"

namespace volute::planner {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

std::vector<Vec3> ball_centres(const CcPath& path, double radius_mm, double spacing_mm) {
  std::vector<Vec3> centres;
  for (const CcPiece& piece : path.pieces) {
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
      const CcPoint& a = piece.points[i];
      centres.push_back(a.point_P_mm + radius_mm * a.normal_P);
      if (i + 1 == piece.points.size()) continue;
      const CcPoint& b = piece.points[i + 1];
      const int steps = static_cast<int>(std::ceil((b.point_P_mm - a.point_P_mm).norm() / spacing_mm));
      for (int s = 1; s < steps; ++s) {
        const double share = static_cast<double>(s) / steps;
        const Vec3 normal = ((1.0 - share) * a.normal_P + share * b.normal_P).normalized();
        centres.push_back((1.0 - share) * a.point_P_mm + share * b.point_P_mm + radius_mm * normal);
      }
    }
  }
  return centres;
}

/// Barycentric middles of the per_edge^2 parts of a triangle.
std::vector<Vec3> sample_places(int per_edge) {
  std::vector<Vec3> out;
  for (int i = 0; i < per_edge; ++i) {
    for (int j = 0; j < per_edge - i; ++j) {
      for (int down = 0; down < (j < per_edge - i - 1 ? 2 : 1); ++down) {
        const double third = (1.0 + down) / 3.0, a = (i + third) / per_edge, b = (j + third) / per_edge;
        out.emplace_back(a, b, 1.0 - a - b);
      }
    }
  }
  return out;
}

/// Least t with point + t normal inside a ball whose centre lies in the cells around; radius where there is none.
double entry_mm(const PointGrid& grid, std::span<const Vec3> centres, const Vec3& point, const Vec3& normal,
                double radius_mm, double reach_mm) {
  double least = radius_mm;
  const double radius_sq = radius_mm * radius_mm;
  grid.near(point + radius_mm * normal, reach_mm, [&](Index i) {
    const Vec3 to_centre = centres[at(i)] - point;
    const double along = to_centre.dot(normal);
    const double inside_sq = radius_sq - (to_centre.squaredNorm() - along * along);
    if (inside_sq >= 0.0) least = std::min(least, along - std::sqrt(inside_sq));
  });
  return least;
}

ScallopStatistics statistics_of(const std::vector<double>& ratio, const std::vector<double>& area) {
  const std::size_t per_triangle = ratio.size() / area.size();
  std::vector<std::size_t> order(ratio.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ratio[a] > ratio[b]; });
  const double total = std::accumulate(area.begin(), area.end(), 0.0) * static_cast<double>(per_triangle);
  ScallopStatistics out;
  out.max_ratio = ratio[order.front()];
  double above = 0.0, passed = 0.0;
  bool found = false;
  for (std::size_t s : order) {
    if (ratio[s] > 1.0) above += area[s / per_triangle];
    passed += area[s / per_triangle];
    if (!found && passed >= 1e-4 * total) {
      out.p9999_ratio = ratio[s];
      found = true;
    }
    if (found && ratio[s] <= 1.0) break;
  }
  out.area_above_percent = 100.0 * above / total;
  return out;
}

}  // namespace

ScallopMap measure_scallop(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals, const CcPath& path,
                           double radius_mm, double scallop_mm, int per_edge) {
  VOLUTE_CHECK(scallop_mm > 0.0 && scallop_mm < radius_mm && per_edge > 0, scallop_mm, radius_mm, per_edge);
  VOLUTE_CHECK(vertex_normals.size() == mesh.vertices_mm.size() && !mesh.triangles.empty(), vertex_normals.size());
  const double interval_mm = path_interval_mm(radius_mm, scallop_mm, 0.0);
  const std::vector<Vec3> centres = ball_centres(path, radius_mm, interval_mm / 20.0);
  const PointGrid grid(centres, 0.3 * interval_mm);
  const std::vector<Vec3> places = sample_places(per_edge);
  std::vector<double> ratio(mesh.triangles.size() * places.size());
  std::vector<double> area(mesh.triangles.size());
  ScallopMap map;
  map.worst_ratio.resize(mesh.triangles.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, area.size(), 256),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t t = range.begin(); t < range.end(); ++t) {
                        const auto& c = mesh.triangles[t];
                        area[t] = geometry::triangle_area_mm2(mesh, static_cast<Index>(t));
                        double worst = -radius_mm;
                        for (std::size_t s = 0; s < places.size(); ++s) {
                          const Vec3& w = places[s];
                          const auto mix = [&](std::span<const Vec3> v) {
                            return Vec3(w[0] * v[at(c[0])] + w[1] * v[at(c[1])] + w[2] * v[at(c[2])]);
                          };
                          const Vec3 point = mix(mesh.vertices_mm), normal = mix(vertex_normals).normalized();
                          // What is seen within a short reach is never too low; only heights that matter are worth a
                          // longer one. Where the
                          // surface is sharply convex the balls' centres stand farther apart than the passes.
                          double height = entry_mm(grid, centres, point, normal, radius_mm, 0.6 * interval_mm);
                          for (double reach = 1.2; height > 0.8 * scallop_mm && reach < 5.0; reach *= 2.0) {
                            const double wider = entry_mm(grid, centres, point, normal, radius_mm, reach * interval_mm);
                            if (wider == height && height < radius_mm) break;
                            height = wider;
                          }
                          ratio[t * places.size() + s] = height / scallop_mm;
                          worst = std::max(worst, height / scallop_mm);
                        }
                        map.worst_ratio[t] = worst;
                      }
                    });
  map.statistics = statistics_of(ratio, area);
  return map;
}

}  // namespace volute::planner
