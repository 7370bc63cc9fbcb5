// [Sun2016] Figs. 19 and 20: tool orientations beside an obstacle, before and after smoothing, and what A and C then
// do.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/reproduce/item.hpp"
#include "geometry/number_text.hpp"
#include "view/orientation_plot.hpp"
#include "view/pictures.hpp"

namespace volute::app {

namespace {

using geometry::fixed_text;
using geometry::Result;
using geometry::short_text;
using planner::Smoothing;

constexpr const char* orientation_job = "figure-19";
constexpr double strokes = 700.0, stroke_share = 0.16;

struct ShownMethod {
  Smoothing smoothing;
  const char *short_name, *caption;
};
/// In the paper's order; the corridor is Volute's own.
constexpr std::array<ShownMethod, 4> methods{
    {{Smoothing::none, "TTOM (none)", "(a) before: traditional orientations, clear of the obstacle"},
     {Smoothing::velocity, "VTOM (velocity)", "(c) smoothed: least angular velocity"},
     {Smoothing::acceleration, "ATOM (acceleration)", "(d) smoothed: least angular acceleration"},
     {Smoothing::corridor, "corridor", "(e) Volute's own: corridor"}}};

bool on_surface(const kinematics::ToolPathPoint& point) {
  return point.move == kinematics::MoveKind::cut || point.move == kinematics::MoveKind::link;
}

view::RunView oriented_view(const JobInputs& inputs, const planner::PlanResult& plan) {
  view::RunView view = part_view(inputs);
  view.tool_path = plan.tool_path;
  return view;
}

/// Points of the tool path at the shares of its length at which the user pinned axes.
std::vector<std::size_t> pinned_points(const JobInputs& inputs, const kinematics::ToolPath& path) {
  std::vector<std::size_t> cuts;
  std::vector<double> length_mm;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (!on_surface(path.points[i])) continue;
    length_mm.push_back(
        cuts.empty() ? 0.0
                     : length_mm.back() + (path.points[i].contact_P_mm - path.points[cuts.back()].contact_P_mm).norm());
    cuts.push_back(i);
  }
  std::vector<std::size_t> pins;
  for (const planner::KeyOrientation& key : inputs.job.orientation.keys) {
    if (!key.path_fraction || cuts.empty()) continue;
    const auto at = std::lower_bound(length_mm.begin(), length_mm.end(), *key.path_fraction * length_mm.back());
    pins.push_back(cuts[std::min(static_cast<std::size_t>(at - length_mm.begin()), cuts.size() - 1)]);
  }
  return pins;
}

view::RotaryCurve curve_of(const std::string& name, const planner::PlanResult& plan) {
  view::RotaryCurve curve{name, {}, plan.rotaries_rad};
  geometry::Vec3 last = geometry::Vec3::Zero();
  for (const kinematics::ToolPathPoint& point : plan.tool_path.points) {
    if (!on_surface(point)) continue;
    curve.length_mm.push_back(curve.length_mm.empty() ? 0.0
                                                      : curve.length_mm.back() + (point.contact_P_mm - last).norm());
    last = point.contact_P_mm;
  }
  const std::size_t count = std::min(curve.length_mm.size(), curve.rotaries_rad.size());
  curve.length_mm.resize(count);
  curve.rotaries_rad.resize(count);
  return curve;
}

std::vector<std::string> peaks_row(const std::string& name, const planner::OrientationReport& report) {
  return {name,
          short_text(report.first.velocity_max, 3),
          short_text(report.first.acceleration_max, 3),
          short_text(report.second.velocity_max, 3),
          short_text(report.second.acceleration_max, 3),
          std::to_string(report.interferences_before) + " -> " + std::to_string(report.interferences_after),
          std::to_string(report.pins),
          std::to_string(report.iterations),
          short_text(report.solve_s, 2)};
}

const std::vector<std::string> orientation_assumed{
    "Part, obstacle, holder and machine: `examples/figure-19.toml` (the paper shows its own without sizes). Feed "
    "500 mm/min as in "
    "the paper.",
    "Velocity and acceleration are eqs. 26 and 32 at constant feed, before any control, as the paper has them."};

}  // namespace

Result<ItemPage> orientations_beside_obstacle(Workshop& shop, const std::string& name) {
  const auto inputs = shop.inputs(orientation_job);
  if (!inputs) return tl::unexpected(inputs.error());
  std::vector<view::FigurePanel> panels;
  const view::PictureStyle style = view::panel_style();
  view::OrientationFocus focus{strokes, stroke_share};
  focus.tilt_range_deg = geometry::Vec2(0.0, inputs->job.orientation.tilt_max.degrees());
  for (const ShownMethod& method : methods) {
    const auto plan = shop.plan(orientation_job, method.smoothing);
    if (!plan) return tl::unexpected(plan.error());
    const view::RunView view = oriented_view(*inputs, **plan);
    if (auto added = add_panel(panels, method.caption, view::orientation_picture(view, style, focus)); !added)
      return tl::unexpected(added.error());
    if (method.smoothing != Smoothing::none || inputs->job.orientation.keys.empty()) continue;
    view::OrientationFocus pinned{strokes, 2.0 * stroke_share, pinned_points(*inputs, view.tool_path), true, true};
    if (auto added = add_panel(panels, "(b) critical orientations, pinned in the job",
                               view::orientation_picture(view, style, pinned));
        !added)
      return tl::unexpected(added.error());
  }
  const auto file = shop.keep(name, panels, 2);
  if (!file) return tl::unexpected(file.error());
  return ItemPage{
      "Tool axes along a path that passes an obstacle. Without smoothing the tool swings away only where it must; "
      "after it, "
      "the swing is spread over the path.",
      {*file},
      {},
      orientation_assumed,
      {inputs->job.orientation.keys.empty()
           ? "The critical orientations are found by the program, not given: their number stands in figure-20."
           : "The axes of the pins are those of the job, at five places along the path as in the paper."}};
}

Result<ItemPage> rotary_axes_compared(Workshop& shop, const std::string& name) {
  const auto inputs = shop.inputs(orientation_job);
  if (!inputs) return tl::unexpected(inputs.error());
  std::vector<view::RotaryCurve> curves;
  TextTable table{{"", "A velocity, rad/s", "A acceleration, rad/s²", "C velocity, rad/s", "C acceleration, rad/s²",
                   "interferences", "pins", "rounds", "solve, s"},
                  {"TTOM, paper", "1.48", "7.95", "-", "-", "-", "-", "-", "-"},
                  {"VTOM and ATOM, paper", "-", "-", "-", "-", "none left", "5", "-", "within 0.05 each"}};
  view::RotaryPlotText text{"A and C over the path at " + short_text(inputs->job.process.feed_mm_s * 60.0) + " mm/min",
                            {}};
  for (const ShownMethod& method : methods) {
    const auto plan = shop.plan(orientation_job, method.smoothing);
    if (!plan) return tl::unexpected(plan.error());
    curves.push_back(curve_of(method.short_name, **plan));
    const planner::OrientationReport& report = (*plan)->orientation;
    table.push_back(peaks_row("**" + std::string(method.short_name) + ", ours**", report));
    text.axis_names = {std::string(1, report.first_letter), std::string(1, report.second_letter)};
  }
  const auto file = shop.keep(name, view::rotary_comparison_plot(curves, inputs->job.process.feed_mm_s, text));
  if (!file) return tl::unexpected(file.error());
  return ItemPage{
      "Position, angular velocity and angular acceleration of both rotary axes over the path. The paper prints peaks "
      "for "
      "A of the traditional orientations only; its curves have no table.",
      {*file},
      {table},
      orientation_assumed,
      {"Seconds are of the computer that wrote this page; the other numbers do not depend on it.",
       "The weights that minimise eqs. 27 and 33 as printed depend on how the CC points are spaced. Weighted by arc "
       "length, as "
       "here, the velocity model is linear interpolation between the pins and the acceleration model tends to the "
       "natural "
       "cubic spline through them. `weights = \"as-printed\"` gives the printed form.",
       "In eq. 34 the printed table of coefficients is mirrored and one of them wrong (its F needs L_(i-1) for "
       "L_(i-2)), in "
       "eq. 25 the second argument of atan2 needs a minus sign, and eq. 31 does not fit its own dimensions; the "
       "corrected forms are used.",
       "The solve is short in any case. What takes time is to find which orientations are free."}};
}

}  // namespace volute::app
