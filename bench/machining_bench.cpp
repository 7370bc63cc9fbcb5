// Virtual machining against its limits: every counter "of_limit" is CPU time of all threads over what two cores have in
// the time allowed, below 1 is good.
#include <benchmark/benchmark.h>

#include <cmath>

#include "sim/machining/cut_surface.hpp"
#include "sim/machining/stock.hpp"

namespace {

using volute::geometry::TriangleMesh;
using volute::geometry::Vec3;
using volute::sim::SweptPose;

double height(double x, double y) { return 6 * std::sin(x / 14) * std::cos(y / 11); }
Vec3 normal(double x, double y) {
  return Vec3(-6 / 14. * std::cos(x / 14) * std::cos(y / 11), 6 / 11. * std::sin(x / 14) * std::sin(y / 11), 1)
      .normalized();
}

/// A five-axis finishing path over the wavy square of 100 mm: passes `interval` apart, poses `step` apart.
std::vector<SweptPose> passes(double radius, double interval, double step, std::size_t most) {
  std::vector<SweptPose> poses;
  int pass = 0;
  for (double x = 0; x <= 100 && poses.size() < most; x += interval, ++pass) {
    for (double s = 0; s <= 100 && poses.size() < most; s += step) {
      const double y = pass % 2 == 0 ? s : 100 - s, a = 0.2 + 0.1 * std::sin(x / 10), c = 0.35 * std::sin(y / 15);
      const Vec3 axis(std::sin(c) * std::sin(a), -std::cos(c) * std::sin(a), std::cos(a));
      const Vec3 centre = Vec3(x, y, height(x, y)) + radius * normal(x, y);
      poses.push_back({{centre - radius * axis, axis}, static_cast<std::int64_t>(poses.size()), 0.0, false});
    }
  }
  return poses;
}

TriangleMesh sheet(int cuts) {
  TriangleMesh mesh;
  for (int j = 0; j <= cuts; ++j) {
    for (int i = 0; i <= cuts; ++i)
      mesh.vertices_mm.emplace_back(100.0 * i / cuts, 100.0 * j / cuts, height(100.0 * i / cuts, 100.0 * j / cuts));
  }
  for (int j = 0; j < cuts; ++j) {
    for (int i = 0; i < cuts; ++i) {
      const int v = j * (cuts + 1) + i;
      mesh.triangles.push_back({v, v + 1, v + cuts + 2});
      mesh.triangles.push_back({v, v + cuts + 2, v + cuts + 1});
    }
  }
  return mesh;
}

/// 100,000 five-axis segments may take 20 s on two cores with a 0.1 mm grid on a 100 mm part.
void StockSegments(benchmark::State& state) {
  const auto poses = passes(3.0, 0.8, 0.125, 100'001);
  const volute::kinematics::Cutter ball{volute::kinematics::CutterShape::ball, 3, 3, {}, 20, 2};
  for (auto _ : state) {
    state.PauseTiming();
    auto stock = volute::sim::Stock::box({0, 0, -20}, {100, 100, 7}, 0.1);
    state.ResumeTiming();
    benchmark::DoNotOptimize(stock.cut(ball, poses, 0.01));
  }
  state.counters["segments"] = static_cast<double>(poses.size() - 1);
  state.counters["of_limit"] = benchmark::Counter(2.0 * 20.0 * static_cast<double>(poses.size() - 1) / 100'000.0,
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(StockSegments)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->Iterations(1);

/// The cut surface of a run of 11 m over 28,000 triangles may take 2 s of the 6 s that a whole verification may.
void CutSurface(benchmark::State& state) {
  const auto poses = passes(1.0, 0.9, 0.37, 1'000'000);
  const auto surface = sheet(118);
  const volute::kinematics::Cutter ball{volute::kinematics::CutterShape::ball, 1, 1, {}, 20, 2};
  volute::sim::CutSurfaceReport report;
  for (auto _ : state) report = volute::sim::measure_cut_surface(surface, ball, poses, {.uncut_limit_mm = 0.15});
  state.counters["samples_per_s"] = benchmark::Counter(
      static_cast<double>(report.samples) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["of_limit"] = benchmark::Counter(2.0 * 2.0 * static_cast<double>(state.iterations()),
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(CutSurface)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->Iterations(2);

}  // namespace
