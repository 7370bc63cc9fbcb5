// Reading an STL of 500,000 triangles and joining its vertices, against Assimp doing the same; then neighbourhood and
// curvature.
#include <benchmark/benchmark.h>

#include <assimp/postprocess.h>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>

#include "geometry/mesh_io.hpp"
#include "geometry/mesh_measure.hpp"

namespace {

using namespace volute::geometry;

TriangleMesh wave() {
  constexpr Index side = 501;
  TriangleMesh mesh;
  for (Index j = 0; j < side; ++j)
    for (Index i = 0; i < side; ++i)
      mesh.vertices_mm.emplace_back(0.2 * i, 0.2 * j, 3.0 * std::sin(0.02 * i) * std::cos(0.03 * j));
  for (Index j = 0; j + 1 < side; ++j)
    for (Index i = 0; i + 1 < side; ++i) {
      const Index corner = j * side + i;
      mesh.triangles.push_back({corner, corner + 1, corner + side + 1});
      mesh.triangles.push_back({corner, corner + side + 1, corner + side});
    }
  return mesh;
}

const std::filesystem::path& wave_file() {
  static const std::filesystem::path file = [] {
    const auto path = std::filesystem::temp_directory_path() / "volute-geometry-bench.stl";
    if (!save_stl(path, wave())) std::abort();
    return path;
  }();
  return file;
}

void read_and_weld(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(load_mesh(wave_file()));
}
BENCHMARK(read_and_weld)->Unit(benchmark::kMillisecond);

void read_and_weld_by_assimp(benchmark::State& state) {
  for (auto _ : state) {
    Assimp::Importer importer;
    benchmark::DoNotOptimize(importer.ReadFile(wave_file().string(), aiProcess_JoinIdenticalVertices));
  }
}
BENCHMARK(read_and_weld_by_assimp)->Unit(benchmark::kMillisecond);

void build_topology(benchmark::State& state) {
  const TriangleMesh mesh = wave();
  for (auto _ : state) benchmark::DoNotOptimize(MeshTopology::build(mesh));
}
BENCHMARK(build_topology)->Unit(benchmark::kMillisecond);

void curvature(benchmark::State& state) {
  const TriangleMesh mesh = wave();
  for (auto _ : state) benchmark::DoNotOptimize(triangle_curvature(mesh));
}
BENCHMARK(curvature)->Unit(benchmark::kMillisecond);

}  // namespace
