#include "planner/path/scallop_map.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/point_grid.hpp"

namespace volute::planner {

using geometry::at;
namespace {

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

/// The balls' centres, along the path and again cell by cell.
class Balls {
 public:
  Balls(std::vector<Vec3> centres, double radius_mm, double interval_mm)
      : along_(std::move(centres)),
        radius_mm_(radius_mm),
        interval_mm_(interval_mm),
        cells_(along_, 0.3 * interval_mm) {
    in_cells_.reserve(along_.size());
    for (Index i : cells_.order()) in_cells_.push_back(along_[at(i)]);
  }

  /// A sample point of the surface and the ball, by its number along the path, that enters its normal first so far.
  struct Entry {
    Vec3 point, normal;
    double height_mm;
    Index ball = geometry::no_index;
  };
  [[nodiscard]] Entry nothing_met(const Vec3& point, const Vec3& normal) const { return {point, normal, radius_mm_}; }

  /// Follows the path from a ball to where the height falls no more, or is low enough.
  void follow(Index from, double enough_mm, Entry& entry) const {
    lower(along_[at(from)], from, entry);
    for (const Index step : {Index{1}, Index{-1}}) {
      for (Index i = from + step; i >= 0 && i < static_cast<Index>(along_.size()); i += step) {
        if (entry.height_mm < enough_mm || !lower(along_[at(i)], i, entry)) break;
      }
    }
  }

  /// Every ball that may enter. What is seen within a short reach is never too low; only heights over `matters_mm` are
  /// worth a longer one. Where the surface is sharply convex the balls' centres stand farther apart than the passes.
  void search(double matters_mm, Entry& entry) const {
    within(0.6 * interval_mm_, entry);
    for (double reach = 1.2; entry.height_mm > matters_mm && reach < 5.0; reach *= 2.0) {
      const double before = entry.height_mm;
      within(reach * interval_mm_, entry);
      if (entry.height_mm == before && before < radius_mm_) break;
    }
  }

 private:
  /// Takes the ball's height where it is lower.
  bool lower(const Vec3& centre, Index ball, Entry& entry) const {
    const Vec3 to_centre = centre - entry.point;
    const double along = to_centre.dot(entry.normal);
    const double inside_sq = radius_mm_ * radius_mm_ - (to_centre.squaredNorm() - along * along);
    if (inside_sq < 0.0) return false;
    // along - sqrt(inside_sq) < height without the root, which few balls are worth.
    const double over = along - entry.height_mm;
    if (over >= 0.0 && inside_sq <= over * over) return false;
    const double height = along - std::sqrt(inside_sq);
    if (height >= entry.height_mm) return false;
    entry.height_mm = height;
    entry.ball = ball;
    return true;
  }

  void within(double reach_mm, Entry& entry) const {
    cells_.near_ranges(entry.point + radius_mm_ * entry.normal, reach_mm, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) lower(in_cells_[i], cells_.order()[i], entry);
    });
  }

  std::vector<Vec3> along_, in_cells_;
  double radius_mm_, interval_mm_;
  PointGrid cells_;
};

/// Area above, and the ratio that all but 1e-4 of the area stays below: only the greatest samples are put in order.
ScallopStatistics statistics_of(const std::vector<double>& ratio, const std::vector<double>& area) {
  const std::size_t per_triangle = ratio.size() / area.size();
  const double total = std::accumulate(area.begin(), area.end(), 0.0) * static_cast<double>(per_triangle);
  ScallopStatistics out;
  double above = 0.0;
  std::vector<std::size_t> heap(ratio.size());
  std::iota(heap.begin(), heap.end(), std::size_t{0});
  for (std::size_t s : heap) {
    if (ratio[s] > 1.0) above += area[s / per_triangle];
  }
  const auto lower = [&](std::size_t a, std::size_t b) { return ratio[a] != ratio[b] ? ratio[a] < ratio[b] : a < b; };
  std::make_heap(heap.begin(), heap.end(), lower);
  out.max_ratio = ratio[heap.front()];
  for (double passed = 0.0; passed < 1e-4 * total && !heap.empty();) {
    out.p9999_ratio = ratio[heap.front()];
    passed += area[heap.front() / per_triangle];
    std::pop_heap(heap.begin(), heap.end(), lower);
    heap.pop_back();
  }
  out.area_above_percent = 100.0 * above / total;
  return out;
}

}  // namespace

ScallopMap measure_scallop(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals, const CcPath& path,
                           double radius_mm, double scallop_mm, const ScallopSampling& sampling) {
  VOLUTE_CHECK(scallop_mm > 0.0 && scallop_mm < radius_mm && sampling.per_edge > 0, scallop_mm, radius_mm,
               sampling.per_edge);
  VOLUTE_CHECK(vertex_normals.size() == mesh.vertices_mm.size() && !mesh.triangles.empty(), vertex_normals.size());
  const double interval_mm = path_interval_mm(radius_mm, scallop_mm, 0.0);
  const Balls balls(ball_centres(path, radius_mm, interval_mm / 20.0), radius_mm, interval_mm);
  const std::vector<Vec3> places = sample_places(sampling.per_edge);
  const double settled_mm = sampling.exact_from_ratio * scallop_mm;
  std::vector<double> ratio(mesh.triangles.size() * places.size());
  std::vector<double> area(mesh.triangles.size());
  ScallopMap map;
  map.worst_ratio.resize(mesh.triangles.size());
  const auto measure = [&](std::size_t t, Index& guess) {
    const auto& c = mesh.triangles[t];
    area[t] = geometry::triangle_area_mm2(mesh, static_cast<Index>(t));
    double worst = -radius_mm;
    for (std::size_t s = 0; s < places.size(); ++s) {
      const Vec3& w = places[s];
      const auto mix = [&](std::span<const Vec3> v) {
        return Vec3(w[0] * v[at(c[0])] + w[1] * v[at(c[1])] + w[2] * v[at(c[2])]);
      };
      auto entry = balls.nothing_met(mix(mesh.vertices_mm), mix(vertex_normals).normalized());
      if (settled_mm > 0.0 && guess != geometry::no_index) balls.follow(guess, settled_mm, entry);
      if (entry.height_mm >= settled_mm) balls.search(0.8 * scallop_mm, entry);
      if (entry.ball != geometry::no_index) guess = entry.ball;
      ratio[t * places.size() + s] = entry.height_mm / scallop_mm;
      worst = std::max(worst, entry.height_mm / scallop_mm);
    }
    map.worst_ratio[t] = worst;
  };
  // Chunks of one size whatever the number of threads: a guess goes on within its chunk alone.
  constexpr std::size_t chunk = 64;
  tbb::parallel_for(std::size_t{0}, (area.size() + chunk - 1) / chunk, [&](std::size_t k) {
    Index guess = geometry::no_index;
    for (std::size_t t = k * chunk; t < std::min(area.size(), (k + 1) * chunk); ++t) measure(t, guess);
  });
  map.statistics = statistics_of(ratio, area);
  return map;
}

}  // namespace volute::planner
