// The spiral, and the contour-parallel passes, of a guide field: chains of raw points on the surface.
#pragma once

#include <optional>
#include <vector>

#include "planner/path/finish_path.hpp"
#include "planner/path/guide_field.hpp"

namespace volute::planner {

struct GuidePath {
  std::vector<RawStretch> stretches;  ///< each starts where the one before ends
  std::vector<Vec3> seam_crossings_mm;
  std::vector<std::vector<geometry::Vec2>> map_lines;  ///< the guide lines in the map
  int lines_dropped = 0;  ///< level lines that are no part of the spiral (0 for a sound map)
};

/// Which way round, and where the path begins.
struct GuideOptions {
  Sense sense = Sense::counter_clockwise;
  std::optional<Vec3> start_P_mm;           ///< the path begins at the vertex of its first boundary nearest to it
  Direction direction = Direction::inward;  ///< outward: the first boundary is the inner one
  /// Where the curve of an edge (eq. 15, 16) leaves the edge by more, the mesh is too coarse to tell the nominal
  /// surface: the edge stands for itself, and the path stays on the mesh that was given. plan_guided_path: a quarter of
  /// the scallop.
  double bulge_max_mm = 0.05;
};

/// One spiral from the outer boundary to the inner one: half a turn along the outer boundary, the guide line of eq. 11,
/// half a turn along the inner boundary. Departs from the source: eq. 11 starts on the seam and leaves the boundaries'
/// wedges uncut; here the guide line starts half a turn behind the seam and half turns along the boundaries belong to
/// the path. Property: with a start place the first CC point, in the direction asked for, is the boundary's nearest to
/// it, up to an edge. Errors (bad_input): path-broken (the guide line does not reach the inner boundary; says where it
/// ends).
Result<GuidePath> spiral_of(const Annulus& annulus, const GuideField& field, const GuideOptions& options);

/// Closed passes at whole numbers of turns, eq. 10, from the outer boundary itself to the inner boundary itself, each
/// joined to the next by a link across. Departs from the source: the inner boundary is a pass too. Errors (bad_input):
/// path-broken.
Result<GuidePath> contours_of(const Annulus& annulus, const GuideField& field, const GuideOptions& options);

}  // namespace volute::planner
