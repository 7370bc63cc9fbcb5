// A field found on a coarse mesh as the start on a fine one.
#pragma once

#include <span>
#include <vector>

#include "planner/path/cc_path.hpp"
#include "planner/path/even_domain.hpp"
#include "planner/path/even_field.hpp"

namespace volute::planner {

/// Each fine vertex takes phi from the nearest point of the nearest coarse triangle, each fine triangle direction and
/// dual from the triangles nearest to its corners. Float levels are not carried over: theta is another on another mesh.
/// Requires: two domains of one surface with the same centre. Deterministic.
EvenField prolonged(const EvenDomain& coarse, const EvenField& field, const EvenDomain& fine);

/// Points of a mesh nearest to places near it, with the vertex normals' mean there; turns are left at 0.
std::vector<CcPoint> on_mesh(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals,
                             const std::vector<TriangleOperator>& operators, std::span<const Vec3> places_mm);

/// The path with each point moved to the nearest point of the surface, with the normal there. Requires: the path lies
/// near it.
CcPath on_surface(const EvenSurface& surface, const CcPath& path);

/// Turns theta by a constant so that phi - theta on the floating holes comes nearest to whole numbers, where path
/// levels stand midway, and returns those whole numbers.
HeldLevels settled_levels(EvenDomain& domain, const EvenField& field);

}  // namespace volute::planner
