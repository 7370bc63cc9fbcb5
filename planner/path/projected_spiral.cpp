#include <cmath>
#include <numbers>

#include "geometry/mesh_measure.hpp"
#include "planner/path/baselines.hpp"
#include "planner/path/pass_chain.hpp"

namespace volute::planner {

using geometry::MeshTopology;

namespace {

constexpr double points_per_interval = 8.0;
/// A projected step that climbs more than this many steps leaves the surface: a wall or an edge.
constexpr double climb_max = 4.0;

struct ProjectedSpiral {
  double x_mm, y_mm, radius_mm;  ///< centre, and the greatest distance of the boundary from it
};

/// About the middle of the outer boundary's projection.
ProjectedSpiral around_boundary(const TriangleMesh& mesh, const std::vector<Index>& outer) {
  Vec3 low = mesh.vertices_mm[static_cast<std::size_t>(outer.front())], high = low;
  for (Index v : outer) {
    low = low.cwiseMin(mesh.vertices_mm[static_cast<std::size_t>(v)]);
    high = high.cwiseMax(mesh.vertices_mm[static_cast<std::size_t>(v)]);
  }
  ProjectedSpiral spiral{0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), 0.0};
  for (const Vec3& v : mesh.vertices_mm)
    spiral.radius_mm = std::max(spiral.radius_mm, std::hypot(v.x() - spiral.x_mm, v.y() - spiral.y_mm));
  return spiral;
}

/// From outside in; a run ends where the projection leaves the surface.
std::vector<Run> project(const ProjectedSpiral& spiral, const SurfaceLocator& locator, double interval_mm) {
  const double step_mm = interval_mm / points_per_interval, turns = spiral.radius_mm / interval_mm + 0.5;
  std::vector<Run> runs;
  std::vector<RawPoint> stretch;
  const auto close = [&] {
    if (stretch.size() >= 2) runs.push_back({{std::move(stretch), false}});
    stretch.clear();
  };
  double turn = 0.0;
  while (turn <= turns) {
    const double radius_mm = (turns - turn) * interval_mm, angle = 2.0 * std::numbers::pi * turn;
    const auto hit = locator.drop(spiral.x_mm + radius_mm * std::cos(angle), spiral.y_mm + radius_mm * std::sin(angle));
    const bool climbs =
        hit && !stretch.empty() && std::abs(hit->point_mm.z() - stretch.back().point_mm.z()) > climb_max * step_mm;
    if (!hit || climbs) close();
    if (hit) stretch.push_back({hit->point_mm, hit->normal, turn, Vec3::Zero()});
    turn += step_mm / (2.0 * std::numbers::pi * std::max(radius_mm, 2.0 * step_mm));
  }
  close();
  return runs;
}

}  // namespace

Result<CcPathResult> plan_projected_spiral(const TriangleMesh& surface, const kinematics::Cutter& cutter,
                                           const PathOptions& options, const OrientationOptions& orientation) {
  const auto topology = MeshTopology::build(surface);
  if (!topology) return tl::unexpected(topology.error());
  const IntervalField intervals(surface, interval_rule(cutter, options.scallop_mm, orientation));
  const auto normals = geometry::vertex_normals(surface);
  const SurfaceLocator locator(surface, normals);
  const auto runs = project(around_boundary(surface, topology->boundary_loops()[0].vertices), locator,
                            constant_interval_mm(surface, intervals));
  if (runs.empty())
    return geometry::bad_input(
        "path-projection",
        "the surface has no part that faces upwards: a spiral projected along z misses it; turn the part");
  CcPathResult result;
  result.report.strategy = "projected-spiral";
  finish_runs(runs, options, curve_options(cutter, options, orientation, intervals.rule()), result);
  measure_path({surface, intervals, {}, false, true}, result.path, result.report);
  return result;
}

}  // namespace volute::planner
