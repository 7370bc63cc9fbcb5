// The surface as an annulus: from the outer boundary to a centre (a hole, or a slit cut for the purpose), the other
// holes floating.
#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.hpp"
#include "planner/path/path_interval.hpp"
#include "planner/surface/operators.hpp"
#include "planner/surface/periodic_coordinate.hpp"

namespace volute::planner {

/// The conditioned surface (see condition.hpp) with what every centre shares.
struct EvenSurface {
  TriangleMesh mesh;
  geometry::MeshTopology topology;
  std::vector<Vec3> vertex_normals;
  std::vector<Mat3> curvature;  ///< per triangle, averaged tensor

  /// Puts the mesh into memory order first. Errors: those of MeshTopology::build.
  static Result<EvenSurface> build(const TriangleMesh& mesh);
  /// Edges halved down to `edge_max_mm`; new vertices take the mean of their ends' normals, triangles their parents'
  /// curvature, so that a coarse mesh keeps its rounded look. Errors: those of MeshTopology::build.
  [[nodiscard]] Result<EvenSurface> refined(double edge_max_mm) const;
};

/// A cut between two vertices; `to` lies inside, or on another hole, which then belongs to the centre.
struct Arm {
  Index from = geometry::no_index, to = geometry::no_index;
};
/// Two passes more between two inner vertices than beside them, on the way from one to the other: at either end two
/// neighbouring passes are one, turning back. Swapped ends: two passes less there.
struct Fold {
  Index from = geometry::no_index, to = geometry::no_index;
};
/// Where the spiral ends: a boundary loop, a tree of slits, or a loop with slits growing out of it.
struct Centre {
  Index loop = geometry::no_index;  ///< boundary loop, by falling length, not 0
  std::vector<Arm> arms;            ///< each starts where an earlier one starts or ends, or on a hole of the centre
  std::vector<Fold> folds = {};     ///< for lay_folds (even_fold.hpp); even_domain itself ignores them

  [[nodiscard]] bool has_loop() const { return loop != geometry::no_index; }
};

/// What the field lives on. Triangles keep their curvature from the uncut surface.
struct EvenDomain {
  TriangleMesh mesh;  ///< cut open along the slit
  geometry::MeshTopology topology;
  std::vector<Vec3> vertex_normals;
  std::vector<Mat3> curvature;
  std::vector<TriangleOperator> operators;
  geometry::BoundaryLoop outer, centre;
  std::vector<geometry::BoundaryLoop> floating;  ///< the other holes: level sets of the field, no path ends there
  std::vector<double> harmonic;                  ///< 0 outside, 1 at the centre, constant on floating holes (no flux)
  PeriodicCoordinate theta;                      ///< once around, counter-clockwise positive
  std::vector<std::vector<Index>> slits;         ///< vertices along each arm of the centre
  std::vector<std::vector<Index>> folds;         ///< vertices along each fold, from end to end

  [[nodiscard]] double interval_mm(const IntervalRule& rule, Index triangle, const Vec3& across) const {
    return rule.interval_mm(across.dot(curvature[static_cast<std::size_t>(triangle)] * across));
  }
};

/// `ramp_share`: the share of a turn over which theta grows on the outer boundary, 1: all of it (harmonic theta). Where
/// theta stands still the path keeps its distance from the boundary, so that the wedge between the boundary and the
/// first turn, and the part of the boundary that must be run along, shrink to this share; inward theta becomes harmonic
/// again. An arm that would cross an earlier one starts where it leaves it. Errors (bad_input): surface-slit-short (the
/// slit is one edge), surface-no-path where a slit or seam cannot be laid, those of MeshTopology::build, and
/// matrix-not-positive-definite where a mesh is too thin for theta.
/// Requires: a boundary; a centre with a loop or an arm; arms as Centre says, distinct ends; 0 < ramp_share <= 1.
Result<EvenDomain> even_domain(const EvenSurface& surface, const Centre& centre, double ramp_share = 1.0);

}  // namespace volute::planner
