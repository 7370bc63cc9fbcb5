#include "view/axis_plots.hpp"

#include <numbers>

namespace volute::view {

namespace {

using geometry::Vec2;
using kinematics::AxisVector;

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

using Quantity = AxisVector sim::AxisSample::*;

PlotSeries series_of(const RunView& view, int axis, Quantity quantity, double unit) {
  PlotSeries series;
  series.name = std::string(1, view.profile->machine.axes[static_cast<std::size_t>(axis)].letter);
  series.colour = plot_colours()[static_cast<std::size_t>(axis % 3)];
  series.points.reserve(view.trace.samples.size());
  for (const sim::AxisSample& sample : view.trace.samples) series.points.emplace_back(sample.time_s, (sample.*quantity)[axis] * unit);
  return series;
}

PlotPanel panel(const RunView& view, std::initializer_list<int> axes, Quantity quantity, double unit, const std::string& label,
                double kinematics::Axis::*limit) {
  PlotPanel result{label, {}, {}};
  for (const int axis : axes) {
    result.series.push_back(series_of(view, axis, quantity, unit));
    if (limit == nullptr) continue;
    const double value = view.profile->machine.axes[static_cast<std::size_t>(axis)].*limit * unit;
    result.limits.push_back(value);
    result.limits.push_back(-value);
  }
  return result;
}

Plot axes_plot(const RunView& view, std::initializer_list<int> axes, double unit, const std::string& unit_name, const std::string& what) {
  Plot plot{view.title + ": " + what, "time, s", {}};
  plot.panels.push_back(panel(view, axes, &sim::AxisSample::position, unit, "position, " + unit_name, nullptr));
  plot.panels.push_back(panel(view, axes, &sim::AxisSample::velocity, unit, "velocity, " + unit_name + "/s", &kinematics::Axis::velocity_max));
  plot.panels.push_back(panel(view, axes, &sim::AxisSample::acceleration, unit, "acceleration, " + unit_name + "/s²", &kinematics::Axis::acceleration_max));
  return plot;
}

}  // namespace

Plot rotary_plot(const RunView& view) { return axes_plot(view, {3, 4}, degrees_per_radian, "deg", "rotary axes"); }
Plot linear_plot(const RunView& view) { return axes_plot(view, {0, 1, 2}, 1.0, "mm", "linear axes"); }

Plot feed_plot(const RunView& view) {
  Plot plot{view.title + ": speed of the tool tip", "time, s", {}};
  PlotSeries speed{"tip", plot_colours()[0], {}};
  for (const sim::AxisSample& sample : view.trace.samples) speed.points.emplace_back(sample.time_s, sample.rapid ? 0.0 : sample.tip_speed_mm_s * 60.0);
  plot.panels.push_back({"feed, mm/min (rapids shown as 0)", {std::move(speed)}, {}});
  return plot;
}

}  // namespace volute::view
