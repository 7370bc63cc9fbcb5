#include "planner/field/mesh_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/check.hpp"
#include "geometry/mesh_measure.hpp"
#include "geometry/number_text.hpp"
#include "planner/field/field_index.hpp"

namespace volute::planner {

namespace {

/// Width of the basis when the user gives none, in spacings of the keys (their spread over the root of their number).
/// Measured on the normals of a half-sphere with 37 and 123 keys: 1.25 leaves 13 and 9 degrees between keys, 3
/// leaves 3.7 and 2.2 at a reciprocal condition of 5e-10, 6 gains nothing at 1e-14. The Gaussian's equations turn
/// singular sooner.
constexpr double multiquadric_spacings = 3.0;
constexpr double gaussian_spacings = 2.0;
/// Widest half-open basis that eq. 5 allows (a < 0.5).
constexpr double half_open_width = 0.4;

double spread(const std::vector<FieldKey>& keys, const FieldMetric& metric) {
  double widest = 0.0;
  for (std::size_t i = 0; i < keys.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) widest = std::max(widest, field_distance(metric, keys[i].place, keys[j].place));
  return widest > 0.0 ? widest : 1.0;
}

Result<void> check_options(const FieldOptions& options) {
  if (options.spline && options.placement == FieldPlacement::straight)
    return geometry::bad_input("field-no-parameters",
                               "field.spline needs parameters: set field.placement to \"box\" or \"cylinder\"");
  if (options.basis.kind == BasisKind::half_open && options.placement != FieldPlacement::cylinder)
    return geometry::bad_input("field-basis-placement",
                               "field.basis = \"half-open\" is measured round a closed direction of length 1: set "
                               "field.placement to \"cylinder\", or choose another basis");
  if (options.basis.kind == BasisKind::half_open && options.basis.a >= 0.5)
    return geometry::bad_input("field-basis-width",
                               "field.a = " + geometry::short_text(options.basis.a) +
                                   " must lie below 0.5 for the half-open basis ([Huang2016] eq. 5)");
  return {};
}

/// Area mean of half the squared gradient of the axes, and the largest turn along an edge.
void measure_turning(const geometry::TriangleMesh& mesh, const std::vector<Vec3>& axes, MeshFieldReport& report) {
  double energy = 0.0, area = 0.0, turn = 0.0;
  for (const geometry::Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices_mm[static_cast<std::size_t>(t[0])],
               &b = mesh.vertices_mm[static_cast<std::size_t>(t[1])],
               &c = mesh.vertices_mm[static_cast<std::size_t>(t[2])];
    const Vec3 cross = (b - a).cross(c - a);
    const double twice_area = cross.norm();
    if (twice_area <= 0.0) continue;
    const Vec3 normal = cross / twice_area;
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const Vec3& from = mesh.vertices_mm[static_cast<std::size_t>(t[static_cast<std::size_t>((k + 1) % 3)])];
      const Vec3& to = mesh.vertices_mm[static_cast<std::size_t>(t[static_cast<std::size_t>((k + 2) % 3)])];
      const Vec3& axis = axes[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
      const Vec3& next = axes[static_cast<std::size_t>(t[static_cast<std::size_t>((k + 1) % 3)])];
      gradient += axis * (normal.cross(to - from) / twice_area).transpose();
      turn = std::max(turn, std::atan2(axis.cross(next).norm(), axis.dot(next)));
    }
    energy += 0.25 * twice_area * gradient.squaredNorm();
    area += 0.5 * twice_area;
  }
  report.dirichlet_per_mm2 = area > 0.0 ? energy / area : 0.0;
  report.largest_turn = geometry::Angle::radians(turn);
}

void measure_keys(const SurfaceField& field, const std::vector<PointKey>& keys, MeshFieldReport& report) {
  std::vector<Vec3> wanted, got;
  for (const PointKey& key : keys) {
    wanted.push_back(key.axis_P);
    got.push_back(field.axis(key.point_P_mm).value_or(Vec3::Zero()));
  }
  report.keys = static_cast<int>(keys.size());
  report.reciprocal_condition = field.interpolation().reciprocal_condition();
  report.fitting_accuracy = fitting_accuracy(wanted, got);
  report.largest_key_angle = largest_angle(wanted, got);
}

void measure_tilt(const geometry::TriangleMesh& mesh, const std::vector<Vec3>& axes, MeshFieldReport& report) {
  const std::vector<Vec3> normals = geometry::vertex_normals(mesh);
  double least = std::numbers::pi, greatest = 0.0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double tilt = std::atan2(axes[i].cross(normals[i]).norm(), axes[i].dot(normals[i]));
    least = std::min(least, tilt);
    greatest = std::max(greatest, tilt);
  }
  report.tilt_least = geometry::Angle::radians(least);
  report.tilt_greatest = geometry::Angle::radians(greatest);
}

}  // namespace

RadialBasis with_width(RadialBasis basis, const std::vector<FieldKey>& keys, const FieldMetric& metric) {
  if (basis.a > 0.0 || keys.empty()) return basis;
  const double spacing = spread(keys, metric) / std::sqrt(static_cast<double>(keys.size()));
  if (basis.kind == BasisKind::half_open)
    basis.a = half_open_width;
  else
    basis.a = basis.kind == BasisKind::gaussian ? 1.0 / (gaussian_spacings * spacing) : multiquadric_spacings * spacing;
  return basis;
}

FieldFrame::FieldFrame(FieldPlacement placement, std::span<const Vec3> points_P_mm) : placement_(placement) {
  VOLUTE_CHECK(!points_P_mm.empty(), points_P_mm.size());
  least_mm_ = points_P_mm.front();
  Vec3 greatest_mm = least_mm_;
  for (const Vec3& point : points_P_mm) {
    least_mm_ = least_mm_.cwiseMin(point);
    greatest_mm = greatest_mm.cwiseMax(point);
  }
  size_mm_ = greatest_mm - least_mm_;
  centre_mm_ = 0.5 * (greatest_mm + least_mm_);
}

FieldPlace FieldFrame::place(const Vec3& point_P_mm) const {
  FieldPlace result{Vec2::Zero(), point_P_mm};
  const auto share = [&](int k) { return size_mm_[k] > 0.0 ? (point_P_mm[k] - least_mm_[k]) / size_mm_[k] : 0.0; };
  if (placement_ == FieldPlacement::box) result.uv = {share(0), share(1)};
  if (placement_ == FieldPlacement::cylinder) {
    const Vec3 offset = point_P_mm - centre_mm_;
    const double turn = std::atan2(offset.y(), offset.x()) / (2.0 * std::numbers::pi);
    result.uv = {share(2), turn < 0.0 ? turn + 1.0 : turn};
  }
  return result;
}

FieldMetric FieldFrame::metric() const {
  if (placement_ == FieldPlacement::straight) return {FieldDistance::straight_mm, 1.0};
  if (placement_ == FieldPlacement::box) return {FieldDistance::parameters, 1.0};
  const double diameter_mm = std::max(size_mm_.x(), size_mm_.y());
  return {FieldDistance::cylinder, size_mm_.z() / (std::numbers::pi * diameter_mm)};
}

Result<SurfaceField> SurfaceField::fit(const geometry::TriangleMesh& mesh, const std::vector<PointKey>& keys,
                                       const FieldOptions& options) {
  return fit(FieldFrame(options.placement, mesh.vertices_mm), keys, options);
}

Result<SurfaceField> SurfaceField::fit(const FieldFrame& frame, const std::vector<PointKey>& keys,
                                       const FieldOptions& options) {
  if (auto good = check_options(options); !good) return tl::unexpected(good.error());
  std::vector<FieldKey> placed;
  for (const PointKey& key : keys) placed.push_back({frame.place(key.point_P_mm), key.axis_P});
  auto rbf = RbfField::fit(placed, with_width(options.basis, placed, frame.metric()), frame.metric());
  if (!rbf) return tl::unexpected(rbf.error());
  SurfaceField field(std::move(*rbf), frame);
  if (options.spline) {
    // The grid holds unit axes: between far keys the raw interpolation is short, and a spline of it overshoots.
    const auto sample = [&field](const Vec2& uv) { return field.rbf_.axis({uv, Vec3::Zero()}).value_or(Vec3::Zero()); };
    const bool closed = options.placement == FieldPlacement::cylinder;
    field.spline_.emplace(sample,
                          FieldSplineOptions{options.u_intervals, options.v_intervals, closed, KnotRule::averaged});
  }
  return field;
}

std::optional<Vec3> SurfaceField::axis(const Vec3& point_P_mm) const {
  const FieldPlace where = place(point_P_mm);
  if (!spline_) return rbf_.axis(where);
  const Vec3 value = spline_->value(where.uv);
  const double length = value.norm();
  if (length < 1e-9) return std::nullopt;
  return value / length;
}

Result<MeshField> field_on_mesh(const geometry::TriangleMesh& mesh, const std::vector<PointKey>& keys,
                                const FieldOptions& options) {
  const auto field = SurfaceField::fit(mesh, keys, options);
  if (!field) return tl::unexpected(field.error());
  MeshField result;
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    const auto axis = field->axis(mesh.vertices_mm[i]);
    if (!axis) {
      const Vec3& p = mesh.vertices_mm[i];
      return geometry::bad_input("field-vanishes", "the field has no direction at vertex " + std::to_string(i) + " (" +
                                                       geometry::short_text(p.x()) + ", " +
                                                       geometry::short_text(p.y()) + ", " +
                                                       geometry::short_text(p.z()) + "); add a key axis near it");
    }
    result.axes_P.push_back(*axis);
  }
  measure_keys(*field, keys, result.report);
  measure_turning(mesh, result.axes_P, result.report);
  measure_tilt(mesh, result.axes_P, result.report);
  return result;
}

}  // namespace volute::planner
