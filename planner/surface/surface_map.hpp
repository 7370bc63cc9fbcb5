// Maps of a ring: onto a rectangle with a fixed seam ([Sun2016] section 3), or onto a cylinder without one.
#pragma once

#include <vector>

#include "geometry/result.hpp"
#include "planner/surface/annulus.hpp"
#include "planner/surface/periodic_coordinate.hpp"

namespace volute::planner {

/// How true a map is.
struct MapQuality {
  Index flips = 0;                     ///< triangles with area <= 0 in the map
  double quasi_conformal_error = 0.0;  ///< area-weighted mean of s_max / s_min - 1 of the map's singular values
  bool positive_weights = false;  ///< the cotangent map had flips: negative weights were raised, which forbids them
};

/// Vertices of Annulus::sheet in the rectangle [0, width] x [0, height].
struct RectangleMap {
  std::vector<double> u_mm, v_mm;
  double width_mm = 0.0, height_mm = 0.0;
  MapQuality quality;
};

/// Harmonic map with the four sides of the sheet on those of a rectangle of mean side lengths, by chord length:
/// [Sun2016] eq. 4-9 with cotangent weights. Errors: as SparseSolver::factor; surface-map-flipped, naming a triangle.
/// Properties: 1. No triangle is flipped. 2. Corners go to corners, eq. 5. 3. On a flat rectangle it is the identity.
Result<RectangleMap> rectangle_map(const Annulus& annulus);

/// Vertices of Annulus::ring on a cylinder: height 0 (outer) to 1 (inner), angle in turns.
struct CylinderMap {
  std::vector<double> height;
  PeriodicCoordinate turn;  ///< grows by one counter-clockwise around the outer boundary (surface on the left)
  MapQuality quality;
};

/// Turns passed along a boundary from its first vertex on, whole turns of the seam taken out of the steps.
/// Requires: neighbours less than half a turn apart.
std::vector<double> turns_along(const std::vector<Index>& loop, const std::vector<double>& turn);

/// Height harmonic with both boundaries fixed, turn harmonic and free at both: together conformal. Where triangles
/// flip, turn is fixed at the boundaries (made monotone) and negative weights are raised. Errors: as rectangle_map.
/// Property: no triangle is flipped; neither coordinate depends on where the seam runs (unless turns had to be fixed).
Result<CylinderMap> cylinder_map(const Annulus& annulus);

}  // namespace volute::planner
