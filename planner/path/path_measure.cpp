#include "planner/path/path_measure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/mesh_measure.hpp"
#include "planner/path/interval_measure.hpp"
#include "planner/path/point_grid.hpp"
#include "planner/path/scallop_map.hpp"

namespace volute::planner {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double samples_per_interval = 16.0;  ///< for corners
constexpr int scallop_samples_per_edge = 3;
constexpr double exact_from_ratio = 0.7;  ///< of the scallops; triangles over it are looked at more closely

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Angle between the chords of `window` samples before and behind sample i.
double turning_at(std::span<const Vec3> points, std::size_t i, std::size_t window) {
  return angle_between(points[i] - points[i - window], points[i + window] - points[i]);
}

double piece_length_mm(const CcPiece& piece) {
  double length = 0.0;
  for (std::size_t i = 1; i < piece.points.size(); ++i)
    length += (piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm).norm();
  return length;
}

/// Largest direction change at the places where the path crosses the map's seam, deg.
double seam_kink_deg(std::span<const Vec3> crossings, std::span<const Vec3> points, double spacing_mm,
                     std::size_t window) {
  const PointGrid grid(points, 4.0 * spacing_mm);
  double worst = 0.0;
  for (const Vec3& crossing : crossings) {
    std::optional<std::size_t> nearest;
    grid.near(crossing, 4.0 * spacing_mm, [&](Index i) {
      const auto k = static_cast<std::size_t>(i);
      if (!nearest || (points[k] - crossing).squaredNorm() < (points[*nearest] - crossing).squaredNorm()) nearest = k;
    });
    if (nearest && *nearest >= window && *nearest + window < points.size())
      worst = std::max(worst, turning_at(points, *nearest, window));
  }
  return worst / degree;
}

/// Greatest distance from a turn to the next one over the interval allowed between them.
double interval_ratio_max(const TriangleMesh& surface, const IntervalField& intervals, const CcPath& path) {
  double worst = 0.0, turns_max = 0.0;
  for (const CcPiece& piece : path.pieces)
    for (const CcPoint& p : piece.points) turns_max = std::max(turns_max, p.turn);
  // The first turn's start and the last turn have no whole turn beside them.
  for (const IntervalSample& sample : interval_samples(surface, intervals, path))
    if (sample.turn >= 0.05 && sample.turn <= turns_max - 1.05) worst = std::max(worst, sample.ratio);
  return worst;
}

/// Low heights are asked for exactly only where there are no others to report.
ScallopMap measured_scallop(const MeasureRequest& request, const CcPath& path) {
  const IntervalRule& rule = request.intervals.rule();
  const bool again = request.meter != nullptr;
  std::vector<Vec3> normals;
  if (!again) normals = geometry::vertex_normals(request.surface);
  ScallopMap scallop =
      again ? request.meter->measure(path) : scallop_meter(request.surface, normals, rule).measure(path);
  if (scallop.statistics.p9999_ratio > exact_from_ratio) return scallop;
  if (again) normals = geometry::vertex_normals(request.surface);
  return measure_scallop(request.surface, normals, path, rule.radius_mm, rule.scallop_mm,
                         {.per_edge = scallop_samples_per_edge, .closer_from_ratio = exact_from_ratio});
}

int count_links(const CcPiece& piece) {
  int links = 0;
  for (std::size_t i = 0; i < piece.points.size(); ++i)
    if (piece.points[i].link && (i == 0 || !piece.points[i - 1].link)) ++links;
  return links;
}

}  // namespace

ScallopMeter scallop_meter(const TriangleMesh& surface, std::span<const Vec3> vertex_normals,
                           const IntervalRule& rule) {
  return {surface,
          vertex_normals,
          rule.radius_mm,
          rule.scallop_mm,
          {.per_edge = scallop_samples_per_edge,
           .exact_from_ratio = exact_from_ratio,
           .closer_from_ratio = exact_from_ratio}};
}

std::vector<Vec3> even_points(const CcPiece& piece, double spacing_mm) {
  const double length = piece_length_mm(piece);
  if (piece.points.size() < 2 || length <= 0.0) return {};
  const auto spans = static_cast<std::size_t>(std::ceil(length / spacing_mm));
  std::vector<Vec3> points;
  double behind = 0.0;  // length up to point i - 1
  std::size_t i = 1;
  for (std::size_t k = 0; k <= spans; ++k) {
    const double wanted = length * static_cast<double>(k) / static_cast<double>(spans);
    double chord = (piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm).norm();
    while (i + 1 < piece.points.size() && behind + chord < wanted) {
      behind += chord;
      ++i;
      chord = (piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm).norm();
    }
    const double share = chord > 0.0 ? std::min(1.0, (wanted - behind) / chord) : 0.0;
    points.emplace_back(piece.points[i - 1].point_P_mm +
                        share * (piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm));
  }
  return points;
}

std::vector<double> corner_angles_rad(std::span<const Vec3> even, double spacing_mm, double window_mm,
                                      double least_rad) {
  const auto window = static_cast<std::size_t>(std::max(1L, std::lround(window_mm / spacing_mm)));
  std::vector<double> corners;
  std::size_t last = 0;
  for (std::size_t i = window; i + window < even.size(); ++i) {
    const double angle = turning_at(even, i, window);
    if (angle <= least_rad) continue;
    if (corners.empty() || 2 * (i - last) > window) corners.push_back(angle);
    corners.back() = std::max(corners.back(), angle);
    last = i;
  }
  return corners;
}

std::optional<ScallopMap> measure_path(const MeasureRequest& request, const CcPath& path, PathReport& report) {
  const IntervalRule& rule = request.intervals.rule();
  const double flat_mm = rule.interval_mm(0.0), spacing_mm = flat_mm / samples_per_interval;
  report.pieces = static_cast<int>(path.pieces.size());
  report.lower_bound_mm = request.intervals.lower_bound_mm();
  for (const CcPiece& piece : path.pieces) {
    const std::vector<Vec3> even = even_points(piece, spacing_mm);
    report.length_mm += piece_length_mm(piece);
    report.cc_points += static_cast<int>(piece.points.size());
    report.linkings += count_links(piece);
    for (double angle : corner_angles_rad(even, spacing_mm, 0.5 * flat_mm, 35.0 * degree)) {
      ++report.sharp_corners;
      if (angle > 60.0 * degree) ++report.sharp_corners_60;
    }
    if (!request.seam_crossings_mm.empty())
      report.seam_kink_max_deg =
          std::max(report.seam_kink_max_deg.value_or(0.0),
                   seam_kink_deg(request.seam_crossings_mm, even, spacing_mm, samples_per_interval / 2));
  }
  report.length_ratio = report.length_mm / report.lower_bound_mm;
  if (request.spiral_turns) report.interval_ratio_max = interval_ratio_max(request.surface, request.intervals, path);
  if (!request.whole_surface) {
    report.notes.emplace_back(
        "only a part is machined: the lower bound is that of the whole surface, scallops are not measured");
    return {};
  }
  ScallopMap scallop = measured_scallop(request, path);
  report.scallop_ratio_p9999 = scallop.statistics.p9999_ratio;
  report.scallop_ratio_max = scallop.statistics.max_ratio;
  report.scallop_area_above_percent = scallop.statistics.area_above_percent;
  return scallop;
}

}  // namespace volute::planner
