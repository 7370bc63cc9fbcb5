#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/baselines.hpp"
#include "planner/path/level_trace.hpp"
#include "planner/path/pass_chain.hpp"

namespace volute::planner {

using geometry::at;
using geometry::MeshTopology;

namespace {

constexpr double link_intervals_max = 3.0;  ///< a longer way along the boundary is a rapid traversal

/// Where boundary vertices stand in their loops.
class BoundaryWalk {
 public:
  BoundaryWalk(const TriangleMesh& mesh, const MeshTopology& topology)
      : mesh_(mesh), loops_(topology.boundary_loops()) {
    for (std::size_t l = 0; l < loops_.size(); ++l)
      for (std::size_t i = 0; i < loops_[l].vertices.size(); ++i) place_[loops_[l].vertices[i]] = {l, i};
  }

  /// The boundary vertices on the shorter way between two places on boundary edges of one loop; nothing when it is
  /// longer than `length_max_mm` or the places lie on different loops.
  [[nodiscard]] std::optional<std::vector<Index>> between(const SurfacePoint& from, const SurfacePoint& to,
                                                          double length_max_mm) const {
    const auto p = place_.find(from.a), q = place_.find(to.a);
    if (p == place_.end() || q == place_.end() || p->second.loop != q->second.loop) return std::nullopt;
    const auto& loop = loops_[p->second.loop].vertices;
    const std::size_t e = edge_place(from, loop), f = edge_place(to, loop), n = loop.size();
    std::vector<Index> ahead, back;
    for (std::size_t i = e; i != f; i = (i + 1) % n) ahead.push_back(loop[(i + 1) % n]);
    for (std::size_t i = e; i != f; i = (i + n - 1) % n) back.push_back(loop[i]);
    const double ahead_mm = way_mm(from, ahead, to), back_mm = way_mm(from, back, to);
    if (std::min(ahead_mm, back_mm) > length_max_mm) return std::nullopt;
    return ahead_mm <= back_mm ? ahead : back;
  }

 private:
  struct Place {
    std::size_t loop, index;
  };
  /// Number of the loop's edge that holds the place: edge i joins vertices i and i + 1.
  [[nodiscard]] std::size_t edge_place(const SurfacePoint& place, const std::vector<Index>& loop) const {
    const std::size_t i = place_.at(place.a).index;
    if (place.is_vertex() || loop[(i + 1) % loop.size()] == place.b) return i;
    return (i + loop.size() - 1) % loop.size();
  }
  [[nodiscard]] double way_mm(const SurfacePoint& from, const std::vector<Index>& way, const SurfacePoint& to) const {
    double length = 0.0;
    Vec3 here = position_mm(mesh_, from);
    for (Index v : way) {
      length += (mesh_.vertices_mm[at(v)] - here).norm();
      here = mesh_.vertices_mm[at(v)];
    }
    return length + (position_mm(mesh_, to) - here).norm();
  }

  const TriangleMesh& mesh_;
  const std::vector<geometry::BoundaryLoop>& loops_;
  std::map<Index, Place> place_;
};

struct PlanarPass {
  SurfacePath points;
  long level = 0;
  double start = 0.0;  ///< along the plane
};

/// All passes, plane by plane, to and fro.
std::vector<PlanarPass> zigzag(const TriangleMesh& mesh, const MeshTopology& topology, const std::vector<double>& level,
                               const Vec3& along) {
  std::vector<PlanarPass> passes;
  for (LevelLine& line : trace_levels(mesh, topology, {level, {}}, 0.5)) {
    if (line.closed) line.points.push_back(line.points.front());
    const SurfacePoint& first = line.points.front();
    const double value =
        (1.0 - first.t) * level[at(first.a)] + (first.is_vertex() ? 0.0 : first.t * level[at(first.b)]);
    passes.push_back({std::move(line.points), std::lround(value - 0.5), 0.0});
    PlanarPass& pass = passes.back();
    if (pass.level % 2 != 0) std::reverse(pass.points.begin(), pass.points.end());
    pass.start = position_mm(mesh, pass.points.front()).dot(along) * (pass.level % 2 == 0 ? 1.0 : -1.0);
  }
  std::stable_sort(passes.begin(), passes.end(), [](const PlanarPass& a, const PlanarPass& b) {
    return a.level != b.level ? a.level < b.level : a.start < b.start;
  });
  return passes;
}

/// The planes' coordinate in passes: whole numbers and a half are planes, evenly spread over the surface.
std::vector<double> plane_levels(const TriangleMesh& mesh, const Vec3& across, double interval_mm) {
  std::vector<double> level;
  for (const Vec3& v : mesh.vertices_mm) level.push_back(v.dot(across));
  const auto [low, high] = std::minmax_element(level.begin(), level.end());
  const double least = *low, range = *high - *low, planes = std::ceil(range / interval_mm);
  for (double& x : level) x = (x - least) / range * planes;
  return level;
}

}  // namespace

Result<CcPathResult> plan_iso_planar(const TriangleMesh& surface, const kinematics::Cutter& cutter,
                                     const PathOptions& options, const OrientationOptions& orientation) {
  const auto topology = MeshTopology::build(surface);
  if (!topology) return tl::unexpected(topology.error());
  const IntervalField intervals(surface, interval_rule(cutter, options.scallop_mm, orientation));
  const auto normals = geometry::vertex_normals(surface);
  const double interval_mm = constant_interval_mm(surface, intervals), angle = options.plane_angle_rad;
  const Vec3 along(std::cos(angle), std::sin(angle), 0.0), across(-std::sin(angle), std::cos(angle), 0.0);
  const auto passes = zigzag(surface, *topology, plane_levels(surface, across, interval_mm), along);
  const BoundaryWalk boundary(surface, *topology);
  const auto raw = [&](const SurfacePoint& p, long level) {
    const Vec3& n = normals[at(p.a)];
    const Vec3 normal = p.is_vertex() ? n : Vec3(((1.0 - p.t) * n + p.t * normals[at(p.b)]).normalized());
    return RawPoint{position_mm(surface, p), normal, static_cast<double>(level), Vec3::Zero()};
  };
  std::vector<Run> runs;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const long level = passes[i].level;
    const auto way = i > 0 ? boundary.between(passes[i - 1].points.back(), passes[i].points.front(),
                                              link_intervals_max * interval_mm)
                           : std::nullopt;
    if (!way) {
      runs.emplace_back();
    } else {
      RawStretch link{{raw(passes[i - 1].points.back(), level)}, true};
      for (Index v : *way) link.points.push_back(raw(SurfacePoint::vertex(v), level));
      link.points.push_back(raw(passes[i].points.front(), level));
      runs.back().push_back(std::move(link));
    }
    runs.back().emplace_back();
    for (const SurfacePoint& p : passes[i].points) runs.back().back().points.push_back(raw(p, level));
  }
  CcPathResult result;
  result.report.strategy = "iso-planar";
  finish_runs(runs, options, curve_options(cutter, options, orientation, intervals.rule()), result);
  measure_path({surface, intervals, {}, false, true}, result.path, result.report);
  return result;
}

}  // namespace volute::planner
