#include "planner/path/guided_path.hpp"

#include <algorithm>

#include "geometry/mesh_measure.hpp"
#include "geometry/number_text.hpp"
#include "planner/path/guide_field.hpp"
#include "planner/path/path_measure.hpp"
#include "planner/path/spiral.hpp"

namespace volute::planner {

namespace {

MapDrawing drawing_of(const Annulus& annulus, const GuideField& field, const GuidePath& path) {
  MapDrawing drawing{field.map, annulus.sheet.triangles, path.map_lines, {}};
  for (const Bridge& bridge : annulus.bridges) {
    drawing.bridges_P.emplace_back();
    for (Index v : bridge.vertices)
      drawing.bridges_P.back().push_back(annulus.whole.vertices_mm[static_cast<std::size_t>(v)]);
  }
  return drawing;
}

/// Share of the area in triangles with an edge longer than one and a half intervals: levels are linear inside a
/// triangle, so that passes there cannot follow what each turn needs.
double coarse_share(const TriangleMesh& mesh, double interval_mm) {
  double coarse_mm2 = 0.0, area_mm2 = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto corner = [&](std::size_t k) { return mesh.vertices_mm[static_cast<std::size_t>(mesh.triangles[t][k])]; };
    const double longest_mm =
        std::max({(corner(1) - corner(0)).norm(), (corner(2) - corner(1)).norm(), (corner(0) - corner(2)).norm()});
    const double triangle_mm2 = geometry::triangle_area_mm2(mesh, static_cast<Index>(t));
    area_mm2 += triangle_mm2;
    if (longest_mm > 1.5 * interval_mm) coarse_mm2 += triangle_mm2;
  }
  return coarse_mm2 / area_mm2;
}

void note_surface(const Annulus& annulus, const IntervalField& intervals, std::vector<std::string>& notes) {
  notes.insert(notes.end(), annulus.notes.begin(), annulus.notes.end());
  if (annulus.centre_is_slit)
    notes.emplace_back("the surface has no hole: the spiral ends in a slit along its deepest ridge");
  if (intervals.too_tight_share() > 0.0)
    notes.push_back(geometry::short_text(100.0 * intervals.too_tight_share(), 2) +
                    " % of the area is hollow and tighter than the cutter");
  const double coarse = coarse_share(annulus.whole, intervals.rule().interval_mm(0.0));
  if (coarse > 0.01)
    notes.push_back(geometry::short_text(100.0 * coarse, 2) +
                    " % of the area has triangles longer than 1.5 intervals: the map spaces passes evenly inside a "
                    "triangle, scallops may be higher; refine the mesh or take method even");
}

}  // namespace

Result<CcPathResult> plan_guided_path(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                      const PathOptions& options, const OrientationOptions& orientation) {
  AnnulusOptions annulus_options;
  annulus_options.centre_loop = options.centre_loop;
  annulus_options.root_child = options.root_child;
  const auto annulus = make_annulus(surface, annulus_options);
  if (!annulus) return tl::unexpected(annulus.error());
  const IntervalField intervals(annulus->whole, interval_rule(cutter, options.scallop_mm, orientation));
  const bool paper = options.method == Method::paper, spiral = options.strategy == Strategy::spiral;
  const auto field = paper ? paper_guide(*annulus, intervals) : periodic_guide(*annulus, intervals);
  if (!field) return tl::unexpected(field.error());
  const GuideOptions guide{sense_of(options.cut_direction), options.start_P_mm, options.direction,
                           0.25 * options.scallop_mm};
  auto path = spiral ? spiral_of(*annulus, *field, guide) : contours_of(*annulus, *field, guide);
  if (!path) return tl::unexpected(path.error());
  if (auto kept = keep_turns(path->stretches, options); !kept) return tl::unexpected(kept.error());
  CcPathResult result;
  result.report.strategy = spiral ? "spiral" : "contour-parallel";
  result.report.method = paper ? "paper" : "periodic";
  note_surface(*annulus, intervals, result.report.notes);
  result.report.notes.insert(result.report.notes.end(), field->notes.begin(), field->notes.end());
  if (options.method == Method::even && !spiral)
    result.report.notes.emplace_back(
        "contour-parallel: method even has no closed passes around floating holes; periodic took its place");
  if (path->lines_dropped > 0)
    result.report.notes.push_back(std::to_string(path->lines_dropped) +
                                  " closed level lines beside the spiral were left out");
  result.surface.map_flips = field->quality.flips;
  result.surface.map_quasi_conformal_error = field->quality.quasi_conformal_error;
  result.map = drawing_of(*annulus, *field, *path);
  result.path.pieces.push_back(finished_piece(std::move(path->stretches), options,
                                              curve_options(cutter, options, orientation, intervals.rule())));
  result.report.liftings = 2;
  measure_path({annulus->whole, intervals, path->seam_crossings_mm, spiral, !options.from_turn && !options.to_turn},
               result.path, result.report);
  return result;
}

}  // namespace volute::planner
