// Boxes and cylinders of machine files as closed meshes. Private to kinematics/model.
#pragma once

#include "geometry/mesh.hpp"
#include "geometry/vector.hpp"

namespace volute::kinematics {

/// Closed, corners counter-clockwise seen from outside. Requires: min < max in every coordinate.
geometry::TriangleMesh box_mesh(const geometry::Vec3& min_mm, const geometry::Vec3& max_mm);
/// A cone frustum from `from_mm` to `to_mm`, its polygon around the circle so that the true body lies inside.
/// Requires: from != to, radii > 0.
geometry::TriangleMesh cone_mesh(const geometry::Vec3& from_mm, const geometry::Vec3& to_mm, double from_radius_mm,
                                 double to_radius_mm);

}  // namespace volute::kinematics
