// The allowed path interval everywhere on the surface, in every direction across the feed.
#pragma once

#include <vector>

#include "geometry/mesh_measure.hpp"
#include "kinematics/model/tool.hpp"
#include "planner/options.hpp"

namespace volute::planner {

using geometry::Index;
using geometry::Mat3;
using geometry::TriangleMesh;

/// How wide a cutter may step: path_interval_mm with its effective radius, and never wider than the cutter itself.
struct IntervalRule {
  double radius_mm = 3.0;  ///< of the ball that clears as wide, see clearing_radius_mm
  double scallop_mm = 0.1;
  double interval_max_mm = 6.0;
  /// 1 + curvature * radius is taken as at least this: where the surface is hollow and nearly as tight as the cutter,
  /// or tighter, the formula has no bound (and the cutter gouges, which the interference check reports).
  static constexpr double fit_min = 0.2;

  /// Allowed interval where the normal curvature across the feed is `curvature_per_mm` (convex positive).
  [[nodiscard]] double interval_mm(double curvature_per_mm) const;
};

/// The radius comes from the cutter's outline at scallop height, by tilt and yaw: on a plane the interval is exact for
/// every cutter. The interval is at most 0.9 of the cutter's diameter.
/// Requires: 0 < scallop, tilt below 90 degrees; for its use also scallop < radius (plan_cc_path checks it).
IntervalRule interval_rule(const kinematics::Cutter& cutter, double scallop_mm, const OrientationOptions& orientation);

/// The rule on every triangle of a mesh. Curvature: averaged tensor, geometry::triangle_curvature.
class IntervalField {
 public:
  IntervalField(const TriangleMesh& mesh, const IntervalRule& rule);
  /// The same with the mesh's geometry::triangle_curvature.
  IntervalField(const TriangleMesh& mesh, const IntervalRule& rule, std::vector<Mat3> curvature);

  [[nodiscard]] const IntervalRule& rule() const { return rule_; }
  /// Allowed interval where the next pass lies in this direction. Requires: unit tangent.
  [[nodiscard]] double interval_mm(Index triangle, const Vec3& across) const {
    const Mat3& tensor = tensor_[static_cast<std::size_t>(triangle)];
    return rule_.interval_mm(across.dot(tensor * across));
  }
  /// In the most favourable direction: no path can be wider.
  [[nodiscard]] double widest_interval_mm(Index triangle) const {
    return widest_mm_[static_cast<std::size_t>(triangle)];
  }
  /// In the least favourable direction.
  [[nodiscard]] double narrowest_interval_mm(Index triangle) const {
    return narrowest_mm_[static_cast<std::size_t>(triangle)];
  }
  /// The sum of area over widest interval: no path that keeps the scallop is shorter (up to the ends).
  [[nodiscard]] double lower_bound_mm() const { return lower_bound_mm_; }
  /// Share of the area whose hollow is tighter than the cutter.
  [[nodiscard]] double too_tight_share() const { return too_tight_share_; }

 private:
  IntervalRule rule_;
  std::vector<Mat3> tensor_;
  std::vector<double> widest_mm_, narrowest_mm_;
  double lower_bound_mm_ = 0.0, too_tight_share_ = 0.0;
};

}  // namespace volute::planner
