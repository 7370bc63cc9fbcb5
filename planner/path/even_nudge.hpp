// Single places that a path leaves too high, mended on the path itself: the passes beside them are moved over a little.
#pragma once

#include <span>
#include <vector>

#include "planner/path/cc_path.hpp"
#include "planner/path/scallop_map.hpp"
#include "planner/surface/operators.hpp"

namespace volute::planner {

/// A place of the surface and the height left there over the allowed one.
struct HighPlace {
  Vec3 place_P_mm;
  double ratio = 0.0;
};

/// The places over `ratio`, the highest of each neighbourhood of `apart_mm`, the highest first.
std::vector<HighPlace> high_places(const ScallopMap& map, double ratio, double apart_mm);

struct NudgeOptions {
  double window_intervals = 1.6;     ///< of the path on either side of the foot that moves with it
  double reach_intervals = 1.2;      ///< passes farther from a place than this are not moved for it
  double beside = 1.15;              ///< times the distance of the nearest pass: those as near move as well
  double aim_ratio = 1.0;            ///< of the allowed height: what a place is taken down to
  double turn_kept = 0.0;            ///< points up to this turn stay
  double steps_per_interval = 12.0;  ///< points in a window, at least
};

/// Moves the passes nearest to each place towards it, by the share of their distance that takes the height (which grows
/// with its square) down to the allowed one; the whole way at the foot, none at the window's ends. Where windows
/// overlap the shifts are averaged by their weights. Returns which points are new: they lie near the surface, not on
/// it. The run along the outer boundary (turn 0) stays. Requires: interval_mm > 0.
/// Properties: 1. Without places the path stays as it is, bit by bit. 2. Ends stay. 3. No point moves by more than the
/// greatest shift asked for.
std::vector<char> nudge(CcPiece& piece, std::span<const HighPlace> places, double interval_mm,
                        const NudgeOptions& options = {});

/// The same on a finished piece, whose points stand on a smooth curve beside the mesh: a point that moves goes as the
/// nearest point of the mesh goes, and its normal turns as that of the mesh does. All others stay bit by bit.
void nudge_finished(CcPiece& piece, std::span<const HighPlace> places, double interval_mm, const TriangleMesh& mesh,
                    std::span<const Vec3> vertex_normals, const std::vector<TriangleOperator>& operators);

}  // namespace volute::planner
