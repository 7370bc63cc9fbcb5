// The smoothing's linear algebra at a million points beside LAPACK's banded Cholesky in the same run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "planner/orientation/banded.hpp"
#include "planner/orientation/smooth_curve.hpp"

extern "C" void dpbsv_(const char* uplo, const int* n, const int* bands, const int* right_sides, double* matrix,
                       const int* leading, double* right, const int* leading_right, int* info);

namespace volute::planner {
namespace {

constexpr int points = 1000000;

/// A pentadiagonal matrix well inside positive definite, so that both solvers do the same work to the same answer.
constexpr double diagonal = 7.0, beside = -4.0, next = 1.0;

void BM_Dpbsv(benchmark::State& state) {
  for (auto run : state) {
    state.PauseTiming();
    std::vector<double> band(3 * static_cast<std::size_t>(points)), right(static_cast<std::size_t>(points), 1.0);
    for (std::size_t i = 0; i < right.size(); ++i)
      band[3 * i] = diagonal, band[3 * i + 1] = beside, band[3 * i + 2] = next;
    state.ResumeTiming();
    const int bands = 2, one = 1, leading = 3;
    int info = 0;
    dpbsv_("L", &points, &bands, &one, band.data(), &leading, right.data(), &points, &info);
    benchmark::DoNotOptimize(right.data());
  }
}
BENCHMARK(BM_Dpbsv)->Unit(benchmark::kMillisecond);

void BM_OwnPentadiagonalSweep(benchmark::State& state) {
  for (auto run : state) {
    state.PauseTiming();
    BandMatrix<2> matrix(static_cast<std::size_t>(points), {diagonal, beside, next});
    std::vector<double> right(static_cast<std::size_t>(points), 1.0);
    state.ResumeTiming();
    factor_banded<2>(matrix);
    solve_banded<2>(matrix, right);
    benchmark::DoNotOptimize(right.data());
  }
}
BENCHMARK(BM_OwnPentadiagonalSweep)->Unit(benchmark::kMillisecond);

void BM_LeastAcceleration(benchmark::State& state) {
  std::vector<double> s(static_cast<std::size_t>(points));
  for (std::size_t i = 0; i < s.size(); ++i) s[i] = 0.3 * static_cast<double>(i);
  std::vector<Pin> pins;
  for (int i = 0; i < points; i += 999) pins.push_back({i, std::sin(0.001 * i)});
  for (auto run : state) benchmark::DoNotOptimize(least_acceleration(s, pins, Weights::arc_length));
}
BENCHMARK(BM_LeastAcceleration)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace volute::planner
