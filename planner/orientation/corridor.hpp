// Past [Sun2016]: a chain of allowed orientations first, then the smoothest curve in the corridor round it.
#pragma once

#include <optional>
#include <vector>

#include "planner/orientation/allowed_set.hpp"
#include "planner/orientation/corridor_smoother.hpp"
#include "planner/orientation/orient.hpp"

namespace volute::planner {

struct CorridorResult {
  std::vector<Rotaries> at;  ///< at every station; empty: there is no chain
  std::vector<int> empty;    ///< stations where nothing is allowed, by search 0.5 degrees apart
  int stuck = -1;            ///< without such a station: the first that no lattice reached from those before
  int iterations = 0;
  double solve_s = 0.0;
  int layers = 0, layers_opened = 0;
};

/// 1. The cheapest chain of allowed nodes of a lattice in both rotaries, as coefficients of a cubic B-spline.
///    Interference is looked at only in layers where the chain so far touches; the lattice is refined twice where it is
///    too coarse.
/// 2. The smoothest spline (velocity, acceleration, jerk per arc length, turn to the neighbouring passes) with its
///    coefficients bounded; where it is not allowed, the bounds draw back to the chain, which is; then once more round
///    the result.
/// It ends always. Properties: 1. Every point and every motion of a result is allowed (check_path). 2. Same input, same
/// bytes. 3. A station is in `empty` only if exhaustive_search finds nothing there.
CorridorResult run_corridor(const AllowedSet& allowed, const std::vector<Vec3>& preferred);

/// A curve as good as `at` or better in each of the six peaks: the same smoothing from `at` on, with velocity,
/// acceleration and jerk of both rotaries limited to its peaks and priced, and `held` stations held. `at` itself where
/// none better was found. Requires: at is allowed.
CorridorResult lower_peaks(const AllowedSet& allowed, const std::vector<Rotaries>& at,
                           const std::vector<HeldStation>& held);

/// The mean of `at` along the whole path, where that is allowed: no peaks at all.
std::optional<std::vector<Rotaries>> standing_still(const AllowedSet& allowed, const std::vector<Rotaries>& at);

using RotaryPeaks = std::array<AxisMotionPeaks, 2>;

/// Peaks of both rotaries at a feed of 1 mm/s, that is per arc length.
RotaryPeaks peaks_per_mm(const AllowedSet& allowed, const std::vector<Rotaries>& at);
/// Is none of the six peaks of `a` above that of `b` by more than a billionth of it (or of 1 rad, at the step of 1 mm)?
bool no_peak_above(const RotaryPeaks& a, const RotaryPeaks& b);

}  // namespace volute::planner
