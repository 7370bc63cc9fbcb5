// Triangles of even size in a plane region with holes, to be lifted onto a surface afterwards.
#pragma once

#include <vector>

#include "geometry/mesh.hpp"

namespace volute::examples {

using Polygon = std::vector<geometry::Vec2>;

/// The region inside `outer` and outside every hole. Polygons are closed (last joins first), in either sense, and do
/// not meet.
struct PlaneRegion {
  Polygon outer;
  std::vector<Polygon> holes;
};

/// Points at even spacing, about `spacing_mm`, along the polygon; corners sharper than 40 degrees are kept.
Polygon resampled(const Polygon& polygon, double spacing_mm);

struct PlaneMesh {
  std::vector<geometry::Vec2> points_mm;
  std::vector<geometry::Triangle> triangles;  ///< counter-clockwise
};

/// Equilateral lattice inside, resampled polygons on the boundary, a constrained Delaunay triangulation over both;
/// every angle is at least 20 degrees but where the boundary itself has a sharper one.
PlaneMesh mesh_plane(const PlaneRegion& region, double edge_mm);

}  // namespace volute::examples
