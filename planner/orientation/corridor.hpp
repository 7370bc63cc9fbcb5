// Past [Sun2016]: a chain of allowed orientations first, then the smoothest curve in the corridor round it.
#pragma once

#include <vector>

#include "planner/orientation/allowed_set.hpp"
#include "planner/orientation/rotary_spline.hpp"

namespace volute::planner {

struct CorridorResult {
  std::vector<Rotaries> at;  ///< at every station; empty: there is no chain
  std::vector<int> stuck;    ///< stations where no orientation is allowed, or none that can be reached from before
  bool stuck_empty = false;  ///< at them nothing is allowed at all, by search 2 degrees apart
  int iterations = 0;
  double solve_s = 0.0;
  int layers = 0, layers_opened = 0;
};

/// 1. The cheapest chain of allowed nodes of a lattice in both rotaries, as coefficients of a cubic B-spline.
/// Interference is looked at only in
///    layers where the chain so far touches, all their nodes then; the lattice is refined twice where it is too coarse.
/// 2. The smoothest spline (velocity, acceleration, jerk per arc length) with its coefficients bounded; where it is not
/// allowed, the
///    bounds draw back to the chain, which is; then once more round the result.
/// It ends always. Properties: 1. Every point and every motion of a result is allowed (check_path). 2. Same input, same
/// bytes.
CorridorResult run_corridor(const AllowedSet& allowed, const std::vector<Vec3>& preferred);

}  // namespace volute::planner
