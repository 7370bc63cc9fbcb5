// Level lines of a function on a mesh, also of one with whole-number jumps across a seam.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "planner/surface/surface_path.hpp"

namespace volute::planner {

/// One chain of a level line through triangles. Every point lies inside an edge.
struct LevelLine {
  SurfacePath points;  ///< greater values on the left, seen from outside
  std::vector<Index>
      triangles;  ///< of each segment: triangles[i] lies between points i and i + 1 (closed: the last joins the first)
  bool closed = false;  ///< else it runs from boundary to boundary
  double length_mm = 0.0;
  /// Open lines: the halfedges of first and last triangle where it comes in and leaves, and the level there.
  Index from_halfedge = geometry::no_index, to_halfedge = geometry::no_index;
  long from_level = 0, to_level = 0;
};

/// Values at the corners of triangles: vertex[triangles[t][k]] - jump[t][k], jumps being whole numbers that change only
/// across seams.
struct CornerValues {
  std::span<const double> vertex;
  std::span<const std::array<double, 3>> jump;  ///< empty: none
  std::span<const Index> torn = {};             ///< edges, by number, at which lines end as on a boundary
};

/// All level lines at the levels Z + offset, by falling length (ties: first triangle). Which edges are crossed is
/// decided in whole numbers, so lines never break or branch; a value equal to a level counts as above it. Points keep
/// 1e-7 of their edge from its ends. Properties: 1. Every line is closed or ends on the boundary at both ends. 2. Each
/// (triangle, level) crossed lies in one line.
/// 3. A seam moved by whole jumps gives the same lines. 4. The same input gives the same bytes.
std::vector<LevelLine> trace_levels(const TriangleMesh& mesh, const geometry::MeshTopology& topology,
                                    const CornerValues& values, double offset);

}  // namespace volute::planner
