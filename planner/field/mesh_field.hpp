// An orientation field on a whole mesh: what `volute field` makes and `smoothing = "field"` follows.
#pragma once

#include <optional>
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

/// A field that can be asked at any point near the mesh.
class SurfaceField {
 public:
  /// Errors (bad_input): those of RbfField::fit; field-no-parameters (spline without box or cylinder);
  /// field-basis-width.
  static Result<SurfaceField> fit(const geometry::TriangleMesh& mesh, const std::vector<PointKey>& keys,
                                  const FieldOptions& options);

  /// Unit axis; nothing where the interpolation vanishes.
  [[nodiscard]] std::optional<Vec3> axis(const Vec3& point_P_mm) const;
  [[nodiscard]] const RbfField& interpolation() const { return rbf_; }
  [[nodiscard]] FieldPlace place(const Vec3& point_P_mm) const;

 private:
  SurfaceField(RbfField rbf, FieldPlacement placement) : rbf_(std::move(rbf)), placement_(placement) {}
  RbfField rbf_;
  FieldPlacement placement_;
  Vec3 least_mm_ = Vec3::Zero(), size_mm_ = Vec3::Ones(), centre_mm_ = Vec3::Zero();
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
