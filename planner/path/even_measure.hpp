// Measures of a CC path that need no field.
#pragma once

#include "geometry/angle.hpp"
#include "planner/path/cc_path.hpp"

namespace volute::planner {

/// Sum of the chords between the CC points of each piece, mm.
double path_length_mm(const CcPath& path);

/// Places where the path turns by more than `angle` between the chords of `chord_mm` arc length before and after;
/// places less than a chord apart count once. Sampled at an eighth of a chord.
int sharp_corners(const CcPath& path, double chord_mm, geometry::Angle angle);

}  // namespace volute::planner
