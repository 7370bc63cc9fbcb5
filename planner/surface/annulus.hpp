// A surface with any number of holes as one ring: outer boundary, inner boundary (holes joined by bridges, or a slit),
// seam.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/result.hpp"
#include "planner/surface/boundary_tree.hpp"
#include "planner/surface/condition.hpp"

namespace volute::planner {

struct AnnulusOptions {
  RootChild root_child = RootChild::nearest;
  int centre_loop = -1;  ///< boundary loop (by falling length) that is the outer boundary's child; -1: by root_child
  ConditionOptions condition;
};

/// Three meshes with the same triangles in the same order: `whole` closed over bridges and seam, `ring` cut along the
/// bridges, `sheet` cut along the seam too. Each vertex of a mesh knows its vertex in the mesh before.
struct Annulus {
  TriangleMesh whole, ring, sheet;
  std::vector<Index> ring_to_whole, sheet_to_ring;
  std::vector<Vec3> ring_normals;  ///< unit vertex normals of `whole`, by vertex of `ring`
  std::vector<Index> outer;  ///< of `ring`: outer boundary from the seam on, surface on the left (counter-clockwise)
  std::vector<Index> inner;  ///< of `ring`: inner boundary from the seam on, running the SAME way around as outer
  std::vector<Index> seam;   ///< of `ring`: from outer.front() to inner.front()
  /// Of `sheet`: the four sides of the rectangle, [Sun2016] Fig. 4: bottom (outer), right (seam upward), top (inner,
  /// from left to right), left (seam upward); corners belong to both their sides.
  std::vector<Index> bottom, right, top, left;
  std::vector<geometry::BoundaryLoop> curves;  ///< the boundary curves of `whole` (the surface's own, chords split)
  std::vector<Bridge> bridges;                 ///< vertices of `whole`; [0] is the seam (outer boundary to its child)
  bool centre_is_slit = false;                 ///< a disk: the inner boundary is a slit that was cut
  Index edges_flipped = 0, edges_not_delaunay = 0, chords_split = 0;
  std::vector<std::string> notes;
};

/// Conditions the surface, joins its boundaries and cuts it open. A disk gets a short slit along its deepest ridge as
/// centre. Errors (bad_input): those of MeshTopology::build; surface-several-components, surface-handles,
/// surface-closed (each with the count and the remedy); surface-no-path; surface-centre-loop (no such loop, or the
/// outer one). Properties: 1. `ring` has two boundary loops and no handle, `sheet` one loop. 2. No triangle of `sheet`
/// has its three vertices on the boundary. 3. The boundary loop of `sheet`, as vertices of `whole`, equals
/// connected_boundary(curves, bridges).
Result<Annulus> make_annulus(const TriangleMesh& surface, const AnnulusOptions& options = {});

}  // namespace volute::planner
