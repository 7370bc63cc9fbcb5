// Lots of samples, axis by axis, against their definitions cycle by cycle.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "sim/controller/axis_filter.hpp"
#include "sim/controller/column_kernels.hpp"

namespace volute::sim {
namespace {

std::vector<double> random_column(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> unit(-3.0, 3.0);
  std::vector<double> out(static_cast<std::size_t>(count));
  for (double& value : out) value = unit(random);
  return out;
}

TEST(ColumnKernels, AreTheirDefinitionsToTheLastBitAtEveryLength) {
  std::mt19937_64 random(5);
  for (int count = 0; count <= 67; ++count) {
    const auto n = static_cast<std::size_t>(count);
    const auto x = random_column(random, count + 1), y = random_column(random, count);
    std::vector<double> out(n);
    quadratic(0.3, -1.7, 0.11, x.data(), count, out.data());
    for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(out[k], 0.3 + x[k] * (-1.7 + x[k] * 0.11));
    linear(0.3, -1.7, x.data(), count, out.data());
    for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(out[k], 0.3 + -1.7 * x[k]);
    even_steps(0.1, 0.001, 7, count, out.data());
    for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(out[k], 0.1 + 0.001 * static_cast<double>(7 + k));
    scaled_difference(x.data() + 1, x.data(), 1000.0, count, out.data());  // neighbours, as the filter asks
    for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(out[k], (x[k + 1] - x[k]) * 1000.0);
    double size = 0.0, least = 1.0, most = -1.0, expected_least = 1.0, expected_most = -1.0;
    for (const double value : y) {
      size = std::max(size, std::abs(value));
      expected_least = std::min(expected_least, value);
      expected_most = std::max(expected_most, value);
    }
    ASSERT_EQ(greatest_magnitude(y.data(), count), size) << count;
    extend_range(y.data(), count, least, most);
    ASSERT_EQ(least, expected_least) << count;
    ASSERT_EQ(most, expected_most) << count;
  }
}

TEST(AxisFilter, IsTheMeanOfTheLastInputsHoweverTheyComeIn) {
  constexpr int n = 13, cycles = 500;
  constexpr double period_s = 0.002;
  std::mt19937_64 random(6);
  std::vector<kinematics::AxisVector> inputs(n, kinematics::AxisVector::Constant(0.5));  // rest before the first
  for (int k = 0; k < cycles; ++k) inputs.push_back(kinematics::AxisVector::Random());
  const auto mean = [&](int k) {  // after cycle k; inputs[k + n] is its own
    kinematics::AxisVector sum = kinematics::AxisVector::Zero();
    for (int back = 0; back < n; ++back) sum += inputs[static_cast<std::size_t>(std::max(0, k + n - back))];
    return kinematics::AxisVector(sum / n);
  };
  AxisFilter filter;
  filter.rest(n, period_s, inputs.front());
  SampleColumns out;
  std::uniform_int_distribution<int> portion(1, SampleColumns::size);
  for (int done = 0; done < cycles;) {
    const int count = std::min(portion(random), cycles - done);
    for (int axis = 0; axis < kinematics::axis_count; ++axis)
      for (int k = 0; k < count; ++k) filter.inputs(axis)[k] = inputs[static_cast<std::size_t>(done + k + n)][axis];
    filter.pass(count, out);
    for (int k = 0; k < count; ++k) {
      const int at = done + k;
      const auto m0 = mean(at), m1 = mean(at - 1), m2 = mean(at - 2), m3 = mean(at - 3);
      for (std::size_t i = 0; i < kinematics::axis_count; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        ASSERT_NEAR(out.position[i][k], m0[axis], 1e-12);
        ASSERT_NEAR(out.velocity[i][k], (m0 - m1)[axis] / period_s, 1e-10);
        ASSERT_NEAR(out.acceleration[i][k], (m0 - 2.0 * m1 + m2)[axis] / std::pow(period_s, 2), 1e-7);
        ASSERT_NEAR(out.jerk[i][k], (m0 - 3.0 * m1 + 3.0 * m2 - m3)[axis] / std::pow(period_s, 3), 1e-4);
      }
    }
    done += count;
  }
}

}  // namespace
}  // namespace volute::sim
