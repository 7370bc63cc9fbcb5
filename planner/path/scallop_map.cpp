#include "planner/path/scallop_map.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

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

/// Corners of a triangle that lie on the surface's boundary, and its edges (from corner k to k + 1) that do.
struct BoundaryParts {
  std::array<bool, 3> corner{}, edge{};
  [[nodiscard]] bool any() const { return corner[0] || corner[1] || corner[2]; }
};

std::vector<BoundaryParts> boundary_parts(const TriangleMesh& mesh) {
  struct Side {
    Index low, high;
    std::size_t triangle, edge;
    bool operator<(const Side& o) const {
      return std::tie(low, high, triangle, edge) < std::tie(o.low, o.high, o.triangle, o.edge);
    }
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  }
  tbb::parallel_sort(sides.begin(), sides.end());
  const auto same = [&](std::size_t i, std::size_t j) {
    return j < sides.size() && sides[i].low == sides[j].low && sides[i].high == sides[j].high;
  };
  std::vector<BoundaryParts> out(mesh.triangles.size());
  std::vector<char> on_boundary(mesh.vertices_mm.size(), 0);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (same(i, i + 1) || (i > 0 && same(i, i - 1))) continue;
    out[sides[i].triangle].edge[sides[i].edge] = true;
    on_boundary[at(sides[i].low)] = on_boundary[at(sides[i].high)] = 1;
  }
  for (std::size_t t = 0; t < out.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) out[t].corner[k] = on_boundary[at(mesh.triangles[t][k])] != 0;
  }
  return out;
}

/// Barycentric places on the boundary: corners that lie there, and `per_edge` points of each edge.
std::vector<Vec3> boundary_places(const BoundaryParts& parts, int per_edge) {
  std::vector<Vec3> out;
  for (int k = 0; k < 3; ++k) {
    if (parts.corner[static_cast<std::size_t>(k)]) out.push_back(Vec3::Unit(k));
    if (!parts.edge[static_cast<std::size_t>(k)]) continue;
    for (int i = 0; i < per_edge; ++i) {
      const double share = (i + 0.5) / per_edge;
      out.push_back((1.0 - share) * Vec3::Unit(k) + share * Vec3::Unit((k + 1) % 3));
    }
  }
  return out;
}

/// Looks around a place in six directions within the triangle, moves to what is higher, and nearer where nothing is:
/// `look_at` keeps the highest place, which is `place` itself.
template <class LookAt>
void climb(const Vec3& place, double step, LookAt look_at) {
  constexpr int nearer_max = 4, moves_max = 4;
  const std::array<Vec3, 6> ways = {Vec3(1, -1, 0), Vec3(-1, 1, 0), Vec3(1, 0, -1),
                                    Vec3(-1, 0, 1), Vec3(0, 1, -1), Vec3(0, -1, 1)};
  for (int nearer = 0, moves = 0; nearer < nearer_max && moves < moves_max;) {
    const Vec3 from = place;
    for (const Vec3& way : ways) {
      const Vec3 to = from + step * way;
      if (to.minCoeff() >= 0.0) look_at(to);
    }
    if (place != from) {
      ++moves;
      continue;
    }
    ++nearer;
    step *= 0.5;
  }
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

/// Share of the area above, and the ratio that all but 1e-4 of the area stays below: only the greatest samples are put
/// in order.
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
  VOLUTE_CHECK(sampling.closer_from_ratio >= sampling.exact_from_ratio, sampling.closer_from_ratio,
               sampling.exact_from_ratio);
  VOLUTE_CHECK(vertex_normals.size() == mesh.vertices_mm.size() && !mesh.triangles.empty(), vertex_normals.size());
  const double interval_mm = path_interval_mm(radius_mm, scallop_mm, 0.0);
  const Balls balls(ball_centres(path, radius_mm, interval_mm / 20.0), radius_mm, interval_mm);
  const std::vector<Vec3> places = sample_places(sampling.per_edge);
  const std::vector<BoundaryParts> boundary = boundary_parts(mesh);
  const double settled_mm = sampling.exact_from_ratio * scallop_mm;
  std::vector<double> ratio(mesh.triangles.size() * places.size());
  std::vector<double> area(mesh.triangles.size());
  ScallopMap map;
  map.worst_ratio.resize(mesh.triangles.size());
  map.worst_place_P_mm.resize(mesh.triangles.size());
  const auto mix = [&](std::size_t t, const Vec3& w, std::span<const Vec3> v) {
    const auto& c = mesh.triangles[t];
    return Vec3(w[0] * v[at(c[0])] + w[1] * v[at(c[1])] + w[2] * v[at(c[2])]);
  };
  const auto position = [&](std::size_t t, const Vec3& w) { return mix(t, w, mesh.vertices_mm); };
  const auto ratio_at = [&](std::size_t t, const Vec3& w, Index& guess) {
    auto entry = balls.nothing_met(position(t, w), mix(t, w, vertex_normals).normalized());
    if (settled_mm > 0.0 && guess != geometry::no_index) balls.follow(guess, settled_mm, entry);
    if (entry.height_mm >= settled_mm) balls.search(0.8 * scallop_mm, entry);
    if (entry.ball != geometry::no_index) guess = entry.ball;
    return entry.height_mm / scallop_mm;
  };
  const auto measure = [&](std::size_t t, Index& guess) {
    area[t] = geometry::triangle_area_mm2(mesh, static_cast<Index>(t));
    double worst = -radius_mm / scallop_mm;
    Vec3 place = places.front();
    const auto look_at = [&](const Vec3& w) {
      const double found = ratio_at(t, w, guess);
      if (found > worst) place = w;
      worst = std::max(worst, found);
      return found;
    };
    for (std::size_t s = 0; s < places.size(); ++s) ratio[t * places.size() + s] = look_at(places[s]);
    if (boundary[t].any()) {
      for (const Vec3& w : boundary_places(boundary[t], sampling.per_edge)) look_at(w);
    }
    if (worst > sampling.closer_from_ratio) climb(place, 0.5 / sampling.per_edge, look_at);
    map.worst_ratio[t] = worst;
    map.worst_place_P_mm[t] = position(t, place);
  };
  // Chunks of one size whatever the number of threads: a guess goes on within its chunk alone.
  constexpr std::size_t chunk = 64;
  tbb::parallel_for(std::size_t{0}, (area.size() + chunk - 1) / chunk, [&](std::size_t k) {
    Index guess = geometry::no_index;
    for (std::size_t t = k * chunk; t < std::min(area.size(), (k + 1) * chunk); ++t) measure(t, guess);
  });
  map.statistics = statistics_of(ratio, area);
  map.statistics.max_ratio = *std::max_element(map.worst_ratio.begin(), map.worst_ratio.end());
  return map;
}

}  // namespace volute::planner
