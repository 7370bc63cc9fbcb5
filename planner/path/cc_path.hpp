// The path on the surface, before the tool has a direction: CC points with normals, and the measures of the path.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/result.hpp"
#include "kinematics/model/tool.hpp"
#include "planner/options.hpp"

namespace volute::planner {

using geometry::Result;

struct CcPoint {
  Vec3 point_P_mm = Vec3::Zero();
  Vec3 normal_P = Vec3::UnitZ();
  double turn = 0.0;  ///< level of the path field: whole numbers are turns of the spiral
  bool link =
      false;  ///< reached along the surface from the pass before, not as part of a pass (contour-parallel, offset)
};

/// A stretch without a retract.
struct CcPiece {
  std::vector<CcPoint> points;
};

/// More than one piece means rapid traversals between them.
struct CcPath {
  std::vector<CcPiece> pieces;
};

/// report.json "surface" and "path". What a method does not know is left out (nullopt), never made up.
struct SurfaceReport {
  int triangles = 0, boundary_loops = 0;
  double area_mm2 = 0.0;
  std::optional<int> map_flips;
  std::optional<double>
      map_quasi_conformal_error;  ///< area-weighted mean of (s_max/s_min - 1) of the map's singular values
};
struct PathReport {
  std::string strategy, method;
  double length_mm = 0.0, lower_bound_mm = 0.0, length_ratio = 0.0;
  int cc_points = 0, pieces = 0, rapid_traversals = 0, liftings = 0, linkings = 0;
  int sharp_corners = 0;     ///< turns over 35 degrees between chords of half a path interval
  int sharp_corners_60 = 0;  ///< the same over 60 degrees
  std::optional<double> interval_ratio_max, scallop_ratio_p9999, scallop_ratio_max, scallop_area_above_percent,
      seam_kink_max_deg;
  std::vector<std::string> notes;  ///< fallbacks and warnings, each one line
};

/// The map as a drawing: vertex positions in (u, v) and the guide lines there; for pictures.
struct MapDrawing {
  std::vector<geometry::Vec2> vertices;
  std::vector<geometry::Triangle> triangles;
  std::vector<std::vector<geometry::Vec2>> guide_lines;
  std::vector<std::vector<Vec3>> bridges_P;  ///< polylines on the surface
};

struct CcPathResult {
  CcPath path;
  SurfaceReport surface;
  PathReport report;
  MapDrawing map;  ///< empty where the method has no map
};

/// Plans the path of any strategy on a machinable surface (geometry::machinable_surface).
/// Errors (bad_input): surface-*, path-*: what stands in the way, where, and the remedy.
/// Deterministic: the same bytes on any number of threads.
Result<CcPathResult> plan_cc_path(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                  const PathOptions& options, const OrientationOptions& orientation);

/// The exact allowed interval between passes of a ball of radius r for scallop h where the normal curvature across the
/// feed is kappa (1/mm, convex positive): q = (2 r h - h^2) / ((1 + kappa r)(1 + kappa h)), L = 2 sqrt(q) sqrt(1 -
/// kappa^2 q / 4). [Sun2016] eq. 20; departs from the source: exact, not the small-height form. Requires r > 0, 0 < h <
/// r.
double path_interval_mm(double ball_radius_mm, double scallop_mm, double curvature_per_mm);
/// The printed small-height form, eq. 20.
double path_interval_eq20_mm(double ball_radius_mm, double scallop_mm, double curvature_per_mm);

/// Scallop heights by an independent dense measure: for `samples_per_triangle` points the entry of the normal into the
/// union of balls (effective radius) along the path. Used by the closed loop and by tests.
struct ScallopStatistics {
  double p9999_ratio = 0.0, max_ratio = 0.0, area_above_percent = 0.0;
};

}  // namespace volute::planner
