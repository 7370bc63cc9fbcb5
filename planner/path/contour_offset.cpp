#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/baselines.hpp"
#include "planner/path/level_trace.hpp"
#include "planner/path/pass_chain.hpp"
#include "planner/path/point_grid.hpp"
#include "planner/surface/geodesic_distance.hpp"

namespace volute::planner {

using geometry::at;
using geometry::MeshTopology;

namespace {

constexpr double offset_link_intervals_max = 2.0;  ///< from offset to offset; farther is a rapid traversal

/// A closed pass at a whole number of intervals from the boundary.
struct Offset {
  std::vector<RawPoint> points;  ///< not closed: the last joins the first
  int level = 0;
};

class OffsetTracer {
 public:
  OffsetTracer(const TriangleMesh& mesh, const MeshTopology& topology, const std::vector<Vec3>& normals)
      : mesh_(mesh), topology_(topology), normals_(normals) {}

  /// The boundaries themselves and the level lines of the distance, nearest the boundary first.
  [[nodiscard]] std::vector<Offset> offsets(std::vector<double> distance_mm, double interval_mm) const {
    std::vector<Offset> result;
    for (const geometry::BoundaryLoop& loop : topology_.boundary_loops()) {
      result.push_back({{}, 0});
      for (Index v : loop.vertices) result.back().points.push_back(raw(SurfacePoint::vertex(v), 0));
    }
    for (double& d : distance_mm) d /= interval_mm;
    for (const LevelLine& line : trace_levels(mesh_, topology_, {distance_mm, {}}, 0.0)) {
      const SurfacePoint& p = line.points.front();
      const int level = static_cast<int>(std::lround((1.0 - p.t) * distance_mm[at(p.a)] + p.t * distance_mm[at(p.b)]));
      if (!line.closed || level < 1 || line.points.size() < 8) continue;
      result.push_back({{}, level});
      for (const SurfacePoint& q : line.points) result.back().points.push_back(raw(q, level));
    }
    std::stable_sort(result.begin(), result.end(), [](const Offset& a, const Offset& b) { return a.level < b.level; });
    return result;
  }

 private:
  [[nodiscard]] RawPoint raw(const SurfacePoint& p, int level) const {
    const Vec3& n = normals_[at(p.a)];
    const Vec3 normal = p.is_vertex() ? n : Vec3(((1.0 - p.t) * n + p.t * normals_[at(p.b)]).normalized());
    return {position_mm(mesh_, p), normal, static_cast<double>(level), Vec3::Zero()};
  }

  const TriangleMesh& mesh_;
  const MeshTopology& topology_;
  const std::vector<Vec3>& normals_;
};

/// Starts the loop at its point nearest to a place and closes it.
std::vector<RawPoint> closed_from(const Offset& offset, const Vec3& near_mm) {
  std::vector<RawPoint> loop = offset.points;
  const auto nearest = std::min_element(loop.begin(), loop.end(), [&](const RawPoint& a, const RawPoint& b) {
    return (a.point_mm - near_mm).squaredNorm() < (b.point_mm - near_mm).squaredNorm();
  });
  std::rotate(loop.begin(), nearest, loop.end());
  loop.push_back(loop.front());
  return loop;
}

/// Where a chain starts: the loop's point that comes nearest to an offset one level on (its first point when there is
/// none), so that no link starts in a corner.
Vec3 start_of(const std::vector<Offset>& offsets, const std::vector<char>& used, std::size_t current) {
  std::vector<Vec3> next;
  for (std::size_t i = 0; i < offsets.size(); ++i)
    if (!used[i] && offsets[i].level == offsets[current].level + 1)
      for (const RawPoint& p : offsets[i].points) next.push_back(p.point_mm);
  Vec3 best = offsets[current].points.front().point_mm;
  double best_sq = std::numeric_limits<double>::infinity();
  for (const RawPoint& p : offsets[current].points)
    for (const Vec3& q : next) {
      const double distance_sq = (p.point_mm - q).squaredNorm();
      if (distance_sq >= best_sq) continue;
      best_sq = distance_sq;
      best = p.point_mm;
    }
  return best;
}

/// The unused offset one level on that comes nearest to a place, within reach.
std::optional<std::size_t> next_offset(const std::vector<Offset>& offsets, const std::vector<char>& used,
                                       const Vec3& here, int level, double reach_mm) {
  std::optional<std::size_t> best;
  double best_mm = reach_mm;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (used[i] || offsets[i].level != level + 1) continue;
    for (const RawPoint& p : offsets[i].points) {
      const double distance = (p.point_mm - here).norm();
      if (distance >= best_mm) continue;
      best_mm = distance;
      best = i;
    }
  }
  return best;
}

/// Chains of offsets, each from the boundary side inwards as far as neighbours lead; a new chain starts with a rapid
/// traversal.
std::vector<Run> chains(const std::vector<Offset>& offsets, const SurfaceLocator& locator, double interval_mm) {
  std::vector<Run> runs;
  std::vector<char> used(offsets.size(), 0);
  for (std::size_t start = 0; start < offsets.size(); ++start) {
    if (used[start]) continue;
    runs.emplace_back();
    std::optional<std::size_t> current = start;
    while (current) {
      used[*current] = 1;
      const bool first = runs.back().empty();
      const Vec3 here = first ? start_of(offsets, used, *current) : runs.back().back().points.back().point_mm;
      std::vector<RawPoint> loop = closed_from(offsets[*current], here);
      if (!first)
        runs.back().push_back(
            {link_across(locator, runs.back().back().points.back(), loop.front(), 0.25 * interval_mm), true});
      const Vec3 end = loop.back().point_mm;
      runs.back().push_back({std::move(loop), false});
      current = next_offset(offsets, used, end, offsets[*current].level, offset_link_intervals_max * interval_mm);
    }
  }
  return runs;
}

}  // namespace

Result<CcPathResult> plan_contour_offset(const TriangleMesh& surface, const kinematics::Cutter& cutter,
                                         const PathOptions& options, const OrientationOptions& orientation) {
  const auto topology = MeshTopology::build(surface);
  if (!topology) return tl::unexpected(topology.error());
  const IntervalField intervals(surface, interval_rule(cutter, options.scallop_mm, orientation));
  const auto normals = geometry::vertex_normals(surface);
  std::vector<Index> boundary;
  for (const geometry::BoundaryLoop& loop : topology->boundary_loops())
    boundary.insert(boundary.end(), loop.vertices.begin(), loop.vertices.end());
  auto distance_mm = geodesic_distance_mm(surface, boundary);
  if (!distance_mm) return tl::unexpected(distance_mm.error());
  const double interval_mm = constant_interval_mm(surface, intervals);
  const auto offsets = OffsetTracer(surface, *topology, normals).offsets(std::move(*distance_mm), interval_mm);
  const SurfaceLocator locator(surface, normals);
  CcPathResult result;
  result.report.strategy = "contour-offset";
  finish_runs(chains(offsets, locator, interval_mm), options,
              curve_options(cutter, options, orientation, intervals.rule()), result);
  measure_path({surface, intervals, {}, false, true}, result.path, result.report);
  return result;
}

}  // namespace volute::planner
