// A tool axis everywhere from tool axes at a few places: radial basis interpolation, [Huang2016] eqs. 1-2.
#pragma once

#include <optional>
#include <vector>

#include "geometry/result.hpp"
#include "geometry/vector.hpp"
#include "planner/field/radial_basis.hpp"

namespace volute::planner {

using geometry::Result;
using geometry::Vec2;
using geometry::Vec3;

/// A place on a surface: its parameters, and where it is.
struct FieldPlace {
  Vec2 uv = Vec2::Zero();
  Vec3 point_P_mm = Vec3::Zero();
};

/// Which distance phi is taken of.
enum class FieldDistance {
  straight_mm,  ///< between the points in space: what a path on any mesh uses
  parameters,   ///< in (u, v)
  cylinder,     ///< on the cylinder round a half-open surface: v closed with period 1, u weighted ([Huang2016]
                ///< section 2.2.2)
};

struct FieldMetric {
  FieldDistance distance = FieldDistance::straight_mm;
  double u_weight = 1.0;  ///< cylinder: mu / mv = H / (pi D)
};

/// Distance of two places in the metric; mm or parameter units.
double field_distance(const FieldMetric& metric, const FieldPlace& a, const FieldPlace& b);

struct FieldKey {
  FieldPlace place;
  Vec3 axis_P = Vec3::UnitZ();
};

/// Properties: 1. raw(key place) is the key's axis within 1e-9 times the condition number's share reported by fit.
/// 2. Components are independent: turning all keys turns the field.
class RbfField {
 public:
  /// Errors (bad_input): field-no-keys; field-keys-coincide (names two keys whose distance is 0); field-singular
  /// (reciprocal condition below 1e-14: fewer or farther keys, or a narrower basis).
  static Result<RbfField> fit(std::vector<FieldKey> keys, const RadialBasis& basis, const FieldMetric& metric);

  /// The interpolation itself; not of unit length, and it can vanish.
  [[nodiscard]] Vec3 raw(const FieldPlace& place) const;
  /// Unit axis; nothing where the interpolation vanishes (length below 1e-9).
  [[nodiscard]] std::optional<Vec3> axis(const FieldPlace& place) const;

  [[nodiscard]] const std::vector<FieldKey>& keys() const { return keys_; }
  [[nodiscard]] const std::vector<Vec3>& coefficients() const { return coefficients_; }
  [[nodiscard]] double reciprocal_condition() const { return reciprocal_condition_; }

 private:
  std::vector<FieldKey> keys_;
  std::vector<Vec3> coefficients_;
  RadialBasis basis_;
  FieldMetric metric_;
  double reciprocal_condition_ = 0.0;
};

}  // namespace volute::planner
