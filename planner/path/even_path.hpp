// From the field to the path: level lines of phi - theta, half a turn along the boundary before them, a closing loop
// after them.
#pragma once

#include <string>
#include <vector>

#include "planner/path/cc_path.hpp"
#include "planner/path/even_domain.hpp"
#include "planner/path/even_field.hpp"
#include "planner/surface/surface_path.hpp"

namespace volute::planner {

/// A point of the path on the domain's mesh: `share` of the way from one place on a triangle's rim to another.
struct EvenPathPoint {
  SurfacePoint place;
  double turn = 0.0;  ///< phi there
  SurfacePoint toward;
  double share = 0.0;  ///< 0: at `place`; `toward` is not used
};

/// The path inward: along the outer boundary, the spiral, its end. Around a hole or a slit that branches the end is a
/// closing loop half an interval before it; a slit without branches is entered and run along (see even_ending.hpp).
struct EvenPath {
  std::vector<EvenPathPoint> points;
  std::vector<Vec3> ending_mm;  ///< behind `points`, near the surface: into the slit and along it
  double ending_turn = 0.0;     ///< phi at its end
  int splices = 0;              ///< rings that folds left, run between two points of another pass
  int pieces = 1;               ///< 1, or how many chains the field fell into: then it is no spiral
};

/// Traces phi - theta at Z + 1/2. [Sun2016] eq. 11 departs here: the guide line is a level line of the field, the
/// increment is 1, and half a turn along the outer boundary comes first, so that no wedge stays uncut (errata to eq.
/// 11). `interval_mm`: on flat ground.
EvenPath even_path(const EvenDomain& domain, const EvenField& field, double interval_mm);

/// Positions and normals of the path as one CC piece.
CcPath cc_path_of(const EvenDomain& domain, const EvenPath& path);

}  // namespace volute::planner
