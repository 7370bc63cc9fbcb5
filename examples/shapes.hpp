// Outlines, height fields and solids that the example parts are made of.
#pragma once

#include "plane_mesher.hpp"

namespace volute::examples {

/// Half of the larger axis of every outline runs along x before `turn` (counter-clockwise) and `centre` are applied.
struct Placement {
  geometry::Vec2 centre = geometry::Vec2::Zero();
  double turn_deg = 0.0;
};

Polygon ellipse(double half_x_mm, double half_y_mm, const Placement& place = {});
Polygon rounded_rectangle(double width_mm, double height_mm, double corner_mm, const Placement& place = {});
/// |x / a|^p + |y / b|^p = 1.
Polygon superellipse(double half_x_mm, double half_y_mm, double power);
/// A circle whose radius swings `lobes` times by the given share.
Polygon lobed_circle(double radius_mm, double share, int lobes, const Placement& place = {});

/// The freeform plates: a long wave, a hill of 7 mm and a hollow of 5 mm; |curvature| < 0.1 / mm.
double freeform_height_mm(double x_mm, double y_mm);
/// A ripple that runs round the centre.
double wavy_height_mm(double x_mm, double y_mm);

/// Closed solids with the outside outwards, as obstacles.
geometry::TriangleMesh box(const geometry::Vec3& least_mm, const geometry::Vec3& greatest_mm);
geometry::TriangleMesh cylinder(const geometry::Vec3& base_mm, const geometry::Vec3& axis, double radius_mm,
                                double length_mm);

}  // namespace volute::examples
