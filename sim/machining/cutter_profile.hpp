// The cutter as a convex solid of revolution: exact signed distance, and where a line enters it.
#pragma once

#include <optional>

#include "geometry/vector.hpp"
#include "kinematics/model/tool.hpp"

namespace volute::sim {

using geometry::Vec2;
using geometry::Vec3;

/// Half section of a cutter in (radius, z), z from the tip along the axis: a flat bottom to `flat_end`, an arc about
/// `arc_centre`, a straight flank from `flank_start` to `flank_end`, and the flat top. Every cutter of
/// `kinematics::Cutter` is one. Properties: 1. The solid is convex, so the signed distance is convex along every
/// line. 2. |gradient| == 1.
class CutterProfile {
 public:
  /// Requires: a cutter that kinematics::validate accepts.
  explicit CutterProfile(const kinematics::Cutter& cutter);

  /// Signed distance (negative inside) of a point given by its distance from the axis and its height over the tip, and
  /// the unit direction in (radius, z) in which that distance grows.
  struct Distance {
    double value_mm = 0.0;
    Vec2 gradient = Vec2::UnitX();
  };
  [[nodiscard]] Distance distance(double radius_mm, double z_mm) const;

  [[nodiscard]] double greatest_radius_mm() const { return flank_end_.x(); }
  [[nodiscard]] double length_mm() const { return flank_end_.y(); }
  [[nodiscard]] Vec2 flank_start() const { return flank_start_; }
  [[nodiscard]] double corner_radius_mm() const { return arc_radius_; }

  /// The deepest point of the solid in the direction whose component along the axis is `along_axis` (unit direction;
  /// the rest points away from the axis): its (radius, z).
  [[nodiscard]] Vec2 support(double along_axis) const;

 private:
  [[nodiscard]] bool inside(double radius_mm, double z_mm) const;
  Vec2 flat_end_, arc_centre_, flank_start_, flank_end_;
  double arc_radius_ = 0.0;
};

/// A cutter that stands still: tip and unit axis.
struct StandingCutter {
  Vec3 tip_mm = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};

/// The least height t on the line point + t * direction (unit) at which the cutter begins, when the cutter holds some
/// point with 0 <= t <= limit_mm; nothing otherwise. The result is negative where `point` itself lies inside. Newton's
/// iteration on a convex function from outside: it never passes the root. Accuracy: 1e-9 mm.
std::optional<double> line_entry_mm(const CutterProfile& profile, const StandingCutter& cutter, const Vec3& point_mm,
                                    const Vec3& direction, double limit_mm);

}  // namespace volute::sim
