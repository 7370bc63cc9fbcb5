#include "planner/path/scallop_map.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <tuple>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/path_interval.hpp"
#include "planner/path/scallop_climb.hpp"

namespace volute::planner {

using geometry::at;
namespace {

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

/// Takes the samples in order of height until they are 1e-4 of the area; false where they are fewer.
bool highest_share(const std::vector<double>& ratio, const std::vector<double>& area, std::vector<std::size_t> heap,
                   double share, double& p9999_ratio) {
  const std::size_t per_triangle = ratio.size() / area.size();
  const auto lower = [&](std::size_t a, std::size_t b) { return ratio[a] != ratio[b] ? ratio[a] < ratio[b] : a < b; };
  std::make_heap(heap.begin(), heap.end(), lower);
  double passed = 0.0;
  while (passed < share && !heap.empty()) {
    p9999_ratio = ratio[heap.front()];
    passed += area[heap.front() / per_triangle];
    std::pop_heap(heap.begin(), heap.end(), lower);
    heap.pop_back();
  }
  return passed >= share;
}

/// Share of the area above, and the ratio that all but 1e-4 of the area stays below: only the greatest samples are put
/// in order.
ScallopStatistics statistics_of(const std::vector<double>& ratio, const std::vector<double>& area) {
  constexpr double usually_below = 0.9;
  const std::size_t per_triangle = ratio.size() / area.size();
  const double total = std::accumulate(area.begin(), area.end(), 0.0) * static_cast<double>(per_triangle);
  ScallopStatistics out;
  double above = 0.0;
  std::vector<std::size_t> high;
  for (std::size_t s = 0; s < ratio.size(); ++s) {
    if (ratio[s] > 1.0) above += area[s / per_triangle];
    if (ratio[s] > usually_below) high.push_back(s);
  }
  if (!highest_share(ratio, area, std::move(high), 1e-4 * total, out.p9999_ratio)) {
    std::vector<std::size_t> all(ratio.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    highest_share(ratio, area, std::move(all), 1e-4 * total, out.p9999_ratio);
  }
  out.area_above_percent = 100.0 * above / total;
  return out;
}

/// The triangles along a curve that fills space: those of a chunk are neighbours, whatever the mesh's own order.
std::vector<std::size_t> neighbours_together(const TriangleMesh& mesh) {
  constexpr int bits = 10;
  LookedAt box;
  for (const Vec3& v : mesh.vertices_mm) box.extend(v);
  const double cells_per_mm = (std::ldexp(1.0, bits) - 1.0) / std::max(box.sizes().maxCoeff(), 1e-300);
  std::vector<std::pair<std::uint32_t, std::size_t>> order(mesh.triangles.size());
  for (std::size_t t = 0; t < order.size(); ++t) {
    const auto& c = mesh.triangles[t];
    const Vec3 middle = (mesh.vertices_mm[at(c[0])] + mesh.vertices_mm[at(c[1])] + mesh.vertices_mm[at(c[2])]) / 3.0;
    const Vec3 cell = (middle - box.min()) * cells_per_mm;
    std::uint32_t key = 0;
    for (int bit = bits - 1; bit >= 0; --bit) {
      for (double x : cell) key = 2 * key + (static_cast<std::uint32_t>(x) >> bit & 1U);
    }
    order[t] = {key, t};
  }
  tbb::parallel_sort(order.begin(), order.end());
  std::vector<std::size_t> out;
  for (const auto& [key, t] : order) out.push_back(t);
  return out;
}

/// A stretch of the path between two CC points: point and normal of the one, of the other.
using Stretch = std::array<double, 12>;

Stretch stretch_of(const CcPoint& a, const CcPoint& b) {
  Stretch out;
  auto next = out.begin();
  for (const CcPoint* p : {&a, &b}) {
    next = std::copy(p->point_P_mm.begin(), p->point_P_mm.end(), next);
    next = std::copy(p->normal_P.begin(), p->normal_P.end(), next);
  }
  return out;
}

/// All centres of the balls on a stretch lie in it.
LookedAt box_of(const Stretch& stretch, double radius_mm) {
  const auto vector = [&](std::size_t i) { return Vec3(stretch[i], stretch[i + 1], stretch[i + 2]); };
  // A normal between those of the ends is a vector between them, made longer again.
  const double longer_mm = std::max(0.0, radius_mm * (1.0 - 0.5 * (vector(3) + vector(9)).norm()));
  const Vec3 room = Vec3::Constant(longer_mm + 1e-9 * radius_mm);
  LookedAt box(Vec3(vector(0) + radius_mm * vector(3)));
  box.extend(vector(6) + radius_mm * vector(9));
  return {box.min() - room, box.max() + room};
}

std::vector<Stretch> stretches_of(const CcPath& path) {
  std::vector<Stretch> out;
  for (const CcPiece& piece : path.pieces) {
    for (std::size_t i = 0; i < piece.points.size(); ++i)
      out.push_back(stretch_of(piece.points[i], piece.points[std::min(i + 1, piece.points.size() - 1)]));
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Boxes of the stretches that only one of two paths has.
std::vector<LookedAt> changed_boxes(const std::vector<Stretch>& a, const std::vector<Stretch>& b, double radius_mm) {
  std::vector<Stretch> changed;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(changed));
  std::vector<LookedAt> out;
  for (const Stretch& stretch : changed) out.push_back(box_of(stretch, radius_mm));
  return out;
}

}  // namespace

/// Chunks of one size whatever the number of threads: a guess goes on within its chunk alone.
struct ScallopMeter::Last {
  static constexpr std::size_t chunk = 64;
  ScallopBalls balls;
  std::vector<std::array<double, 12>> stretches;  ///< of the path, in order of their numbers
  std::vector<double> ratio;                      ///< per sample
  std::vector<LookedAt> looked_at;                ///< per chunk
  ScallopMap map;
};

ScallopMeter::ScallopMeter(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals, double radius_mm,
                           double scallop_mm, const ScallopSampling& sampling)
    : mesh_(mesh),
      vertex_normals_(vertex_normals),
      radius_mm_(radius_mm),
      scallop_mm_(scallop_mm),
      sampling_(sampling),
      places_(sample_places(sampling.per_edge)),
      thorough_places_(sample_places(sampling.thorough_per_edge)),
      order_(neighbours_together(mesh)) {
  VOLUTE_CHECK(scallop_mm > 0.0 && scallop_mm < radius_mm && sampling.per_edge > 0, scallop_mm, radius_mm,
               sampling.per_edge);
  VOLUTE_CHECK(sampling.closer_from_ratio >= sampling.exact_from_ratio, sampling.closer_from_ratio,
               sampling.exact_from_ratio);
  VOLUTE_CHECK(vertex_normals.size() == mesh.vertices_mm.size() && !mesh.triangles.empty(), vertex_normals.size());
  const std::vector<BoundaryParts> boundary = boundary_parts(mesh);
  for (std::size_t t = 0; t < boundary.size(); ++t) {
    area_mm2_.push_back(geometry::triangle_area_mm2(mesh, static_cast<Index>(t)));
    if (boundary[t].any()) boundary_places_[t] = boundary_places(boundary[t], sampling.per_edge);
  }
}

ScallopMeter::~ScallopMeter() = default;

ScallopEntry ScallopMeter::entry(const Last& last, std::size_t t, const Vec3& place, Index& guess,
                                 LookedAt& looked_at) const {
  const auto mix = [&](std::span<const Vec3> v) {
    const auto& c = mesh_.triangles[t];
    return Vec3(place[0] * v[at(c[0])] + place[1] * v[at(c[1])] + place[2] * v[at(c[2])]);
  };
  const double settled_mm = sampling_.exact_from_ratio * scallop_mm_;
  const ScallopBalls& balls = last.balls;
  auto entry = balls.nothing_met(mix(mesh_.vertices_mm), mix(vertex_normals_).normalized());
  if (guess != geometry::no_index && settled_mm > 0.0) balls.follow(guess, settled_mm, entry, looked_at);
  if (guess != geometry::no_index && settled_mm <= 0.0) balls.begin_with(guess, entry);
  if (entry.height_mm >= settled_mm) balls.search(0.8 * scallop_mm_, entry, looked_at);
  if (entry.ball != geometry::no_index) guess = entry.ball;
  return entry;
}

/// Climbs from the highest sample; where it is high enough, from the highest of each third of a triangle too, of more
/// samples.
SeenPlace ScallopMeter::highest_of(const Last& last, std::size_t t, const SeenPlace& sampled, Index& guess,
                                   LookedAt& looked_at) const {
  SeenPlace highest = sampled;
  const auto look_at = [&](const Vec3& place) {
    const SeenPlace seen{place, entry(last, t, place, guess, looked_at)};
    if (seen.entry.height_mm > highest.entry.height_mm) highest = seen;
    return seen;
  };
  const Facet facet(mesh_, t);
  if (facet.size_mm() <= 0.0) return highest;
  climb_scallop(last.balls, facet, sampled, 0.5 / sampling_.per_edge * facet.size_mm(), look_at);
  const double thorough_from_mm = sampling_.thorough_from_ratio * scallop_mm_;
  if (highest.entry.height_mm <= thorough_from_mm) return highest;
  std::array<std::optional<SeenPlace>, 3> of_third;
  for (const Vec3& place : thorough_places_) {
    Eigen::Index third = 0;
    place.maxCoeff(&third);
    auto& best = of_third[static_cast<std::size_t>(third)];
    const SeenPlace seen = look_at(place);
    if (!best || seen.entry.height_mm > best->entry.height_mm) best = seen;
  }
  for (const auto& best : of_third) {
    if (best && best->entry.height_mm > thorough_from_mm)
      climb_scallop(last.balls, facet, *best, 0.5 / sampling_.thorough_per_edge * facet.size_mm(), look_at);
  }
  return highest;
}

void ScallopMeter::measure_triangle(Last& last, std::size_t t, Index& guess, LookedAt& looked_at) const {
  SeenPlace highest{places_.front(), {}};
  highest.entry.height_mm = -radius_mm_;
  const auto look_at = [&](const Vec3& place) {
    const SeenPlace seen{place, entry(last, t, place, guess, looked_at)};
    if (seen.entry.height_mm > highest.entry.height_mm) highest = seen;
    return seen;
  };
  for (std::size_t s = 0; s < places_.size(); ++s)
    last.ratio[t * places_.size() + s] = look_at(places_[s]).entry.height_mm / scallop_mm_;
  if (const auto boundary = boundary_places_.find(t); boundary != boundary_places_.end()) {
    for (const Vec3& place : boundary->second) look_at(place);
  }
  if (highest.entry.height_mm > sampling_.closer_from_ratio * scallop_mm_)
    highest = highest_of(last, t, highest, guess, looked_at);
  last.map.worst_ratio[t] = highest.entry.height_mm / scallop_mm_;
  last.map.worst_place_P_mm[t] = highest.entry.point_mm;
}

const ScallopMap& ScallopMeter::measure(const CcPath& path) {
  const double interval_mm = path_interval_mm(radius_mm_, scallop_mm_, 0.0);
  ScallopBalls balls(path, radius_mm_, interval_mm);
  auto stretches = stretches_of(path);
  const std::size_t triangles = mesh_.triangles.size();
  std::vector<LookedAt> changed;
  const bool anew = !last_ || !last_->balls.same_cells(balls);
  if (anew) {
    last_ = std::make_unique<Last>(Last{std::move(balls), std::move(stretches), {}, {}, {}});
    last_->ratio.resize(triangles * places_.size());
    last_->looked_at.resize((triangles + Last::chunk - 1) / Last::chunk);
    last_->map.worst_ratio.resize(triangles);
    last_->map.worst_place_P_mm.resize(triangles);
  } else {
    changed = changed_boxes(last_->stretches, stretches, radius_mm_);
    last_->balls = std::move(balls);
    last_->stretches = std::move(stretches);
  }
  std::atomic<std::size_t> measured = 0;
  tbb::parallel_for(std::size_t{0}, last_->looked_at.size(), [&](std::size_t k) {
    LookedAt& looked_at = last_->looked_at[k];
    const auto near = [&](const LookedAt& box) { return box.intersects(looked_at); };
    if (!anew && std::none_of(changed.begin(), changed.end(), near)) return;
    looked_at.setEmpty();
    Index guess = geometry::no_index;
    const std::size_t end = std::min(triangles, (k + 1) * Last::chunk);
    for (std::size_t i = k * Last::chunk; i < end; ++i) measure_triangle(*last_, order_[i], guess, looked_at);
    measured += end - k * Last::chunk;
  });
  measured_ = measured;
  last_->map.statistics = statistics_of(last_->ratio, area_mm2_);
  last_->map.statistics.max_ratio = *std::max_element(last_->map.worst_ratio.begin(), last_->map.worst_ratio.end());
  return last_->map;
}

ScallopMap measure_scallop(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals, const CcPath& path,
                           double radius_mm, double scallop_mm, const ScallopSampling& sampling) {
  return ScallopMeter(mesh, vertex_normals, radius_mm, scallop_mm, sampling).measure(path);
}

}  // namespace volute::planner
