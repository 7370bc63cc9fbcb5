// The surface at another fineness: fewer triangles for searching, more where a mesh is too coarse for the field.
#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/result.hpp"

namespace volute::planner {

using geometry::Index;
using geometry::Result;
using geometry::TriangleMesh;

struct CoarseMesh {
  TriangleMesh mesh;
  std::vector<Index> original;  ///< for each vertex its number in the fine mesh: vertices stay where they are
};

/// Collapses edges shorter than `edge_mm`, the shortest first, as long as no triangle turns by more than 45 degrees or
/// becomes a sliver, boundaries keep their shape within `boundary_mm` and at least eight vertices a loop, and the
/// topology stays. Requires: an oriented manifold. Properties: 1. Loops, components and handles stay as they are. 2.
/// Every vertex is one of the old.
/// 3. The same input gives the same bytes.
CoarseMesh coarser(const TriangleMesh& mesh, double edge_mm, double boundary_mm);

struct FinerMesh {
  TriangleMesh mesh;                       ///< old vertices keep their numbers
  std::vector<std::array<Index, 2>> ends;  ///< for each new vertex, in order, the ends of the edge whose middle it is
  std::vector<Index> parent;               ///< for each triangle the old triangle that it lies in
};

/// Halves edges longer than `edge_max_mm` until there is none; triangles are split in two, three or four. The surface
/// does not move. Requires: edge_max_mm > 0. Errors: those of MeshTopology::build.
Result<FinerMesh> finer(const TriangleMesh& mesh, double edge_max_mm);

/// Vertices and triangles along a curve that fills space (Morton order): neighbours in space become neighbours in
/// memory. Unused vertices are dropped.
TriangleMesh in_memory_order(const TriangleMesh& mesh);

}  // namespace volute::planner
