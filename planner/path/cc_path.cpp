#include "planner/path/cc_path.hpp"

#include <tbb/parallel_invoke.h>

#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh_measure.hpp"
#include "geometry/number_text.hpp"
#include "planner/path/baselines.hpp"
#include "planner/path/even_nudge.hpp"
#include "planner/path/even_spiral.hpp"
#include "planner/path/even_verdict.hpp"
#include "planner/path/finish_path.hpp"
#include "planner/path/guided_path.hpp"
#include "planner/path/path_interval.hpp"
#include "planner/path/path_measure.hpp"
#include "planner/path/start_point.hpp"
#include "planner/surface/operators.hpp"

namespace volute::planner {

using geometry::bad_input;
using geometry::MeshTopology;

namespace {

Result<void> check_options(const kinematics::Cutter& cutter, const PathOptions& options,
                           const OrientationOptions& orientation) {
  const auto text = [](double x) { return geometry::short_text(x); };
  if (!(options.scallop_mm > 0.0))
    return bad_input("path-scallop", "path.scallop_mm = " + text(options.scallop_mm) + ": it must be above 0");
  const double radius_mm = interval_rule(cutter, options.scallop_mm, orientation).radius_mm;
  if (!(options.scallop_mm < radius_mm))
    return bad_input("path-scallop", "path.scallop_mm = " + text(options.scallop_mm) +
                                         ": it must lie below the radius that the cutter shows across the feed, " +
                                         text(radius_mm) + " mm");
  if (!(options.tolerance_mm > 0.0))
    return bad_input("path-tolerance", "path.tolerance_mm = " + text(options.tolerance_mm) + ": it must be above 0");
  if (options.from_turn && options.to_turn && *options.from_turn >= *options.to_turn)
    return bad_input("path-turns", "path.from_turn = " + text(*options.from_turn) +
                                       " is not below path.to_turn = " + text(*options.to_turn));
  const bool guided = options.strategy == Strategy::spiral || options.strategy == Strategy::contour_parallel;
  if (!guided && (options.from_turn || options.to_turn))
    return bad_input("path-turns",
                     "path.from_turn and path.to_turn work with the strategies spiral and contour-parallel only");
  if (options.start_P_mm && (!guided || options.from_turn || options.to_turn))
    return bad_input("path-start",
                     "path.start_mm works with the strategies spiral and contour-parallel, on the whole surface: leave "
                     "out path.from_turn and path.to_turn");
  return {};
}

/// geometry::machinable_surface refuses these too; a caller that skipped it hears why here.
Result<SurfaceReport> check_surface(const geometry::TriangleMesh& surface) {
  const auto topology = MeshTopology::build(surface);
  if (!topology) return tl::unexpected(topology.error());
  const auto& components = topology->components();
  if (components.size() != 1)
    return bad_input("surface-several-components", "the surface has " + std::to_string(components.size()) +
                                                       " components: a path covers one; choose one of them");
  if (components[0].handles > 0)
    return bad_input("surface-handles",
                     "the surface has " + std::to_string(components[0].handles) + " handles: cut it into patches");
  if (topology->boundary_loops().empty())
    return bad_input("surface-closed",
                     "the surface has no boundary: a path has nowhere to start; cut it open or select a patch");
  SurfaceReport report;
  report.triangles = static_cast<int>(surface.triangles.size());
  report.boundary_loops = static_cast<int>(topology->boundary_loops().size());
  report.area_mm2 = geometry::area_mm2(surface);
  return report;
}

/// Takes the even spiral to the start that the user wants, and says what it costs.
Result<void> begin_even_at(const geometry::TriangleMesh& surface, const PathOptions& options, CcPathResult& result) {
  if (!options.start_P_mm || result.path.pieces.empty()) return {};
  const auto topology = MeshTopology::build(surface);
  if (!topology) return tl::unexpected(topology.error());
  const double added_mm = begin_at(result.path.pieces[0], surface, *topology, *options.start_P_mm, options.direction,
                                   sense_of(options.cut_direction));
  if (added_mm > 0.0)
    result.report.notes.push_back("even: " + geometry::short_text(added_mm, 4) +
                                  " mm along the first pass lead from path.start_mm to where the spiral begins");
  return {};
}

/// Turns beside a floating hole differ by more than one across it, so that intervals cannot be told from turn to turn:
/// the interval that leaves the greatest scallop measured, over the allowed one. Nothing where that place is uncut.
std::optional<double> interval_of_scallop(const PathReport& report, const IntervalRule& rule) {
  const double height_mm = report.scallop_ratio_max.value_or(0.0) * rule.scallop_mm;
  if (height_mm <= 0.0 || height_mm >= rule.radius_mm) return {};
  return path_interval_mm(rule.radius_mm, height_mm, 0.0) / path_interval_mm(rule.radius_mm, rule.scallop_mm, 0.0);
}

/// The even spiral with its curve finished, and what it is worth.
struct Finished {
  CcPath path;
  PathReport report;
  std::optional<ScallopMap> scallop;
};
Finished measured_even(const MeasureRequest& request, const PathReport& raw, CcPath path) {
  Finished out{std::move(path), {}, {}};
  out.report.strategy = "spiral";
  out.report.method = "even";
  out.report.liftings = 2;
  out.report.notes = raw.notes;
  out.report.rapid_traversals = static_cast<int>(out.path.pieces.size()) - 1;
  out.scallop = measure_path(request, out.path, out.report);
  out.report.interval_ratio_max = interval_of_scallop(out.report, request.intervals.rule());
  return out;
}

/// The spline does not keep to every bend: where it leaves a single place too high, its points are moved.
Finished mended_even(const MeasureRequest& request, std::span<const Vec3> vertex_normals, Finished best) {
  constexpr int nudges_max = 6, failures_max = 2;
  constexpr double kept = 1.06, mended_from = 1.04;
  constexpr std::size_t places_max = 400;
  const double interval_mm = request.intervals.rule().interval_mm(0.0);
  const auto operators = triangle_operators(request.surface);
  Finished now = best;
  for (int n = 0, failures = 0; n < nudges_max && failures < failures_max; ++n) {
    if (!now.scallop || best.scallop->statistics.max_ratio <= kept) break;
    const auto places = high_places(*now.scallop, mended_from, 0.5 * interval_mm);
    if (places.size() > places_max) break;
    CcPath path = now.path;
    for (CcPiece& piece : path.pieces)
      nudge_finished(piece, places, interval_mm, request.surface, vertex_normals, operators);
    now = measured_even(request, now.report, std::move(path));
    if (now.report.scallop_ratio_max < best.report.scallop_ratio_max)
      best = now;
    else
      ++failures;
  }
  return best;
}

/// The same, looked at closely and mended where that finds too much.
Result<Finished> verdict_even(const MeasureRequest& request, std::span<const Vec3> vertex_normals, Finished best) {
  if (!best.scallop) return best;
  auto mended =
      mended_closely(request.surface, vertex_normals, std::move(best.path), *best.scallop, request.intervals.rule());
  if (!mended) return tl::unexpected(mended.error());
  best.path = std::move(mended->path);
  if (mended->moved) best = measured_even(request, best.report, std::move(best.path));
  best.report.scallop_ratio_p9999 = mended->scallop.p9999_ratio;
  best.report.scallop_ratio_max = mended->scallop.max_ratio;
  best.report.scallop_area_above_percent = mended->scallop.area_above_percent;
  best.report.interval_ratio_max = interval_of_scallop(best.report, request.intervals.rule());
  return best;
}

/// The optimised field, finished as the other methods are; plan_even_spiral runs inward and counter-clockwise.
Result<CcPathResult> plan_even(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                               const PathOptions& options, const OrientationOptions& orientation) {
  const bool mirror_image = sense_of(options.cut_direction) == Sense::clockwise;
  Result<CcPathResult> result{};
  std::optional<IntervalField> measured_intervals;  // what the finished path is measured by waits for nothing
  std::vector<Vec3> normals;
  tbb::parallel_invoke(
      [&] { result = plan_even_spiral(mirror_image ? mirrored(surface) : surface, cutter, options, orientation); },
      [&] {
        measured_intervals.emplace(surface, interval_rule(cutter, options.scallop_mm, orientation));
        normals = geometry::vertex_normals(surface);
      });
  if (!result) return result;
  if (mirror_image) mirror(*result);
  if (auto begun = begin_even_at(surface, options, *result); !begun) return tl::unexpected(begun.error());
  const IntervalField& intervals = *measured_intervals;
  const CurveOptions curve = curve_options(cutter, options, orientation, intervals.rule());
  for (CcPiece& piece : result->path.pieces) {
    std::vector<RawStretch> stretches{{raw_points(piece.points), false}};
    if (auto kept = keep_turns(stretches, options); !kept) return tl::unexpected(kept.error());
    piece = finished_piece(std::move(stretches), options, curve);
  }
  ScallopMeter meter = scallop_meter(surface, normals, intervals.rule());
  const MeasureRequest request{surface, intervals, {}, false, !options.from_turn && !options.to_turn, &meter};
  auto best = verdict_even(
      request, normals, mended_even(request, normals, measured_even(request, result->report, std::move(result->path))));
  if (!best) return tl::unexpected(best.error());
  result->path = std::move(best->path);
  result->report = std::move(best->report);
  return result;
}

/// Where the optimised field cannot hold one piece, the periodic one with a word on why.
Result<CcPathResult> even_or_periodic(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                      const PathOptions& options, const OrientationOptions& orientation) {
  auto even = plan_even(surface, cutter, options, orientation);
  if (even || even.error().code == "path-turns") return even;
  PathOptions periodic = options;
  periodic.method = Method::periodic;
  auto result = plan_guided_path(surface, cutter, periodic, orientation);
  if (result)
    result->report.notes.insert(result->report.notes.begin(),
                                "even: " + even.error().message + "; method periodic took its place");
  return result;
}

Result<CcPathResult> plan_by_strategy(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                      const PathOptions& options, const OrientationOptions& orientation) {
  switch (options.strategy) {
    case Strategy::spiral:
      if (options.method == Method::even) return even_or_periodic(surface, cutter, options, orientation);
      return plan_guided_path(surface, cutter, options, orientation);
    case Strategy::contour_parallel:
      return plan_guided_path(surface, cutter, options, orientation);
    case Strategy::projected_spiral:
      return plan_projected_spiral(surface, cutter, options, orientation);
    case Strategy::contour_offset:
      return plan_contour_offset(surface, cutter, options, orientation);
    case Strategy::iso_planar:
      return plan_iso_planar(surface, cutter, options, orientation);
  }
  return bad_input("path-strategy", "path.strategy: no such strategy");
}

}  // namespace

Result<CcPathResult> plan_cc_path(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                  const PathOptions& options, const OrientationOptions& orientation) {
  if (auto checked = check_options(cutter, options, orientation); !checked) return tl::unexpected(checked.error());
  const auto report = check_surface(surface);
  if (!report) return tl::unexpected(report.error());
  auto result = plan_by_strategy(surface, cutter, options, orientation);
  if (!result) return result;
  result->surface.triangles = report->triangles;
  result->surface.boundary_loops = report->boundary_loops;
  result->surface.area_mm2 = report->area_mm2;
  return result;
}

}  // namespace volute::planner
