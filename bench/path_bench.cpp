// The harmonic map of a sheet of about 30,000 triangles onto a rectangle: ours against CGAL's, same mesh, same fixed
// boundary.
#include <benchmark/benchmark.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <cmath>
#include <numbers>

#include "planner/path/cc_path.hpp"
#include "planner/surface/annulus.hpp"
#include "planner/surface/surface_map.hpp"

namespace {

using volute::geometry::Index;
using volute::geometry::TriangleMesh;
using volute::geometry::Vec3;

/// A wavy ring, 240 by 64 cells.
TriangleMesh wavy_ring() {
  constexpr int around = 240, across = 64;
  TriangleMesh mesh;
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i < around; ++i) {
      const double radius = 12.0 + 38.0 * j / across, angle = 2.0 * std::numbers::pi * i / around;
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      mesh.vertices_mm.emplace_back(x, y, 2.0 * std::sin(x / 15.0) * std::cos(y / 12.0));
    }
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < around; ++i) {
      const Index a = j * around + i, b = j * around + (i + 1) % around, c = b + around, d = a + around;
      mesh.triangles.push_back({a, c, b});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

const volute::planner::Annulus& sheet() {
  static const auto annulus = volute::planner::make_annulus(wavy_ring());
  return *annulus;
}

void ours_harmonic_map(benchmark::State& state) {
  const auto& annulus = sheet();
  for (auto _ : state) benchmark::DoNotOptimize(volute::planner::rectangle_map(annulus));
  state.counters["triangles"] = static_cast<double>(annulus.sheet.triangles.size());
}
BENCHMARK(ours_harmonic_map)->Unit(benchmark::kMillisecond);

using Kernel = CGAL::Simple_cartesian<double>;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace smp = CGAL::Surface_mesh_parameterization;

CgalMesh cgal_mesh() {
  CgalMesh mesh;
  for (const Vec3& v : sheet().sheet.vertices_mm) mesh.add_vertex({v.x(), v.y(), v.z()});
  const auto vertex = [](Index v) { return CgalMesh::Vertex_index(static_cast<CgalMesh::size_type>(v)); };
  for (const auto& t : sheet().sheet.triangles) mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  return mesh;
}

/// Cotangent weights, boundary fixed on a square by arc length: two linear solves with CGAL's default solver.
void cgal_harmonic_map(benchmark::State& state) {
  CgalMesh mesh = cgal_mesh();
  auto uv = mesh.add_property_map<CgalMesh::Vertex_index, Kernel::Point_2>("uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  using Border = smp::Square_border_arc_length_parameterizer_3<CgalMesh>;
  using Parameterizer = smp::Discrete_conformal_map_parameterizer_3<CgalMesh, Border>;
  for (auto _ : state) {
    const auto error = smp::parameterize(mesh, Parameterizer(), border, uv);
    if (error != smp::OK) state.SkipWithError("CGAL found no map");
  }
}
BENCHMARK(cgal_harmonic_map)->Unit(benchmark::kMillisecond);

/// Everything from the mesh to measured CC points, method periodic.
void plan_periodic_spiral(benchmark::State& state) {
  const TriangleMesh mesh = wavy_ring();
  volute::planner::PathOptions options;
  options.method = volute::planner::Method::periodic;
  options.scallop_mm = 0.2;
  for (auto _ : state) benchmark::DoNotOptimize(volute::planner::plan_cc_path(mesh, {}, options, {}));
}
BENCHMARK(plan_periodic_spiral)->Unit(benchmark::kMillisecond);

}  // namespace
