// Sharp places of a traced path, rounded before its scallops are measured.
#pragma once

#include <vector>

#include "planner/path/cc_path.hpp"

namespace volute::planner {

struct RoundingOptions {
  double angle_rad = 1.0;         ///< between chords of half an interval: sharper places are rounded
  double window_intervals = 0.9;  ///< of the path on either side of a corner that may move
  double reach_intervals = 0.2;   ///< half length of the mean that replaces the corner itself
  int rounds = 3;
};

/// The path with its sharp places replaced by running means over the path, the widest at the corner and none at the
/// window's ends. Returns which points are new: they lie near the surface, not on it. A corner of angle a moves by
/// about 0.1 sin(a / 2) intervals a round. The run along the outer boundary (turn 0) stays. Requires: interval_mm > 0.
/// Properties: 1. Ends stay, and turn 0. 2. A path without sharp places stays as it is, bit by bit. 3. No angle grows
/// past the greatest one before.
std::vector<char> round_corners(CcPiece& piece, double interval_mm, const RoundingOptions& options = {});

/// Fills the chords beside every bend over 0.2 rad with points a tenth of an interval apart. A spline through the bend
/// alone swings out by as much as two sparse points let it; with these it keeps to the chords that scallops were
/// measured on. Requires: interval_mm > 0. Properties: 1. The polyline stays the same line. 2. Straight stretches stay
/// as they are.
void fill_bends(CcPiece& piece, double interval_mm);

/// Places where chords of half an interval before and behind differ by more than `angle_rad`, the sharpest of each run;
/// none on the run along the outer boundary, which nothing can round. Requires: interval_mm > 0.
std::vector<Vec3> sharp_places_mm(const CcPiece& piece, double interval_mm, double angle_rad);

}  // namespace volute::planner
