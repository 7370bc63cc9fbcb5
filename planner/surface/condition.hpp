// Makes a mesh fit for harmonic fields: Delaunay by flips, no inner edge that joins two vertices of one boundary loop.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/result.hpp"

namespace volute::planner {

using geometry::Index;
using geometry::Result;
using geometry::TriangleMesh;
using geometry::Vec3;

struct ConditionOptions {
  double dihedral_max_rad = 0.4363;  ///< 25 degrees: an edge that bends more is a feature and is not flipped
  double deviation_max_mm = 0.05;    ///< a flip may move the surface this far; smaller leaves more obtuse pairs
};

/// What was done. Vertices of the input keep their numbers; new ones stand behind them.
struct ConditionedMesh {
  TriangleMesh mesh;
  Index edges_flipped = 0;
  Index edges_not_delaunay = 0;  ///< left: a flip would have bent or folded the surface
  Index chords_split = 0;
};

/// Flips inner edges whose opposite angles sum to more than half a turn (extrinsic: the surface moves by at most
/// `deviation_max_mm`), then splits chords.
/// Requires: an oriented manifold. Errors: those of MeshTopology::build.
/// Properties: 1. Every edge left with an angle sum over pi would break a guard when flipped. 2. The boundary is
/// unchanged.
/// 3. The same input gives the same triangles.
Result<ConditionedMesh> condition(const TriangleMesh& surface, const ConditionOptions& options = {});

/// The flips alone; returns how many. Guards and errors as condition().
Result<Index> flip_to_delaunay(TriangleMesh& mesh, const ConditionOptions& options = {});

/// Halves every inner edge that joins two vertices of one boundary loop, until none is left: an ear (triangle with its
/// three vertices on one loop) would otherwise have no room in a map whose boundary is fixed, and a harmonic field no
/// gradient there. Returns for each new vertex, in order of their numbers, the two ends of the edge that it halved.
/// Errors: those of MeshTopology::build.
Result<std::vector<std::array<Index, 2>>> split_chords(TriangleMesh& mesh);

}  // namespace volute::planner
