// A picture of 500,000 triangles at 1600 x 1200, beside the limit of 2.5 s that it has; and the data of a page of
// 200,000 samples.
#include <benchmark/benchmark.h>

#include <cmath>

#include "view/colour_map.hpp"
#include "view/packed_data.hpp"
#include "view/renderer.hpp"

namespace {

using namespace volute::view;

constexpr double limit_s = 2.5;
constexpr int side = 500;  // 2 x 500 x 500 triangles

volute::geometry::TriangleMesh waves() {
  volute::geometry::TriangleMesh mesh;
  for (int row = 0; row <= side; ++row)
    for (int column = 0; column <= side; ++column)
      mesh.vertices_mm.emplace_back(0.4 * column, 0.4 * row, 8.0 * std::sin(column / 40.0) * std::cos(row / 55.0));
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const int a = row * (side + 1) + column, b = a + side + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  return mesh;
}

void picture(benchmark::State& state) {
  const auto mesh = waves();
  Box box;
  for (const Vec3& vertex : mesh.vertices_mm) grow(box, vertex);
  Scene3d scene;
  ShadedMesh shaded{&mesh, {}, {}, 1.0F};
  for (const Vec3& vertex : mesh.vertices_mm) shaded.vertex_colours.push_back(diverging_colour(vertex.z() / 8.0));
  scene.meshes.push_back(std::move(shaded));
  const Camera camera = fit_camera(box, {-0.35, -0.9, 1.15}, 4.0 / 3.0);
  std::size_t bytes = 0;
  for (auto _ : state) {
    const auto image = render(scene, camera, 1600, 1200);
    if (!image) return state.SkipWithError(image.error().message.c_str());
    bytes = png_bytes(*image).size();
  }
  state.counters["png_bytes"] = static_cast<double>(bytes);
  state.counters["share_of_2.5_s"] = benchmark::Counter(static_cast<double>(state.iterations()) * limit_s,
                                                        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(picture)->Name("picture_of_500000_triangles")->Unit(benchmark::kMillisecond)->UseRealTime();

void page_data(benchmark::State& state) {
  std::vector<double> curve(200'000);
  for (std::size_t i = 0; i < curve.size(); ++i)
    curve[i] = std::sin(static_cast<double>(i) / 70.0) * (1.0 + static_cast<double>(i % 7) * 0.01);
  for (auto _ : state) {
    PackedData data;
    for (int column = 0; column < 35; ++column) data.add_curve("c" + std::to_string(column), curve);
    benchmark::DoNotOptimize(base64_text(zlib_bytes(data.bytes())));
  }
}
BENCHMARK(page_data)->Name("page_data_of_35_columns_of_200000")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
