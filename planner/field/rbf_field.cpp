#include "planner/field/rbf_field.hpp"

#include <Eigen/LU>
#include <cmath>
#include <string>

#include "geometry/number_text.hpp"

namespace volute::planner {

namespace {

constexpr double least_reciprocal_condition = 1e-14;
constexpr double vanishing_length = 1e-9;

Result<void> check_apart(const std::vector<FieldKey>& keys, const FieldMetric& metric) {
  for (std::size_t i = 0; i < keys.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (field_distance(metric, keys[i].place, keys[j].place) <= 0.0)
        return geometry::bad_input("field-keys-coincide", "key " + std::to_string(j + 1) + " and key " +
                                                              std::to_string(i + 1) +
                                                              " stand at the same place; take one of them out");
  return {};
}

}  // namespace

double field_distance(const FieldMetric& metric, const FieldPlace& a, const FieldPlace& b) {
  switch (metric.distance) {
    case FieldDistance::straight_mm:
      return (a.point_P_mm - b.point_P_mm).norm();
    case FieldDistance::parameters:
      return (a.uv - b.uv).norm();
    case FieldDistance::cylinder: {
      const double round = std::abs(a.uv.y() - b.uv.y());
      return std::hypot(metric.u_weight * (a.uv.x() - b.uv.x()), std::min(round, 1.0 - round));
    }
  }
  return 0.0;
}

Result<RbfField> RbfField::fit(std::vector<FieldKey> keys, const RadialBasis& basis, const FieldMetric& metric) {
  if (keys.empty()) return geometry::bad_input("field-no-keys", "an orientation field needs at least one key axis");
  if (auto apart = check_apart(keys, metric); !apart) return tl::unexpected(apart.error());
  const auto count = static_cast<Eigen::Index>(keys.size());
  Eigen::MatrixXd phi(count, count);
  Eigen::MatrixX3d axes(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    axes.row(i) = keys[static_cast<std::size_t>(i)].axis_P;
    for (Eigen::Index j = 0; j < count; ++j)
      phi(i, j) = basis_value(basis, field_distance(metric, keys[static_cast<std::size_t>(i)].place,
                                                    keys[static_cast<std::size_t>(j)].place));
  }
  const Eigen::PartialPivLU<Eigen::MatrixXd> factor(phi);
  RbfField field;
  field.reciprocal_condition_ = factor.rcond();
  if (!(field.reciprocal_condition_ > least_reciprocal_condition))
    return geometry::bad_input("field-singular",
                               "the key axes' equations are singular (reciprocal condition " +
                                   geometry::short_text(field.reciprocal_condition_, 2) +
                                   "); give fewer keys, put them farther apart, or make the basis narrower");
  const Eigen::MatrixX3d solved = factor.solve(axes);
  for (Eigen::Index i = 0; i < count; ++i) field.coefficients_.emplace_back(solved.row(i));
  field.keys_ = std::move(keys);
  field.basis_ = basis;
  field.metric_ = metric;
  return field;
}

Vec3 RbfField::raw(const FieldPlace& place) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < keys_.size(); ++i)
    sum += basis_value(basis_, field_distance(metric_, keys_[i].place, place)) * coefficients_[i];
  return sum;
}

std::optional<Vec3> RbfField::axis(const FieldPlace& place) const {
  const Vec3 sum = raw(place);
  const double length = sum.norm();
  if (length < vanishing_length) return std::nullopt;
  return sum / length;
}

}  // namespace volute::planner
