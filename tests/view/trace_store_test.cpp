// What a file keeps of a run's samples: near enough, the same every time, and the same again when it is kept again.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/view/example_run.hpp"
#include "view/trace_store.hpp"

namespace volute::view {
namespace {

constexpr unsigned seed = 20260101;

sim::TraceView random_trace(int count) {
  std::mt19937 random(seed);
  std::normal_distribution<double> any(0.0, 1.0);
  sim::TraceView trace;
  for (int i = 0; i < count; ++i) {
    sim::AxisSample sample;
    sample.time_s = 0.004 * i + 1e-4 * std::abs(any(random));
    for (int axis = 0; axis < kinematics::axis_count; ++axis) {
      sample.position[axis] = 300.0 * any(random);
      sample.actual[axis] = sample.position[axis] + 0.01 * any(random);
      sample.velocity[axis] = 50.0 * any(random);
      sample.acceleration[axis] = 1e3 * any(random);
      sample.jerk[axis] = 1e5 * any(random);
    }
    sample.line = 1000 + i / 3;
    sample.tip_speed_mm_s = std::abs(5.0 * any(random));
    sample.limit = static_cast<sim::Limit>(i % 10);
    sample.limiting_axis = static_cast<std::int8_t>(i % 6 - 1);
    sample.rapid = i % 4 == 0;
    sample.cutting = i % 3 == 0;
    trace.samples.push_back(sample);
    const geometry::Vec3 axis = geometry::Vec3(any(random), any(random), 3.0).normalized();
    trace.poses_P.push_back({{100.0 * any(random), any(random), any(random)}, axis});
  }
  return trace;
}

TEST(TraceStore, ValuesComeBackWithinHalfAStep) {
  const sim::TraceView trace = random_trace(500);
  const auto back = unpacked_trace(packed_trace(trace));
  ASSERT_TRUE(back);
  ASSERT_EQ(back->samples.size(), trace.samples.size());
  double jerk_max = 0.0;
  for (const sim::AxisSample& sample : trace.samples) jerk_max = std::max(jerk_max, std::abs(sample.jerk[1]));
  for (std::size_t i = 0; i < trace.samples.size(); ++i) {
    const sim::AxisSample &a = trace.samples[i], &b = back->samples[i];
    EXPECT_NEAR(b.time_s, a.time_s, std::ldexp(0.5, -17)) << "seed " << seed << " sample " << i;
    EXPECT_NEAR(b.position[0], a.position[0], std::ldexp(0.5, -17)) << "seed " << seed << " sample " << i;
    EXPECT_NEAR(b.actual[4], a.actual[4], std::ldexp(0.5, -20)) << "seed " << seed << " sample " << i;
    EXPECT_NEAR(b.jerk[1], a.jerk[1], 0.5 * jerk_max / 16384.0) << "seed " << seed << " sample " << i;
    EXPECT_NEAR((back->poses_P[i].axis_P - trace.poses_P[i].axis_P).norm(), 0.0, 1e-6) << "seed " << seed;
    EXPECT_EQ(b.line, a.line);
    EXPECT_EQ(b.limit, a.limit);
    EXPECT_EQ(b.limiting_axis, a.limiting_axis);
    EXPECT_EQ(b.rapid, a.rapid);
    EXPECT_EQ(b.cutting, a.cutting);
  }
}

TEST(TraceStore, WhatWasKeptOnceIsKeptUnchanged) {
  const sim::TraceView once = trace_as_stored(random_trace(300)), twice = trace_as_stored(once);
  for (std::size_t i = 0; i < once.samples.size(); ++i) {
    EXPECT_EQ(once.samples[i].time_s, twice.samples[i].time_s) << "seed " << seed << " sample " << i;
    EXPECT_EQ(once.samples[i].velocity, twice.samples[i].velocity) << "seed " << seed << " sample " << i;
    EXPECT_EQ(once.samples[i].jerk, twice.samples[i].jerk) << "seed " << seed << " sample " << i;
    EXPECT_EQ(once.poses_P[i].tip_P_mm, twice.poses_P[i].tip_P_mm) << "seed " << seed << " sample " << i;
  }
  EXPECT_TRUE(packed_trace(once) == packed_trace(twice));
}

TEST(TraceStore, AnAxisOfManyTurnsGetsAWiderStep) {
  sim::TraceView trace = random_trace(3);
  trace.samples[2].position[4] = 2.0 * 3.141592653589793 * 20'000.0;
  const auto back = unpacked_trace(packed_trace(trace));
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->samples[2].position[4], trace.samples[2].position[4], 1e-4);
}

TEST(TraceStore, ACutOffTraceIsNone) {
  const std::string bytes = packed_trace(random_trace(50));
  EXPECT_FALSE(unpacked_trace(std::string_view(bytes).substr(0, bytes.size() - 1)));
  EXPECT_FALSE(unpacked_trace(std::string_view(bytes).substr(0, 10)));
  EXPECT_FALSE(unpacked_trace(""));
}

}  // namespace
}  // namespace volute::view
