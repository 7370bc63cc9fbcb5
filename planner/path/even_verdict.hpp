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
  ScallopStatistics scallop;  ///< of the path, by the close look where that was needed
};

/// Where `map` has more than 1.10, or more than 1.05 over a ten-thousandth of the area, the surface is cut until no
/// edge is longer than an interval and sampled 49 times a triangle where it is high, and the path is mended
/// (mend_finished) up to 16 times, to 1.05; the best goes on. A path of several pieces stays. Requires: `map` is that
/// of measure_scallop for the path; one normal a vertex. Errors: those of MeshTopology::build and SparseSolver::factor.
/// Deterministic on any number of threads. Property: 1. A path that holds stays bit by bit.
Result<MendedPath> mended_closely(const TriangleMesh& surface, std::span<const Vec3> vertex_normals, CcPath path,
                                  const ScallopMap& map, const IntervalRule& rule);

}  // namespace volute::planner
