#include "planner/path/even_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/angle.hpp"
#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/even_mend.hpp"
#include "planner/path/even_resample.hpp"

namespace volute::planner {

using geometry::at;
namespace {

constexpr double greatest_left = 1.10;  ///< of the allowed height: with more a path is mended
constexpr double p9999_left = 1.05;
constexpr double doubtful_from = 0.95;  ///< of the allowed height: what a first look finds may be 0.1 too low
constexpr ScallopSampling close_look{
    .exact_from_ratio = 0.7, .closer_from_ratio = 0.7, .thorough_from_ratio = doubtful_from, .thorough_per_edge = 7};

/// The given surface with no edge longer than an interval; normals are the same at every point.
struct FineSurface {
  TriangleMesh mesh;
  std::vector<Vec3> vertex_normals;
  std::vector<Index> parent;  ///< of each triangle the given one
};

Result<FineSurface> fine_surface(const TriangleMesh& surface, std::span<const Vec3> vertex_normals,
                                 double interval_mm) {
  auto cut = finer(surface, interval_mm);
  if (!cut) return tl::unexpected(cut.error());
  FineSurface out{std::move(cut->mesh), {vertex_normals.begin(), vertex_normals.end()}, std::move(cut->parent)};
  for (const auto& ends : cut->ends)
    out.vertex_normals.emplace_back(0.5 * (out.vertex_normals[at(ends[0])] + out.vertex_normals[at(ends[1])]));
  return out;
}

/// The triangles that may hold more than the map says.
TriangleMesh doubtful(const TriangleMesh& given, const FineSurface& fine, const ScallopMap& map) {
  std::vector<int> parts(given.triangles.size(), 0);
  for (Index parent : fine.parent) ++parts[at(parent)];
  TriangleMesh out;
  out.vertices_mm = fine.mesh.vertices_mm;
  for (std::size_t t = 0; t < fine.mesh.triangles.size(); ++t) {
    const auto parent = at(fine.parent[t]);
    if (map.worst_ratio[parent] > doubtful_from || parts[parent] > 1) out.triangles.push_back(fine.mesh.triangles[t]);
  }
  return out;
}

/// The worse of both: what is sampled on few triangles knows nothing of the area.
ScallopStatistics looked_at_closely(const TriangleMesh& given, const FineSurface& fine, const CcPath& path,
                                    const ScallopMap& map, const IntervalRule& rule) {
  ScallopStatistics out = map.statistics;
  const TriangleMesh high = doubtful(given, fine, map);
  if (high.triangles.empty()) return out;
  const auto close =
      measure_scallop(high, fine.vertex_normals, path, rule.radius_mm, rule.scallop_mm, close_look).statistics;
  out.max_ratio = std::max(out.max_ratio, close.max_ratio);
  return out;
}

bool holds(const ScallopStatistics& scallop, double greatest) {
  return scallop.max_ratio <= greatest && scallop.p9999_ratio <= p9999_left;
}

/// How far a path is past what it should hold.
double past(const ScallopStatistics& scallop) {
  return std::max(0.0, scallop.p9999_ratio - p9999_left) + std::max(0.0, scallop.max_ratio - 1.0);
}

/// The surface with the vertices' normals and, after that, its triangles with their own, along which a program is
/// judged. Those that differ by less than 3 degrees change a height by less than 0.02 and are left out.
FineSurface seen_both_ways(const FineSurface& fine) {
  const double same = geometry::cos(geometry::Angle::degrees(3.0));
  const auto normals = geometry::triangle_normals(fine.mesh);
  FineSurface out = fine;
  for (std::size_t t = 0; t < fine.mesh.triangles.size(); ++t) {
    const auto& corners = fine.mesh.triangles[t];
    if (std::all_of(corners.begin(), corners.end(),
                    [&](Index v) { return normals[t].dot(fine.vertex_normals[at(v)].normalized()) > same; }))
      continue;
    const auto first = static_cast<Index>(out.mesh.vertices_mm.size());
    for (Index v : corners) {
      out.mesh.vertices_mm.push_back(fine.mesh.vertices_mm[at(v)]);
      out.vertex_normals.push_back(normals[t]);
    }
    out.mesh.triangles.push_back({first, first + 1, first + 2});
    out.parent.push_back(fine.parent[t]);
  }
  return out;
}

/// The greatest height of the first triangles of a map.
double greatest_of_first(const ScallopMap& map, std::size_t triangles) {
  return *std::max_element(map.worst_ratio.begin(), map.worst_ratio.begin() + static_cast<std::ptrdiff_t>(triangles));
}

struct MendRounds {
  int rounds_max = 0, failures_max = 0;
  double until = 0.0;           ///< nothing stands over this
  std::size_t first = 0;        ///< triangles of which
  double first_greatest = 0.0;  ///< nothing may stand over this
  MendOptions mend;
};

Result<MendedPath> mended_on(const FineSurface& fine, MendedPath best, const IntervalRule& rule,
                             const MendRounds& wanted) {
  const auto operators = triangle_operators(fine.mesh);
  const MendSurface on{fine.mesh, fine.vertex_normals, operators};
  ScallopMeter meter(fine.mesh, fine.vertex_normals, rule.radius_mm, rule.scallop_mm, close_look);
  const ScallopMap* map = &meter.measure(best.path);
  best.scallop = map->statistics;
  CcPath now = best.path;
  for (int round = 0, failures = 0; round < wanted.rounds_max && failures < wanted.failures_max; ++round) {
    if (holds(best.scallop, wanted.until)) break;
    if (auto mended = mend_finished(now.pieces.front(), *map, on, rule.radius_mm, rule.scallop_mm, wanted.mend);
        !mended)
      return tl::unexpected(mended.error());
    map = &meter.measure(now);
    if (past(map->statistics) < past(best.scallop) && greatest_of_first(*map, wanted.first) <= wanted.first_greatest) {
      best = {now, true, map->statistics};
      failures = 0;
    } else {
      ++failures;
    }
  }
  return best;
}

/// First along the vertices' normals, then carefully along the triangles' too: beside sharp edges those jump, and the
/// same steps as before overshoot.
Result<MendedPath> mended_both_ways(const FineSurface& fine, MendedPath path, const IntervalRule& rule) {
  const std::size_t triangles = fine.mesh.triangles.size();
  auto smooth = mended_on(fine, std::move(path), rule,
                          {.rounds_max = 16,
                           .failures_max = 5,
                           .until = 1.05,
                           .first = triangles,
                           .first_greatest = std::numeric_limits<double>::infinity(),
                           .mend = {}});
  if (!smooth) return smooth;
  const double kept = std::max(greatest_left, smooth->scallop.max_ratio);
  auto out = mended_on(seen_both_ways(fine), std::move(*smooth), rule,
                       {.rounds_max = 12,
                        .failures_max = 5,
                        .until = greatest_left,
                        .first = triangles,
                        .first_greatest = kept,
                        .mend = {.mended_from = 1.08, .aim_ratio = 1.06, .longest_intervals = 0.06}});
  if (!out) return out;
  out->scallop = measure_scallop(fine.mesh, fine.vertex_normals, out->path, rule.radius_mm, rule.scallop_mm, close_look)
                     .statistics;
  return out;
}

}  // namespace

Result<MendedPath> mended_closely(const TriangleMesh& surface, std::span<const Vec3> vertex_normals, CcPath path,
                                  const ScallopMap& map, const IntervalRule& rule) {
  const auto fine = fine_surface(surface, vertex_normals, rule.interval_mm(0.0));
  if (!fine) return tl::unexpected(fine.error());
  MendedPath out{std::move(path), false, {}};
  out.scallop = looked_at_closely(surface, *fine, out.path, map, rule);
  if (holds(out.scallop, greatest_left) || out.path.pieces.size() != 1) return out;
  return mended_both_ways(*fine, std::move(out), rule);
}

}  // namespace volute::planner
