// The three cases of [Huang2016] with what the paper leaves open filled in.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "planner/field/field_index.hpp"
#include "planner/field/field_spline.hpp"
#include "planner/field/rbf_field.hpp"

namespace volute::app {

/// One case: a surface over (u, v) in [0, 1]^2, key axes, and how the paper interpolates them.
struct FieldCase {
  std::string name;
  std::function<geometry::Vec3(const geometry::Vec2&)> point_P_mm;
  std::function<geometry::Vec3(const geometry::Vec2&)> normal_P;
  std::vector<planner::FieldKey> keys;
  planner::RadialBasis basis;
  planner::FieldMetric metric;
  planner::FieldSplineOptions spline;
  int index_rows = 0, index_columns = 0;  ///< N_uD, N_vD of the paper's table
  bool unit_axes = true;  ///< the interpolation is brought to unit length before it is sampled; false: taken as it is
  std::vector<geometry::TriangleMesh> obstacles_P;
};

FieldCase arched_strip_case();
FieldCase bowling_pin_case();
FieldCase half_sphere_case();

/// Both fields of a case.
struct CaseFields {
  planner::RbfField interpolation;
  planner::FieldSpline spline;
};
geometry::Result<CaseFields> fields_of(const FieldCase& one);

/// The interpolation at (u, v), as the case takes it.
geometry::Vec3 interpolated_axis(const FieldCase& one, const planner::RbfField& field, const geometry::Vec2& uv);

/// The surface as rows x columns quadrilaterals.
geometry::TriangleMesh mesh_of(const FieldCase& one, int rows, int columns);

}  // namespace volute::app
