// Where the picture is taken from: an orthographic camera that fits a box.
#pragma once

#include "geometry/vector.hpp"

namespace volute::view {

using geometry::Vec2;
using geometry::Vec3;

struct Box {
  Vec3 least = Vec3::Constant(1e300), greatest = Vec3::Constant(-1e300);
};
void grow(Box& box, const Vec3& point);

struct Camera {
  Vec3 target = Vec3::Zero();
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), towards_viewer = Vec3::UnitZ();
  double half_height = 1.0;  ///< of the picture, in mm
  double half_depth = 1.0;
  double aspect = 4.0 / 3.0;  ///< width over height
};

/// Looks from `towards_viewer` (any length) with z upward in the picture (y when looking along z), so that `box` fills
/// the picture but for `margin` (share of its size).
Camera fit_camera(const Box& box, const Vec3& towards_viewer, double aspect, double margin = 0.08);

/// Pixel of a point: x to the right, y down, in a picture of width x height.
Vec2 project(const Camera& camera, const Vec3& point, int width, int height);

}  // namespace volute::view
