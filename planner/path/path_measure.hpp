// What a path is worth: length over its lower bound, corners, intervals, scallops. The same measures for every
// strategy.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/path/cc_path.hpp"
#include "planner/path/path_interval.hpp"
#include "planner/path/scallop_map.hpp"

namespace volute::planner {

struct MeasureRequest {
  const TriangleMesh& surface;
  const IntervalField& intervals;  ///< of the same mesh
  std::span<const Vec3> seam_crossings_mm;
  bool spiral_turns = false;  ///< CcPoint::turn grows along the path, one a turn: intervals can be measured
  bool whole_surface =
      true;  ///< false: the path covers a part; scallops are not measured and a note says what the bound is of
  ScallopMeter* meter = nullptr;  ///< as scallop_meter gives it, for paths that differ in places; null: one of its own
};

/// The meter of a report: heights over 0.7 of the allowed one are exact. `vertex_normals` as geometry::vertex_normals.
ScallopMeter scallop_meter(const TriangleMesh& surface, std::span<const Vec3> vertex_normals, const IntervalRule& rule);

/// Fills `report` from `path` (all but strategy, method, rapid_traversals, liftings and notes). Definitions:
/// docs/paths.md. Properties: 1. Corners of a square spiral are counted one by one. 2. Lengths do not depend on how
/// densely points stand. Returns the map of the scallops where they are measured.
std::optional<ScallopMap> measure_path(const MeasureRequest& request, const CcPath& path, PathReport& report);

/// Places where chords of `window_mm` before and behind differ by more than `least_rad`, with the largest angle there;
/// places nearer than half a window to each other are one corner.
std::vector<double> corner_angles_rad(std::span<const Vec3> even_points, double spacing_mm, double window_mm,
                                      double least_rad);

/// Points every `spacing_mm` (a little less) along a piece, ends included.
std::vector<Vec3> even_points(const CcPiece& piece, double spacing_mm);

}  // namespace volute::planner
