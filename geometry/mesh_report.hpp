// Can this surface be machined by one spiral, and if not, why: the verdict of `volute inspect`.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh_io.hpp"

namespace volute::geometry {

struct MeshReport {
  Index triangles = 0, vertices = 0;
  double area_mm2 = 0.0;
  Vec3 least_mm = Vec3::Zero(), greatest_mm = Vec3::Zero();
  std::vector<BoundaryLoop> loops;
  std::vector<Component> components;
  Index handles = 0;
  double least_angle_deg = 0.0, greatest_angle_deg = 0.0;
  double median_edge_mm = 0.0;
  Index obtuse_triangles = 0;
  MeshRepairs repairs;
  bool machinable = false;
  std::string reason_code;  ///< "" when machinable, else: mesh-not-manifold, mesh-several-components, mesh-handles,
                            ///< mesh-no-boundary
  std::string reason;       ///< one line with the remedy
};

/// Never fails: a mesh that is no manifold has a report that says so.
MeshReport inspect(const LoadedMesh& loaded);

/// The surface to plan on: one component (the one asked for, or the only one), without handles, with a boundary.
/// `component` < 0: the mesh must have one component. Components are numbered by falling area.
/// Errors (bad_input): as MeshReport::reason_code, and component-out-of-range.
Result<TriangleMesh> machinable_surface(const LoadedMesh& loaded, int component = -1);

}  // namespace volute::geometry
