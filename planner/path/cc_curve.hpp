// From a chain of raw points on the surface to the CC points that the tool visits: B-spline, normals, step-forward.
#pragma once

#include <span>
#include <vector>

#include "geometry/angle.hpp"
#include "planner/path/cc_path.hpp"
#include "planner/path/path_interval.hpp"

namespace volute::planner {

/// A point of a traced path. `edge_tangent`: direction of the curve of the edge that was crossed ([Sun2016] r'(t)), for
/// the normal of eq. 19; zero: the normal given is kept.
struct RawPoint {
  Vec3 point_mm = Vec3::Zero(), normal = Vec3::UnitZ();
  double turn = 0.0;
  Vec3 edge_tangent = Vec3::Zero();
};

struct CurveOptions {
  double tolerance_mm = 0.01;  ///< of the path that the tool really takes
  double step_max_mm = 1.0;    ///< between CC points
  double radius_mm = 3.0;      ///< of the ball (or corner) that runs along the surface
  geometry::Angle tilt, yaw;   ///< of the tool axis to normal and feed, for the tip's path
};
CurveOptions curve_options(const kinematics::Cutter& cutter, const PathOptions& path,
                           const OrientationOptions& orientation, const IntervalRule& rule);

/// One smooth stretch. A cubic B-spline (eq. 18) is fitted to the raw points, its knots halved where a point lies off
/// it by more than the tolerance (a quarter of it along the normal), down to a fifth of the median spacing. CC points
/// are taken from it so far apart as the tolerance allows: the chord between two centres of the ball, plus what turning
/// the axis between them adds, keeps to the curve of centres.
/// Requires: two points apart at least. Properties: 1. First and last points are the raw ones. 2. No step is longer
/// than step_max_mm, none shorter than a fiftieth of it unless the whole stretch is. 3. Normals are unit.
std::vector<CcPoint> smooth_curve(std::span<const RawPoint> raw, const CurveOptions& options);

/// The raw points of a CC piece, for smooth_curve.
std::vector<RawPoint> raw_points(std::span<const CcPoint> points);

}  // namespace volute::planner
