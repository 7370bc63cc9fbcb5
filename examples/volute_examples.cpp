// Writes the STL parts of the example jobs into a folder. The same bytes every time.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numbers>
#include <system_error>

#include "geometry/mesh_io.hpp"
#include "mouse.hpp"
#include "shapes.hpp"

namespace volute::examples {

namespace {

using geometry::TriangleMesh;
using geometry::Vec2;
using geometry::Vec3;

/// Edge for which a triangle leaves its surface by at most 5 % of the scallop: circumradius^2 * curvature / 2 of an
/// equilateral one.
double edge_for_mm(double scallop_mm, double curvature_per_mm) {
  return std::sqrt(6.0 * 0.05 * scallop_mm / curvature_per_mm);
}

TriangleMesh lifted(const PlaneRegion& region, double edge_mm, const std::function<Vec3(const Vec2&)>& lift) {
  const PlaneMesh flat = mesh_plane(region, edge_mm);
  TriangleMesh mesh{{}, flat.triangles};
  for (const Vec2& p : flat.points_mm) mesh.vertices_mm.push_back(lift(p));
  return mesh;
}

TriangleMesh freeform(const PlaneRegion& region) {
  return lifted(region, edge_for_mm(0.2, 0.10),
                [](const Vec2& p) { return Vec3(p.x(), p.y(), freeform_height_mm(p.x(), p.y())); });
}

TriangleMesh wavy(const PlaneRegion& region) {
  return lifted(region, edge_for_mm(0.2, 0.075),
                [](const Vec2& p) { return Vec3(p.x(), p.y(), wavy_height_mm(p.x(), p.y())); });
}

/// [Huang2016] case 3, diameter 20. The stereographic map keeps angles, so the triangles stay well shaped down to the
/// equator.
TriangleMesh half_sphere() {
  constexpr double radius_mm = 10.0;
  return lifted({ellipse(2.0 * radius_mm, 2.0 * radius_mm), {}}, edge_for_mm(0.02, 0.1), [radius_mm](const Vec2& p) {
    const double polar = 2.0 * std::atan2(p.norm(), 2.0 * radius_mm), around = std::atan2(p.y(), p.x());
    return Vec3(radius_mm *
                Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)));
  });
}

/// [Huang2016] eq. 12: a strip of a cylinder of radius 160, laid flat by arc length.
TriangleMesh arched_strip() {
  constexpr double radius_mm = 160.0;
  const double half_angle = std::asin(30.0 / radius_mm), half_length_mm = radius_mm * half_angle;
  const Polygon outline = {
      {-half_length_mm, 0.0}, {half_length_mm, 0.0}, {half_length_mm, 20.0}, {-half_length_mm, 20.0}};
  return lifted({outline, {}}, 0.6, [=](const Vec2& p) {
    const double angle = p.x() / radius_mm;
    return Vec3(radius_mm * (std::sin(angle) + std::sin(half_angle)), p.y(),
                radius_mm * (std::cos(angle) - std::cos(half_angle)));
  });
}

struct Part {
  const char* name;
  std::function<TriangleMesh()> make;
};

std::vector<Part> parts() {
  return {
      {"plate-one-hole",
       [] {
         return freeform({rounded_rectangle(100, 100, 12), {ellipse(13, 8, {{5, -3}, 25})}});
       }},
      {"plate-two-holes",
       [] {
         return freeform({rounded_rectangle(110, 90, 10),
                          {ellipse(9, 9, {{-22, 8}, 0}), rounded_rectangle(22, 12, 4, {{20, -10}, 30})}});
       }},
      {"plate-three-holes",
       [] {
         return freeform({superellipse(52, 50, 4),
                          {ellipse(8, 8, {{-24, -18}, 0}), ellipse(11, 6, {{24, -14}, -20}),
                           lobed_circle(9, 0.15, 3, {{0, 24}, 90})}});
       }},
      {"disc-with-hole",
       [] {
         return wavy({ellipse(50, 50), {ellipse(18, 18)}});
       }},
      {"disc-wavy",
       [] {
         return wavy({ellipse(50, 50), {}});
       }},
      {"mouse", [] { return mouse_shell(0.85); }},
      {"obstacle-plate",
       [] {
         return freeform({rounded_rectangle(80, 60, 8), {ellipse(14, 14, {{-8, 0}, 0})}});
       }},
      {"obstacle-wall",
       [] {
         return box({46, -14, -15}, {52, 14, 70});
       }},
      {"obstacle-post",
       [] {
         return cylinder({-8, 0, -20}, Vec3::UnitZ(), 7.0, 80.0);
       }},
      {"half-sphere", half_sphere},
      {"arched-strip", arched_strip},
  };
}

int write_parts(const std::filesystem::path& folder) {
  std::error_code status;
  std::filesystem::create_directories(folder, status);
  for (const Part& part : parts()) {
    const auto saved = geometry::save_stl(folder / (std::string(part.name) + ".stl"), part.make());
    if (saved) continue;
    std::fprintf(stderr, "volute_examples: %s\n", saved.error().message.c_str());
    return 3;
  }
  return 0;
}

}  // namespace

}  // namespace volute::examples

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: volute_examples FOLDER   writes the example parts there as STL\n");
    return 2;
  }
  return volute::examples::write_parts(argv[1]);
}
