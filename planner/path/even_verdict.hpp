// What a finished path leaves, looked at closely wherever it may be too high, and mended until it holds.
#pragma once

#include <span>

#include "planner/path/cc_path.hpp"
#include "planner/path/path_interval.hpp"
#include "planner/path/scallop_map.hpp"

namespace volute::planner {

struct MendedPath {
  CcPath path;
  bool moved = false;         ///< false: the path is the one given, bit by bit
  ScallopStatistics scallop;  ///< of the path, by the close look
};

/// Looks closely at the path's scallops: triangles whose height in `map` is over 0.95 of the allowed one, and those
/// with edges longer than an interval, which nine samples do not judge, are cut until no edge is longer and sampled 49
/// times. Where more than 1.10 is left, or more than 1.05 over a ten-thousandth of the area, the whole surface is
/// looked at so and the path is mended (mend_finished) up to 16 times, to 1.05; the best goes on. Then the same along
/// the normals of the triangles, by shorter steps, to 1.10. A path of several pieces is only looked at. Requires: `map`
/// is that of measure_scallop for the path; one normal a vertex. Errors: those of MeshTopology::build and
/// SparseSolver::factor. Deterministic on any number of threads. Accuracy: against 144 times as many samples, heights
/// over the allowed one are 0.003 too low on average. Property: 1. A path that holds stays bit by bit.
Result<MendedPath> mended_closely(const TriangleMesh& surface, std::span<const Vec3> vertex_normals, CcPath path,
                                  const ScallopMap& map, const IntervalRule& rule);

}  // namespace volute::planner
