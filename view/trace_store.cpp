#include "view/trace_store.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "geometry/check.hpp"
#include "view/packed_data.hpp"

namespace volute::view {

namespace {

using kinematics::AxisVector;
using sim::AxisSample;

constexpr int axis_count = kinematics::axis_count;
constexpr int first_rotary = 3;
const double stored_length_step_mm = std::ldexp(1.0, -17), angle_step_rad = std::ldexp(1.0, -20),
             stored_time_step_s = std::ldexp(1.0, -17), stored_direction_step = std::ldexp(1.0, -20);
constexpr double steps_max = 2147483000.0;
constexpr int curve_bits = 15;

struct AxisColumn {
  const char* name;
  AxisVector AxisSample::*member;
};
constexpr std::array<AxisColumn, 3> curve_columns{
    {{"velocity", &AxisSample::velocity}, {"acceleration", &AxisSample::acceleration}, {"jerk", &AxisSample::jerk}}};

double greatest_magnitude(const std::vector<double>& values) {
  double greatest = 0.0;
  for (const double value : values) greatest = std::max(greatest, std::abs(value));
  return greatest;
}

/// `finest`, doubled until every value fits.
double fine_step(const std::vector<double>& values, double finest) {
  double step = finest;
  for (const double greatest = greatest_magnitude(values); greatest / step > steps_max;) step *= 2.0;
  return step;
}

/// A power of two, so that values that were rounded by it are rounded to themselves.
double curve_step(const std::vector<double>& values) {
  const double greatest = greatest_magnitude(values);
  return greatest > 0.0 ? std::ldexp(1.0, static_cast<int>(std::ceil(std::log2(greatest))) - curve_bits) : 1.0;
}

template <class Rows, class Get>
std::vector<double> column(const Rows& rows, const Get& get) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const auto& row : rows) values.push_back(get(row));
  return values;
}

void add_fine(PackedData& data, const std::string& name, const std::vector<double>& values, double finest) {
  data.add(name, values, fine_step(values, finest));
}
void add_rough(PackedData& data, const std::string& name, const std::vector<double>& values) {
  data.add(name, values, curve_step(values));
}

template <class Get>
void add_integers(PackedData& data, const std::string& name, const std::vector<AxisSample>& samples, const Get& get) {
  std::vector<std::int64_t> values;
  values.reserve(samples.size());
  for (const AxisSample& sample : samples) values.push_back(static_cast<std::int64_t>(get(sample)));
  data.add_integers(name, values);
}

double position_step(int axis) { return axis < first_rotary ? stored_length_step_mm : angle_step_rad; }

std::string numbered(const char* name, int axis) { return std::string(name) + "." + std::to_string(axis); }

}  // namespace

std::string packed_trace(const sim::TraceView& trace) {
  VOLUTE_CHECK(trace.samples.size() == trace.poses_P.size(), trace.samples.size(), trace.poses_P.size());
  const auto& samples = trace.samples;
  PackedData data;
  add_fine(data, "time", column(samples, [](const auto& s) { return s.time_s; }), stored_time_step_s);
  for (int axis = 0; axis < axis_count; ++axis) {
    add_fine(data, numbered("position", axis), column(samples, [=](const auto& s) { return s.position[axis]; }),
             position_step(axis));
    add_fine(data, numbered("actual", axis), column(samples, [=](const auto& s) { return s.actual[axis]; }),
             position_step(axis));
    for (const AxisColumn& curve : curve_columns)
      add_rough(data, numbered(curve.name, axis),
                column(samples, [&](const auto& s) { return (s.*curve.member)[axis]; }));
  }
  add_rough(data, "speed", column(samples, [](const auto& s) { return s.tip_speed_mm_s; }));
  add_integers(data, "line", samples, [](const auto& s) { return s.line; });
  add_integers(data, "limit", samples, [](const auto& s) { return s.limit; });
  add_integers(data, "limiting_axis", samples, [](const auto& s) { return s.limiting_axis; });
  add_integers(data, "motion", samples, [](const auto& s) { return (s.rapid ? 2 : 0) + (s.cutting ? 1 : 0); });
  for (int k = 0; k < 3; ++k) {
    add_fine(data, numbered("tip", k), column(trace.poses_P, [=](const auto& p) { return p.tip_P_mm[k]; }),
             stored_length_step_mm);
    add_fine(data, numbered("axis", k), column(trace.poses_P, [=](const auto& p) { return p.axis_P[k]; }),
             stored_direction_step);
  }
  return data.bytes();
}

std::optional<sim::TraceView> unpacked_trace(std::string_view bytes) {
  const auto columns = unpacked_columns(bytes);
  if (!columns) return std::nullopt;
  const auto time = columns->find("time");
  if (time == columns->end()) return std::nullopt;
  const std::size_t count = time->second.size();
  sim::TraceView trace;
  trace.samples.resize(count);
  trace.poses_P.resize(count);
  bool whole = true;
  const auto take = [&](const std::string& name, const auto& put) {
    const auto found = columns->find(name);
    if (found == columns->end() || found->second.size() != count) {
      whole = false;
      return;
    }
    for (std::size_t i = 0; i < count; ++i) put(i, found->second[i]);
  };
  take("time", [&](std::size_t i, double value) { trace.samples[i].time_s = value; });
  for (int axis = 0; axis < axis_count; ++axis) {
    take(numbered("position", axis), [&](std::size_t i, double value) { trace.samples[i].position[axis] = value; });
    take(numbered("actual", axis), [&](std::size_t i, double value) { trace.samples[i].actual[axis] = value; });
    for (const AxisColumn& curve : curve_columns)
      take(numbered(curve.name, axis),
           [&](std::size_t i, double value) { (trace.samples[i].*curve.member)[axis] = value; });
  }
  take("speed", [&](std::size_t i, double value) { trace.samples[i].tip_speed_mm_s = value; });
  take("line", [&](std::size_t i, double value) { trace.samples[i].line = static_cast<std::int64_t>(value); });
  take("limit",
       [&](std::size_t i, double value) { trace.samples[i].limit = static_cast<sim::Limit>(static_cast<int>(value)); });
  take("limiting_axis",
       [&](std::size_t i, double value) { trace.samples[i].limiting_axis = static_cast<std::int8_t>(value); });
  take("motion", [&](std::size_t i, double value) {
    trace.samples[i].rapid = value >= 2.0;
    trace.samples[i].cutting = static_cast<int>(value) % 2 == 1;
  });
  for (int k = 0; k < 3; ++k) {
    take(numbered("tip", k), [&](std::size_t i, double value) { trace.poses_P[i].tip_P_mm[k] = value; });
    take(numbered("axis", k), [&](std::size_t i, double value) { trace.poses_P[i].axis_P[k] = value; });
  }
  if (!whole) return std::nullopt;
  return trace;
}

sim::TraceView trace_as_stored(const sim::TraceView& trace) {
  auto stored = unpacked_trace(packed_trace(trace));
  VOLUTE_CHECK(stored.has_value(), trace.samples.size());
  return std::move(*stored);
}

}  // namespace volute::view
