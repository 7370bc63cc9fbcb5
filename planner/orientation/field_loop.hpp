// The loop of [Huang2016] Fig. 2 on a path: a field through key axes, checked, keys added where it is not allowed,
// until it is.
#pragma once

#include <vector>

#include "geometry/result.hpp"
#include "planner/orientation/allowed_set.hpp"
#include "planner/orientation/pin_loop.hpp"

namespace volute::planner {

struct FieldLoopResult {
  std::vector<Vec3> axes_P;
  int keys = 0, iterations = 0;
  double solve_s = 0.0;
  bool allowed = false;  ///< every point is; motions between points are checked by the caller
};

/// Key axes: those of the options that have a point; `fixed` ones at stations; with none of either, the reference axis
/// at stations evenly spaced. The distance is that of options.field.placement, its parameters laid over the box round
/// the contacts; with options.field.spline the axes are those of the spline through a grid of the interpolation, which
/// meets keys only as nearly as its grid is fine. Errors (bad_input): those of SurfaceField::fit;
/// orientation-field-vanishes.
geometry::Result<FieldLoopResult> run_field_loop(const AllowedSet& allowed, const std::vector<Vec3>& reference,
                                                 const std::vector<FixedPin>& fixed, const OrientationOptions& options);

}  // namespace volute::planner
