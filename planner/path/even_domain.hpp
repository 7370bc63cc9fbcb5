// The surface as an annulus: from the outer boundary to a centre (a hole, or a slit cut for the purpose), the other
// holes floating.
#pragma once

#include <array>
#include <variant>
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

/// A slit between two inner vertices.
struct Slit {
  Index from = geometry::no_index, to = geometry::no_index;
};
/// Where the spiral ends: boundary loop (by falling length, not 0) or slit.
using Centre = std::variant<Index, Slit>;

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
  std::vector<Vec3> slit_P;                      ///< the slit as a polyline; empty when the centre is a hole

  [[nodiscard]] double interval_mm(const IntervalRule& rule, Index triangle, const Vec3& across) const {
    return rule.interval_mm(across.dot(curvature[static_cast<std::size_t>(triangle)] * across));
  }
};

/// `ramp_share`: the share of a turn over which theta grows on the outer boundary, 1: all of it (harmonic theta). Where
/// theta stands still the path keeps its distance from the boundary, so that the wedge between the boundary and the
/// first turn, and the part of the boundary that must be run along, shrink to this share; inward theta becomes harmonic
/// again. Errors (bad_input): surface-slit-short (its ends are neighbours), surface-no-path where a slit or seam cannot
/// be laid, those of MeshTopology::build, and matrix-not-positive-definite where a mesh is too thin for theta.
/// Requires: a boundary; slit vertices inside and distinct; 0 < ramp_share <= 1.
Result<EvenDomain> even_domain(const EvenSurface& surface, const Centre& centre, double ramp_share = 1.0);

}  // namespace volute::planner
