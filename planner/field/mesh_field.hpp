// An orientation field on a whole mesh: what `volute field` makes and `smoothing = "field"` follows.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/angle.hpp"
#include "geometry/mesh.hpp"
#include "planner/field/field_options.hpp"
#include "planner/field/field_spline.hpp"
#include "planner/field/rbf_field.hpp"

namespace volute::planner {

/// The basis with its width chosen from the keys when the user gave none (a = 0).
RadialBasis with_width(RadialBasis basis, const std::vector<FieldKey>& keys, const FieldMetric& metric);

/// A key as the user gives it: at a point near the surface.
struct PointKey {
  Vec3 point_P_mm;
  Vec3 axis_P;
};

/// Where points lie in the parameters of a placement, laid over the box round some points (a mesh, or a path's
/// contacts).
class FieldFrame {
 public:
  /// Requires: at least one point.
  FieldFrame(FieldPlacement placement, std::span<const Vec3> points_P_mm);

  /// straight: without parameters. box: u, v over x, y of the box. cylinder: u the height over the box, v the angle.
  [[nodiscard]] FieldPlace place(const Vec3& point_P_mm) const;
  [[nodiscard]] FieldMetric metric() const;
  /// Of the box in the metric: mm, or 1 in parameters.
  [[nodiscard]] double extent() const { return placement_ == FieldPlacement::straight ? size_mm_.norm() : 1.0; }

 private:
  FieldPlacement placement_;
  Vec3 least_mm_, size_mm_, centre_mm_;
};

/// A field that can be asked at any point near the mesh.
class SurfaceField {
 public:
  /// Errors (bad_input): those of RbfField::fit; field-no-parameters (spline without box or cylinder);
  /// field-basis-placement (half-open without cylinder); field-basis-width.
  static Result<SurfaceField> fit(const geometry::TriangleMesh& mesh, const std::vector<PointKey>& keys,
                                  const FieldOptions& options);
  /// The same in a frame of its own. Requires: frame was made for options.placement.
  static Result<SurfaceField> fit(const FieldFrame& frame, const std::vector<PointKey>& keys,
                                  const FieldOptions& options);

  /// Unit axis; nothing where the interpolation vanishes.
  [[nodiscard]] std::optional<Vec3> axis(const Vec3& point_P_mm) const;
  [[nodiscard]] const RbfField& interpolation() const { return rbf_; }
  [[nodiscard]] FieldPlace place(const Vec3& point_P_mm) const { return frame_.place(point_P_mm); }

 private:
  SurfaceField(RbfField rbf, const FieldFrame& frame) : rbf_(std::move(rbf)), frame_(frame) {}
  RbfField rbf_;
  FieldFrame frame_;
  std::optional<FieldSpline> spline_;
};

struct MeshFieldReport {
  int keys = 0;
  double reciprocal_condition = 0.0;
  double fitting_accuracy = 0.0;              ///< I_fa over the keys, unit axes
  geometry::Angle largest_key_angle;          ///< field against key
  double dirichlet_per_mm2 = 0.0;             ///< area mean of |grad T|^2 / 2 over the mesh, 1/mm^2
  geometry::Angle largest_turn;               ///< between the ends of one edge
  geometry::Angle tilt_least, tilt_greatest;  ///< of the axis from the surface normal, over the vertices
};

struct MeshField {
  std::vector<Vec3> axes_P;  ///< one a vertex
  MeshFieldReport report;
};

/// The field at every vertex. Errors: as SurfaceField::fit; field-vanishes (names a vertex and its point).
Result<MeshField> field_on_mesh(const geometry::TriangleMesh& mesh, const std::vector<PointKey>& keys,
                                const FieldOptions& options);

}  // namespace volute::planner
