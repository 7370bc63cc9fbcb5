// Places that a finished path leaves too high, mended together: all passes around them move by as little as takes every
// one of them down and lets none beside them rise.
#pragma once

#include "planner/path/cc_path.hpp"
#include "planner/path/even_crest.hpp"
#include "planner/path/scallop_map.hpp"

namespace volute::planner {

struct MendOptions {
  double mended_from = 1.03;        ///< of the allowed height: places over it are taken down
  double aim_ratio = 1.02;          ///< to this; those beside them may rise to it
  double reach_intervals = 2.5;     ///< passes within this of a place over mended_from may move
  double knots_intervals = 0.5;     ///< of the shift along the path, a cubic spline
  double longest_intervals = 0.12;  ///< no pass moves farther at once
  double turn_kept = 0.02;          ///< points up to this turn stay: the run along the outer boundary
};

/// Moves a finished piece along the surface. Each place of the map (the highest of each triangle) stands on a crest
/// between passes; its height changes with their shifts by the mean of what each ball's entry does, weighted so that
/// the entries' slopes along the surface cancel: moving either pass lowers a crest. The shifts s(k) at the knots of a
/// cubic spline along the path minimise sum |s|^2 + bending + 10^4 sum (excess over aim_ratio)^2, heights taken as
/// linear. A point goes as the nearest point of the mesh goes and its normal turns as that of the mesh does. Requires:
/// `map` is that of the piece; radius_mm > scallop_mm > 0. Errors: as SparseSolver::factor. Properties: 1. Without
/// places over mended_from the piece stays as it is, bit by bit. 2. Ends stay, and turns up to turn_kept. 3. What is
/// farther than reach_intervals and two knots from such places stays bit by bit.
Result<void> mend_finished(CcPiece& piece, const ScallopMap& map, const MendSurface& surface, double radius_mm,
                           double scallop_mm, const MendOptions& options = {});

}  // namespace volute::planner
