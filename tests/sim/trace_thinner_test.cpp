#include "sim/trace_thinner.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace volute::sim {
namespace {

kinematics::Machine unit_machine() {
  kinematics::Machine m;
  for (auto& axis : m.axes) axis.velocity_max = axis.acceleration_max = axis.jerk_max = 1.0;
  return m;
}

std::vector<AxisSample> run(std::size_t count, std::size_t peak_at) {
  std::vector<AxisSample> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    out[i].time_s = 0.001 * static_cast<double>(i);
    out[i].position = out[i].velocity = out[i].acceleration = out[i].jerk = out[i].actual = AxisVector::Zero();
    out[i].velocity[1] = i == peak_at ? 0.9 : 0.1 + 1e-6 * static_cast<double>(i % 7);
  }
  return out;
}

TEST(TraceThinner, KeepsFewSamplesTheEndsAndThePeak) {
  const auto machine = unit_machine();
  for (const std::size_t peak : {0u, 777u, 49999u, 99998u, 99999u}) {
    TraceThinner thinner(machine, 1000);
    const auto samples = run(100000, peak);
    for (std::size_t i = 0; i < samples.size(); i += 1000) thinner.add(std::span(samples).subspan(i, 1000));
    const auto kept = thinner.finish();
    EXPECT_LE(kept.size(), 1000u);
    EXPECT_GE(kept.size(), 250u);
    EXPECT_EQ(kept.front().time_s, 0.0);
    EXPECT_EQ(kept.back().time_s, samples.back().time_s);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(), [](auto& a, auto& b) { return a.time_s < b.time_s; }));
    EXPECT_EQ(std::count_if(kept.begin(), kept.end(), [](auto& s) { return s.velocity[1] == 0.9; }), 1) << peak;
  }
}

TEST(TraceThinner, AShortRunIsKeptWhole) {
  const auto machine = unit_machine();
  TraceThinner thinner(machine, 1000);
  thinner.add(run(300, 5));
  EXPECT_EQ(thinner.finish().size(), 300u);
}

}  // namespace
}  // namespace volute::sim
