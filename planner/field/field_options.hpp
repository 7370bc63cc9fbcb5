// What the user asks of an orientation field: the job file's [field].
#pragma once

#include "planner/field/radial_basis.hpp"

namespace volute::planner {

/// Where the parameters of a mesh come from, and with them the distance.
enum class FieldPlacement {
  straight,  ///< no parameters: straight distance in mm
  box,       ///< open surface: u and v are x and y over the bounding box; distance in (u, v)
  cylinder,  ///< half-open surface round the z axis: u is the height over the box, v the angle; geodesic distance on
             ///< the cylinder
};

struct FieldOptions {
  RadialBasis basis{BasisKind::inverse_multiquadric, 0.0, 1.0,
                    2};  ///< a = 0: three spacings of the keys (Gaussian: two)
  FieldPlacement placement = FieldPlacement::straight;
  bool spline = false;  ///< RBF-spline approximation; needs parameters (box or cylinder)
  int u_intervals = 30, v_intervals = 10;
};

}  // namespace volute::planner
