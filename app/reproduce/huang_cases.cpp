#include "app/reproduce/huang_cases.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/turn.hpp"
#include "view/solids.hpp"

namespace volute::app {

namespace {

using geometry::Result;
using geometry::Transform;
using geometry::Vec2;
using geometry::Vec3;
using planner::FieldKey;

constexpr double pi = std::numbers::pi, turn = 2.0 * pi;

// Case 1, eq. 12.
constexpr double strip_radius_mm = 160.0, strip_half_length_mm = 30.0, strip_width_mm = 20.0;
/// Not in the paper: radius of the oblique cylinders, keys round each.
constexpr double post_radius_mm = 5.91, post_height_mm = 14.0;
constexpr int keys_a_post = 6;

// Case 2: not in the paper but for mu : mv = 0.646.
constexpr double pin_diameter_mm = 60.0, pin_ratio = 0.646, rod_radius_mm = 8.0, rod_length_mm = 110.0,
                 rod_height_share = 0.36;
constexpr int keys_a_rod_end = 8, pin_key_rows = 5, pin_key_columns = 8;

// Case 3.
constexpr double sphere_radius_mm = 10.0, key_lean_rad = pi / 18.0;
constexpr int sphere_key_rows = 11, sphere_key_columns = 41;

double strip_half_angle() { return std::asin(strip_half_length_mm / strip_radius_mm); }

Vec3 strip_point(const Vec2& uv) {
  const double angle = (2.0 * uv.x() - 1.0) * strip_half_angle();
  return {strip_radius_mm * (std::sin(angle) + std::sin(strip_half_angle())), strip_width_mm * uv.y(),
          strip_radius_mm * (std::cos(angle) - std::cos(strip_half_angle()))};
}

Vec2 strip_parameters(const Vec3& point) {
  const double angle =
      std::atan2(point.x() - strip_half_length_mm, point.z() + strip_radius_mm * std::cos(strip_half_angle()));
  return {0.5 * (angle / strip_half_angle() + 1.0), point.y() / strip_width_mm};
}

/// Where the line from `start` along `direction` meets the strip's cylinder, on its upper side.
Vec3 on_strip(const Vec3& start, const Vec3& direction) {
  const Vec2 from(start.x() - strip_half_length_mm, start.z() + strip_radius_mm * std::cos(strip_half_angle()));
  const Vec2 along(direction.x(), direction.z());
  const double a = along.squaredNorm(), b = from.dot(along), c = from.squaredNorm() - strip_radius_mm * strip_radius_mm;
  return start + (-b + std::sqrt(b * b - a * c)) / a * direction;
}

/// A frame whose z axis is `axis`.
Transform standing_on(const Vec3& origin, const Vec3& axis) {
  Transform frame = Transform::Identity();
  frame.linear() = geometry::turn_from_z(axis).toRotationMatrix();
  frame.translation() = origin;
  return frame;
}

geometry::TriangleMesh rod(const Vec3& origin, const Vec3& axis, double radius_mm, double from_mm, double to_mm) {
  const std::array<kinematics::ProfilePoint, 4> profile{
      {{from_mm, 0.0}, {from_mm, radius_mm}, {to_mm, radius_mm}, {to_mm, 0.0}}};
  return view::moved_mesh(view::revolution_mesh(profile), standing_on(origin, axis));
}

void add_post(FieldCase& one, const Vec3& passing_mm, const Vec3& axis) {
  const Transform frame = standing_on(passing_mm, axis);
  for (int k = 0; k < keys_a_post; ++k) {
    const double angle = turn * (k + 0.5) / keys_a_post;
    const Vec3 start = frame * Vec3(post_radius_mm * std::cos(angle), post_radius_mm * std::sin(angle), 0.0);
    const Vec3 point = on_strip(start, axis);
    one.keys.push_back({{strip_parameters(point), point}, axis});
  }
  one.obstacles_P.push_back(rod(passing_mm, axis, post_radius_mm, -4.0, post_height_mm));
}

/// Radius of the assumed pin over its height, both in shares: foot, belly, neck, head.
double pin_radius_share(double u) {
  const double belly = std::sin(pi * std::pow(u, 0.62));
  return 0.22 + 0.62 * belly * (1.0 - 0.55 * u) + 0.16 * std::exp(-std::pow((u - 0.86) / 0.08, 2));
}

double pin_height_mm() { return pin_ratio * pi * pin_diameter_mm; }

double greatest_pin_share() {
  double most = 0.0;
  for (int i = 0; i <= 400; ++i) most = std::max(most, pin_radius_share(i / 400.0));
  return most;
}

Vec3 pin_point(const Vec2& uv) {
  static const double unit_mm = 0.5 * pin_diameter_mm / greatest_pin_share();
  const double radius_mm = unit_mm * pin_radius_share(uv.x());
  return {radius_mm * std::cos(turn * uv.y()), radius_mm * std::sin(turn * uv.y()), pin_height_mm() * uv.x()};
}

Vec3 pin_normal(const Vec2& uv) {
  constexpr double h = 1e-4;
  const double u = std::min(std::max(uv.x(), h), 1.0 - h);
  const Vec3 up = pin_point({u + h, uv.y()}) - pin_point({u - h, uv.y()});
  const Vec3 round(-std::sin(turn * uv.y()), std::cos(turn * uv.y()), 0.0);
  return round.cross(up).normalized();
}

/// Keys round both ends of the rod, along it and outwards: at `side` +1 (y > 0) and -1.
void add_rod_end(FieldCase& one, double side) {
  const double v_centre = side > 0.0 ? 0.25 : 0.75;
  const double radius_mm = pin_point({rod_height_share, 0.0}).x();
  for (int k = 0; k < keys_a_rod_end; ++k) {
    const double angle = turn * k / keys_a_rod_end;
    const Vec2 uv(rod_height_share + rod_radius_mm * std::sin(angle) / pin_height_mm(),
                  v_centre + rod_radius_mm * std::cos(angle) / (turn * radius_mm));
    one.keys.push_back({{uv, pin_point(uv)}, side * Vec3::UnitY()});
  }
}

Vec3 sphere_direction(double lean_rad, double around_rad) {
  return {std::sin(lean_rad) * std::cos(around_rad), std::sin(lean_rad) * std::sin(around_rad), std::cos(lean_rad)};
}

}  // namespace

FieldCase arched_strip_case() {
  FieldCase one;
  one.name = "arched strip";
  one.point_P_mm = strip_point;
  one.normal_P = [](const Vec2& uv) {
    const double angle = (2.0 * uv.x() - 1.0) * strip_half_angle();
    return Vec3(std::sin(angle), 0.0, std::cos(angle));
  };
  const std::array<std::pair<Vec2, Vec3>, 4> corners{
      {{{0, 0}, {0, 1, 4}}, {{1, 0}, {1, 1, 1}}, {{0, 1}, {1, 1, 4}}, {{1, 1}, {1, 0, 1}}}};
  for (const auto& [uv, axis] : corners) one.keys.push_back({{uv, strip_point(uv)}, axis.normalized()});
  add_post(one, {9.93390, 10.0, 1.57440}, Vec3(2, 1, 2).normalized());
  add_post(one, {30.0, 10.0, 2.83766}, Vec3(2, 0, 2).normalized());
  add_post(one, {50.06610, 10.0, 1.57440}, Vec3(2, -1, 2).normalized());
  one.basis = {planner::BasisKind::inverse_multiquadric, 0.8, 1.0, 2};
  one.metric.distance = planner::FieldDistance::straight_mm;
  one.spline = {30, 10, false, planner::KnotRule::averaged};
  one.index_rows = 900;
  one.index_columns = 300;
  return one;
}

FieldCase bowling_pin_case() {
  FieldCase one;
  one.name = "bowling pin";
  one.point_P_mm = pin_point;
  one.normal_P = pin_normal;
  for (int i = 0; i < pin_key_rows; ++i)
    for (int j = 0; j < pin_key_columns; ++j) {
      const Vec2 uv(static_cast<double>(i) / (pin_key_rows - 1), static_cast<double>(j) / pin_key_columns);
      const double from_rod = std::abs(uv.x() - rod_height_share) * pin_height_mm();
      if (from_rod > 2.5 * rod_radius_mm) one.keys.push_back({{uv, pin_point(uv)}, pin_normal(uv)});
    }
  add_rod_end(one, 1.0);
  add_rod_end(one, -1.0);
  one.obstacles_P.push_back(rod({0.0, 0.0, rod_height_share * pin_height_mm()}, Vec3::UnitY(), rod_radius_mm,
                                -0.5 * rod_length_mm, 0.5 * rod_length_mm));
  one.basis = {planner::BasisKind::half_open, 0.4, 1.0, 2};
  one.metric = {planner::FieldDistance::cylinder, pin_ratio};
  one.spline = {30, 20, true, planner::KnotRule::averaged};
  one.index_rows = 60;
  one.index_columns = 100;
  one.unit_axes = false;
  return one;
}

FieldCase half_sphere_case() {
  FieldCase one;
  one.name = "half-sphere";
  one.normal_P = [](const Vec2& uv) { return sphere_direction(0.5 * pi * uv.x(), turn * uv.y()); };
  one.point_P_mm = [](const Vec2& uv) -> Vec3 {
    return sphere_radius_mm * sphere_direction(0.5 * pi * uv.x(), turn * uv.y());
  };
  for (int i = 0; i < sphere_key_rows; ++i)
    for (int j = 0; j < sphere_key_columns; ++j) {
      const Vec2 uv(static_cast<double>(i) / (sphere_key_rows - 1), static_cast<double>(j) / sphere_key_columns);
      one.keys.push_back({{uv, one.point_P_mm(uv)}, sphere_direction(0.5 * pi * uv.x() + key_lean_rad, turn * uv.y())});
    }
  one.basis = {planner::BasisKind::half_open, 0.4, 1.0, 2};
  one.metric = {planner::FieldDistance::cylinder, 1.0 / turn};  // height R over pi times diameter 2 R
  one.spline = {8, 32, true, planner::KnotRule::eq3};
  one.index_rows = 80;
  one.index_columns = 480;
  one.unit_axes = false;
  return one;
}

Vec3 interpolated_axis(const FieldCase& one, const planner::RbfField& field, const Vec2& uv) {
  const Vec3 raw = field.raw({uv, one.point_P_mm(uv)});
  return one.unit_axes ? raw.normalized() : raw;
}

Result<CaseFields> fields_of(const FieldCase& one) {
  auto interpolation = planner::RbfField::fit(one.keys, one.basis, one.metric);
  if (!interpolation) return tl::unexpected(interpolation.error());
  planner::FieldSpline spline([&](const Vec2& uv) { return interpolated_axis(one, *interpolation, uv); }, one.spline);
  return CaseFields{std::move(*interpolation), std::move(spline)};
}

geometry::TriangleMesh mesh_of(const FieldCase& one, int rows, int columns) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j)
      mesh.vertices_mm.push_back(one.point_P_mm({static_cast<double>(i) / rows, static_cast<double>(j) / columns}));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const geometry::Index a = i * (columns + 1) + j, b = a + columns + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  return mesh;
}

}  // namespace volute::app
