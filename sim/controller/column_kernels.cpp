#include "sim/controller/column_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

// One clone for AVX2, one for every processor, chosen when the program is loaded; the sanitizers cannot load such
// programs.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VOLUTE_WIDEST __attribute__((target_clones("avx2", "default")))
#else
#define VOLUTE_WIDEST
#endif

namespace volute::sim {

namespace {

/// Four numbers at any address; the compiler takes one register or two for them.
using Four = double __attribute__((vector_size(32), aligned(8), may_alias));
constexpr int lanes = 4;

}  // namespace

VOLUTE_WIDEST void even_steps(double start, double step, int first, int count, double* out) {
  for (int k = 0; k < count; ++k) out[k] = start + step * static_cast<double>(first + k);
}

VOLUTE_WIDEST void linear(double c0, double c1, const double* x, int count, double* __restrict out) {
  for (int k = 0; k < count; ++k) out[k] = c0 + c1 * x[k];
}

VOLUTE_WIDEST void quadratic(double c0, double c1, double c2, const double* x, int count, double* __restrict out) {
  for (int k = 0; k < count; ++k) out[k] = c0 + x[k] * (c1 + x[k] * c2);
}

VOLUTE_WIDEST void scaled_difference(const double* from, const double* minus, double scale, int count,
                                     double* __restrict out) {
  for (int k = 0; k < count; ++k) out[k] = (from[k] - minus[k]) * scale;
}

VOLUTE_WIDEST double greatest_magnitude(const double* x, int count) {
  Four most{}, most2{};
  int k = 0;
  for (; k + 2 * lanes <= count; k += 2 * lanes) {
    const Four value = *reinterpret_cast<const Four*>(x + k), value2 = *reinterpret_cast<const Four*>(x + k + lanes);
    const Four size = value < 0.0 ? -value : value, size2 = value2 < 0.0 ? -value2 : value2;
    most = most < size ? size : most;
    most2 = most2 < size2 ? size2 : most2;
  }
  double all = 0.0;
  for (; k < count; ++k) all = std::max(all, std::abs(x[k]));
  for (int lane = 0; lane < lanes; ++lane) all = std::max({all, most[lane], most2[lane]});
  return all;
}

VOLUTE_WIDEST void extend_range(const double* x, int count, double& least, double& most) {
  Four low = least - Four{}, high = most - Four{};
  int k = 0;
  for (; k + lanes <= count; k += lanes) {
    const Four value = *reinterpret_cast<const Four*>(x + k);
    low = value < low ? value : low;
    high = high < value ? value : high;
  }
  for (; k < count; ++k) {
    least = std::min(least, x[k]);
    most = std::max(most, x[k]);
  }
  for (int lane = 0; lane < lanes; ++lane) {
    least = std::min(least, low[lane]);
    most = std::max(most, high[lane]);
  }
}

}  // namespace volute::sim
