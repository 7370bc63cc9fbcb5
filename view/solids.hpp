// Bodies of revolution as meshes, and the moments at which they stand somewhere: tools, and obstacles of formula.
#pragma once

#include <span>

#include "geometry/mesh.hpp"
#include "kinematics/model/tool.hpp"

namespace volute::view {

/// The shell that the profile sweeps about z, from its first point to its last; open where the profile does not begin
/// or end on the axis. For looking at only. Requires: at least 3 sectors.
geometry::TriangleMesh revolution_mesh(std::span<const kinematics::ProfilePoint> profile, int sectors = 48);

/// The mesh with every corner moved.
geometry::TriangleMesh moved_mesh(const geometry::TriangleMesh& mesh, const geometry::Transform& motion);

}  // namespace volute::view
