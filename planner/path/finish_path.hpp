// The last steps that all guided paths share: the part between two turns, the direction, smooth CC points, the
// measures.
#pragma once

#include "planner/path/cc_curve.hpp"
#include "planner/path/cc_path.hpp"

namespace volute::planner {

/// Which way round the path runs inward, seen along the outer normal (against it one sees it counter-clockwise).
enum class Sense { counter_clockwise, clockwise };

/// The sense of an inward path, reversed for outward, with which the wanted side of the tool lies in the material: a
/// clockwise spindle climbs where the material is on its right.
Sense sense_of(CutDirection direction);

/// A stretch of path that is smooth in itself; `link`: it leads from one pass to the next.
struct RawStretch {
  std::vector<RawPoint> points;
  bool link = false;
};

/// Only the part between two turns; boundary half turns and passes outside it go.
/// Errors (bad_input): path-turns (nothing is left; says how many turns there are).
Result<void> keep_turns(std::vector<RawStretch>& stretches, const PathOptions& options);

/// One piece of smooth CC points from stretches that run inward; reversed where the options say outward.
CcPiece finished_piece(std::vector<RawStretch> stretches, const PathOptions& options, const CurveOptions& curve);

/// The mirror image of a surface in the plane x = 0, still seen from outside: a path planned on it runs the other way
/// round.
TriangleMesh mirrored(const TriangleMesh& surface);
/// The mirror image of a path.
void mirror(CcPathResult& result);

}  // namespace volute::planner
