#include "view/axis_plots.hpp"

#include <algorithm>
#include <functional>
#include <numbers>

#include "geometry/number_text.hpp"
#include "sim/loads.hpp"

namespace volute::view {

namespace {

using geometry::Vec2;
using kinematics::AxisVector;

using Quantity = AxisVector sim::AxisSample::*;

PlotSeries series_of(const RunView& view, int axis, Quantity quantity, double unit) {
  PlotSeries series;
  series.name = std::string(1, view.profile->machine.axes[static_cast<std::size_t>(axis)].letter);
  series.colour = plot_colours()[static_cast<std::size_t>(axis % 3)];
  series.points.reserve(view.trace.samples.size());
  for (const sim::AxisSample& sample : view.trace.samples)
    series.points.emplace_back(sample.time_s, (sample.*quantity)[axis] * unit);
  return series;
}

/// What the axes do while cutting; rapids, which would press it flat, may leave the panel.
std::optional<Vec2> cutting_range(const RunView& view, std::initializer_list<int> axes, Quantity quantity,
                                  double unit) {
  std::optional<Vec2> range;
  for (const sim::AxisSample& sample : view.trace.samples) {
    if (!sample.cutting) continue;
    for (const int axis : axes) {
      const double value = (sample.*quantity)[axis] * unit;
      if (!range) range = Vec2(value, value);
      *range = Vec2(std::min(range->x(), value), std::max(range->y(), value));
    }
  }
  return range;
}

PlotPanel panel(const RunView& view, std::initializer_list<int> axes, Quantity quantity, double unit,
                const std::string& label, double kinematics::Axis::*limit) {
  PlotPanel result{label, {}, {}, cutting_range(view, axes, quantity, unit)};
  for (const int axis : axes) {
    result.series.push_back(series_of(view, axis, quantity, unit));
    if (limit == nullptr) continue;
    const double value = view.profile->machine.axes[static_cast<std::size_t>(axis)].*limit * unit;
    result.limits.push_back(value);
    result.limits.push_back(-value);
  }
  return result;
}

Plot axes_plot(const RunView& view, std::initializer_list<int> axes, double unit, const std::string& unit_name,
               const std::string& what) {
  Plot plot{view.title + ": " + what, "time, s (range of the cutting moves; rapids may leave the panels)", {}};
  plot.panels.push_back(panel(view, axes, &sim::AxisSample::position, unit, "position, " + unit_name, nullptr));
  plot.panels.push_back(panel(view, axes, &sim::AxisSample::velocity, unit, "velocity, " + unit_name + "/s",
                              &kinematics::Axis::velocity_max));
  plot.panels.push_back(panel(view, axes, &sim::AxisSample::acceleration, unit, "acceleration, " + unit_name + "/s²",
                              &kinematics::Axis::acceleration_max));
  plot.panels.push_back(
      panel(view, axes, &sim::AxisSample::jerk, unit, "jerk, " + unit_name + "/s³", &kinematics::Axis::jerk_max));
  return plot;
}

/// Length of the cutting path behind each cutting sample; x of the plots over the path.
std::vector<Vec2> over_path(const RunView& view, const std::function<double(const sim::AxisSample&)>& value) {
  std::vector<Vec2> points;
  double length_mm = 0.0;
  for (std::size_t i = 0; i < view.trace.samples.size(); ++i) {
    if (!view.trace.samples[i].cutting) continue;
    if (i > 0 && view.trace.samples[i - 1].cutting)
      length_mm += (view.trace.poses_P[i].tip_P_mm - view.trace.poses_P[i - 1].tip_P_mm).norm();
    points.emplace_back(length_mm, value(view.trace.samples[i]));
  }
  return points;
}

PlotPanel over_path_panel(const RunView& view, Quantity quantity, const std::string& label,
                          double kinematics::Axis::*limit) {
  PlotPanel result = panel(view, {3, 4}, quantity, degrees_per_radian, label, limit);
  for (int k = 0; k < 2; ++k)
    result.series[static_cast<std::size_t>(k)].points =
        over_path(view, [&](const sim::AxisSample& s) { return (s.*quantity)[3 + k] * degrees_per_radian; });
  return result;
}

PlotPanel load_panel(const RunView& view, std::initializer_list<int> axes, const std::string& label) {
  PlotPanel result{label, {}, {}};
  const sim::ChainDynamics dynamics(view.profile->machine);
  for (const int axis : axes) {
    const kinematics::Axis& drive = view.profile->machine.axes[static_cast<std::size_t>(axis)];
    PlotSeries series{std::string(1, drive.letter), plot_colours()[static_cast<std::size_t>(axis % 3)], {}};
    for (const sim::AxisSample& s : view.trace.samples)
      series.points.emplace_back(s.time_s, dynamics.drive_forces(s.position, s.velocity, s.acceleration)[axis]);
    // Which of the dashed lines is whose.
    if (drive.force_max) series.name += ", limit " + geometry::short_text(*drive.force_max, 6);
    result.series.push_back(std::move(series));
    if (drive.force_max) result.limits.insert(result.limits.end(), {*drive.force_max, -*drive.force_max});
  }
  return result;
}

}  // namespace

Plot rotary_plot(const RunView& view) { return axes_plot(view, {3, 4}, degrees_per_radian, "deg", "rotary axes"); }
Plot linear_plot(const RunView& view) { return axes_plot(view, {0, 1, 2}, 1.0, "mm", "linear axes"); }

Plot feed_plot(const RunView& view) {
  Plot plot{view.title + ": speed of the tool tip (rapids shown as 0)", "time, s", {}};
  PlotSeries speed{"tip", plot_colours()[0], {}};
  for (const sim::AxisSample& sample : view.trace.samples)
    speed.points.emplace_back(sample.time_s, sample.rapid ? 0.0 : sample.tip_speed_mm_s * 60.0);
  plot.panels.push_back({"feed, mm/min", {std::move(speed)}, {}});
  return plot;
}

Plot path_plot(const RunView& view) {
  Plot plot{view.title + ": over the path", "length of the cutting path, mm", {}};
  plot.panels.push_back(
      {"feed, mm/min",
       {{"tip", plot_colours()[0], over_path(view, [](const auto& s) { return s.tip_speed_mm_s * 60.0; })}},
       {}});
  plot.panels.push_back(
      over_path_panel(view, &sim::AxisSample::velocity, "velocity, deg/s", &kinematics::Axis::velocity_max));
  plot.panels.push_back(over_path_panel(view, &sim::AxisSample::acceleration, "acceleration, deg/s²",
                                        &kinematics::Axis::acceleration_max));
  return plot;
}

Plot loads_plot(const RunView& view) {
  return {view.title + ": loads of the drives",
          "time, s",
          {load_panel(view, {0, 1, 2}, "force, N"), load_panel(view, {3, 4}, "torque, Nm")}};
}

Plot deviation_plot(const RunView& view) {
  const sim::CutSurfaceReport& cut = *view.cut;
  double total = 0.0;
  for (const std::int64_t count : cut.histogram) total += static_cast<double>(count);
  PlotSeries stairs{"surface", plot_colours()[0], {}};
  const auto filled = [](std::int64_t count) { return count > 0; };
  const auto first = std::find_if(cut.histogram.begin(), cut.histogram.end(), filled);
  const auto last = std::find_if(cut.histogram.rbegin(), cut.histogram.rend(), filled).base();
  const auto begin = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, first - cut.histogram.begin() - 1));
  const std::size_t end = std::min(cut.histogram.size(), static_cast<std::size_t>(last - cut.histogram.begin()) + 1);
  for (std::size_t i = begin; i < end; ++i) {
    const double share = total > 0.0 ? 100.0 * static_cast<double>(cut.histogram[i]) / total : 0.0;
    for (const std::size_t edge : {i, i + 1})
      stairs.points.emplace_back(cut.histogram_min_mm + static_cast<double>(edge) * cut.histogram_step_mm, share);
  }
  return {view.title + ": deviation from the design surface",
          "deviation, mm (above zero: left standing)",
          {{"share of the surface, %", {std::move(stairs)}, {}}}};
}

}  // namespace volute::view
