#include "planner/path/guided_path.hpp"

#include <algorithm>

#include "geometry/number_text.hpp"
#include "planner/path/cc_curve.hpp"
#include "planner/path/guide_field.hpp"
#include "planner/path/path_measure.hpp"
#include "planner/path/spiral.hpp"

namespace volute::planner {

using geometry::bad_input;

namespace {

/// Built from the outside in; reversed for outward. With material on the right the clockwise spindle climbs, either
/// way.
Sense sense_of(CutDirection direction) {
  return direction == CutDirection::climb ? Sense::clockwise : Sense::counter_clockwise;
}

/// Only the part between two turns; boundary half turns and passes outside it go.
Result<void> keep_turns(GuidePath& path, const PathOptions& options, double turn_count) {
  const double from = options.from_turn.value_or(0.0), to = options.to_turn.value_or(turn_count);
  const auto outside = [&](const RawPoint& p) { return p.turn < from - 1e-9 || p.turn > to + 1e-9; };
  std::vector<RawStretch> kept;
  for (RawStretch& stretch : path.stretches) {
    std::erase_if(stretch.points, outside);
    if (stretch.points.size() >= 2 && !(kept.empty() && stretch.link)) kept.push_back(std::move(stretch));
  }
  while (!kept.empty() && kept.back().link) kept.pop_back();
  if (kept.empty())
    return bad_input("path-turns", "no part of the path lies between turns " + geometry::short_text(from) + " and " +
                                       geometry::short_text(to) + ": it has " + geometry::short_text(turn_count) +
                                       " turns");
  path.stretches = std::move(kept);
  return {};
}

void reverse(GuidePath& path) {
  std::reverse(path.stretches.begin(), path.stretches.end());
  for (RawStretch& stretch : path.stretches) std::reverse(stretch.points.begin(), stretch.points.end());
}

CcPiece piece_of(const GuidePath& path, const CurveOptions& options) {
  CcPiece piece;
  for (const RawStretch& stretch : path.stretches) {
    std::vector<CcPoint> points = smooth_curve(stretch.points, options);
    for (CcPoint& p : points) p.link = stretch.link;
    const bool joins =
        !piece.points.empty() && (piece.points.back().point_P_mm - points.front().point_P_mm).norm() < 1e-9;
    piece.points.insert(piece.points.end(), points.begin() + (joins ? 1 : 0), points.end());
  }
  return piece;
}

MapDrawing drawing_of(const Annulus& annulus, const GuideField& field, const GuidePath& path) {
  MapDrawing drawing{field.map, annulus.sheet.triangles, path.map_lines, {}};
  for (const Bridge& bridge : annulus.bridges) {
    drawing.bridges_P.emplace_back();
    for (Index v : bridge.vertices)
      drawing.bridges_P.back().push_back(annulus.whole.vertices_mm[static_cast<std::size_t>(v)]);
  }
  return drawing;
}

void note_surface(const Annulus& annulus, const IntervalField& intervals, std::vector<std::string>& notes) {
  notes.insert(notes.end(), annulus.notes.begin(), annulus.notes.end());
  if (annulus.centre_is_slit)
    notes.emplace_back("the surface has no hole: the spiral ends in a slit along its deepest ridge");
  if (intervals.too_tight_share() > 0.0)
    notes.push_back(geometry::short_text(100.0 * intervals.too_tight_share(), 2) +
                    " % of the area is hollow and tighter than the cutter");
}

}  // namespace

Result<CcPathResult> plan_guided_path(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                      const PathOptions& options, const OrientationOptions& orientation) {
  AnnulusOptions annulus_options;
  annulus_options.centre_loop = options.centre_loop;
  const auto annulus = make_annulus(surface, annulus_options);
  if (!annulus) return tl::unexpected(annulus.error());
  const IntervalField intervals(annulus->whole, interval_rule(cutter, options.scallop_mm, orientation));
  const bool paper = options.method == Method::paper, spiral = options.strategy == Strategy::spiral;
  const auto field = paper ? paper_guide(*annulus, intervals) : periodic_guide(*annulus, intervals);
  if (!field) return tl::unexpected(field.error());
  const Sense sense = sense_of(options.cut_direction);
  auto path = spiral ? spiral_of(*annulus, *field, sense) : contours_of(*annulus, *field, sense);
  if (!path) return tl::unexpected(path.error());
  if (options.from_turn || options.to_turn)
    if (auto kept = keep_turns(*path, options, field->turn_count); !kept) return tl::unexpected(kept.error());
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
  if (options.direction == Direction::outward) reverse(*path);
  result.path.pieces.push_back(piece_of(*path, curve_options(cutter, options, orientation, intervals.rule())));
  result.report.liftings = 2;
  measure_path({annulus->whole, intervals, path->seam_crossings_mm, spiral}, result.path, result.report);
  return result;
}

}  // namespace volute::planner
