#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace volute::examples {

namespace {

using geometry::Index;
using geometry::TriangleMesh;
using geometry::Vec2;
using geometry::Vec3;
constexpr double pi = std::numbers::pi;
constexpr int outline_points = 720;

Vec2 placed(const Vec2& p, const Placement& place) {
  return place.centre + Eigen::Rotation2Dd(place.turn_deg * pi / 180.0) * p;
}

template <class Curve>
Polygon sampled(const Curve& curve, const Placement& place) {
  Polygon polygon;
  for (int i = 0; i < outline_points; ++i) polygon.push_back(placed(curve(2.0 * pi * i / outline_points), place));
  return polygon;
}

double signed_power(double value, double power) { return std::copysign(std::pow(std::abs(value), power), value); }

double hill(double x, double y, double sigma_mm) { return std::exp(-(x * x + y * y) / (2.0 * sigma_mm * sigma_mm)); }

/// Both rims of a cylinder as one ring each, then the two centres.
void append_rims(TriangleMesh& mesh, const Vec3& base, const Vec3& along, double radius_mm, double length_mm,
                 int sides) {
  const Vec3 u = along.unitOrthogonal(), v = along.cross(u);
  for (const double height : {0.0, length_mm})
    for (int i = 0; i < sides; ++i) {
      const double angle = 2.0 * pi * i / sides;
      mesh.vertices_mm.push_back(base + height * along + radius_mm * (std::cos(angle) * u + std::sin(angle) * v));
    }
  mesh.vertices_mm.push_back(base);
  mesh.vertices_mm.push_back(base + length_mm * along);
}

}  // namespace

Polygon ellipse(double half_x_mm, double half_y_mm, const Placement& place) {
  return sampled([&](double t) { return Vec2(half_x_mm * std::cos(t), half_y_mm * std::sin(t)); }, place);
}

Polygon rounded_rectangle(double width_mm, double height_mm, double corner_mm, const Placement& place) {
  constexpr int arc_points = 24;
  const double x = 0.5 * width_mm - corner_mm, y = 0.5 * height_mm - corner_mm;
  const Vec2 centres[4] = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
  Polygon polygon;
  for (int quarter = 0; quarter < 4; ++quarter)
    for (int i = 0; i <= arc_points; ++i) {
      const double angle = 0.5 * pi * (quarter + static_cast<double>(i) / arc_points);
      polygon.push_back(placed(centres[quarter] + corner_mm * Vec2(std::cos(angle), std::sin(angle)), place));
    }
  return polygon;
}

Polygon superellipse(double half_x_mm, double half_y_mm, double power) {
  return sampled(
      [&](double t) {
        return Vec2(half_x_mm * signed_power(std::cos(t), 2.0 / power),
                    half_y_mm * signed_power(std::sin(t), 2.0 / power));
      },
      {});
}

Polygon lobed_circle(double radius_mm, double share, int lobes, const Placement& place) {
  return sampled(
      [&](double t) { return Vec2(radius_mm * (1.0 + share * std::cos(lobes * t)) * Vec2(std::cos(t), std::sin(t))); },
      place);
}

double freeform_height_mm(double x_mm, double y_mm) {
  const double wave = 6.0 * std::sin(2.0 * pi * x_mm / 110.0 + 0.4) * std::cos(2.0 * pi * y_mm / 130.0);
  return wave + 7.0 * hill(x_mm - 18.0, y_mm - 20.0, 10.0) - 5.0 * hill(x_mm + 25.0, y_mm + 22.0, 11.0) +
         0.0015 * x_mm * x_mm;
}

double wavy_height_mm(double x_mm, double y_mm) {
  return 4.0 * std::cos(2.0 * pi * std::hypot(x_mm - 6.0, y_mm + 4.0) / 48.0) + 0.05 * x_mm;
}

TriangleMesh box(const Vec3& least_mm, const Vec3& greatest_mm) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices_mm.emplace_back((i & 1) != 0 ? greatest_mm.x() : least_mm.x(),
                                  (i & 2) != 0 ? greatest_mm.y() : least_mm.y(),
                                  (i & 4) != 0 ? greatest_mm.z() : least_mm.z());
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh cylinder(const Vec3& base_mm, const Vec3& axis, double radius_mm, double length_mm) {
  constexpr Index sides = 96;
  TriangleMesh mesh;
  append_rims(mesh, base_mm, axis.normalized(), radius_mm, length_mm, sides);
  for (Index i = 0; i < sides; ++i) {
    const Index next = (i + 1) % sides;
    mesh.triangles.push_back({i, next, sides + next});
    mesh.triangles.push_back({i, sides + next, sides + i});
    mesh.triangles.push_back({2 * sides, next, i});
    mesh.triangles.push_back({2 * sides + 1, sides + i, sides + next});
  }
  return mesh;
}

}  // namespace volute::examples
