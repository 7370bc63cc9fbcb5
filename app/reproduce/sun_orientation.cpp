// [Sun2016] Figs. 19 and 20: tool orientations beside an obstacle, before and after smoothing, and what A and C then
// do.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/reproduce/item.hpp"
#include "geometry/check.hpp"
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
// Between the CC points of the paper, as its two peaks tell: velocity times feed over acceleration.
constexpr double paper_step_mm = 1.48 * (500.0 / 60.0) / 7.95;
constexpr double drawn_strokes = 700.0, drawn_stroke_share = 0.16;

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

/// The points that have rotaries: on the surface, and the first of a piece, which an approach reaches.
view::RotaryCurve curve_of(const std::string& name, const planner::PlanResult& plan) {
  view::RotaryCurve curve{name, {}, plan.rotaries_rad};
  geometry::Vec3 last = geometry::Vec3::Zero();
  const auto& points = plan.tool_path.points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!on_surface(points[k]) && (k + 1 == points.size() || !on_surface(points[k + 1]))) continue;
    curve.length_mm.push_back(
        curve.length_mm.empty() ? 0.0 : curve.length_mm.back() + (points[k].contact_P_mm - last).norm());
    last = points[k].contact_P_mm;
  }
  VOLUTE_CHECK(curve.length_mm.size() == curve.rotaries_rad.size(), curve.length_mm.size(), curve.rotaries_rad.size());
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

/// The curve at points `step_mm` apart along the path.
view::RotaryCurve resampled(const view::RotaryCurve& curve, double step_mm) {
  view::RotaryCurve coarse{curve.name, {}, {}};
  std::size_t k = 0;
  for (double s = 0.0; s <= curve.length_mm.back(); s += step_mm) {
    while (k + 2 < curve.length_mm.size() && curve.length_mm[k + 1] < s) ++k;
    const double step = curve.length_mm[k + 1] - curve.length_mm[k];
    const double t = step > 0.0 ? (s - curve.length_mm[k]) / step : 0.0;
    coarse.length_mm.push_back(s);
    coarse.rotaries_rad.push_back({});
    for (std::size_t axis = 0; axis < 2; ++axis)
      coarse.rotaries_rad.back()[axis] = (1.0 - t) * curve.rotaries_rad[k][axis] + t * curve.rotaries_rad[k + 1][axis];
  }
  return coarse;
}

std::vector<std::string> row_of(const std::string& name, const std::array<view::RotaryPeak, 2>& peaks) {
  return {name,
          short_text(peaks[0].velocity_rad_s, 3),
          short_text(peaks[0].acceleration_rad_s2, 3),
          short_text(peaks[1].velocity_rad_s, 3),
          short_text(peaks[1].acceleration_rad_s2, 3),
          "-",
          "-",
          "-",
          "-"};
}

/// The greatest slope of the straight lines from pin to pin, rad/s: no curve through the pins turns slower throughout.
std::array<double, 2> least_velocities(const JobInputs& inputs, const view::RotaryCurve& pinned) {
  std::array<double, 2> least{};
  std::optional<std::size_t> before;
  for (const planner::KeyOrientation& key : inputs.job.orientation.keys) {
    if (!key.path_fraction) continue;
    const double s = *key.path_fraction * pinned.length_mm.back();
    const auto place = std::lower_bound(pinned.length_mm.begin(), pinned.length_mm.end(), s);
    const auto at = static_cast<std::size_t>(std::min(place, pinned.length_mm.end() - 1) - pinned.length_mm.begin());
    for (std::size_t axis = 0; before && axis < 2; ++axis) {
      const double turned = pinned.rotaries_rad[at][axis] - pinned.rotaries_rad[*before][axis];
      least[axis] = std::max(least[axis], std::abs(turned) / (pinned.length_mm[at] - pinned.length_mm[*before]) *
                                              inputs.job.process.feed_mm_s);
    }
    before = at;
  }
  return least;
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
  view::OrientationFocus focus{drawn_strokes, drawn_stroke_share};
  focus.tilt_range_deg = geometry::Vec2(0.0, inputs->job.orientation.tilt_max.degrees());
  for (const ShownMethod& method : methods) {
    const auto plan = shop.plan(orientation_job, method.smoothing);
    if (!plan) return tl::unexpected(plan.error());
    const view::RunView view = oriented_view(*inputs, **plan);
    if (auto added = add_panel(panels, method.caption, view::orientation_picture(view, style, focus)); !added)
      return tl::unexpected(added.error());
    if (method.smoothing != Smoothing::none || inputs->job.orientation.keys.empty()) continue;
    view::OrientationFocus pinned{drawn_strokes, 2.0 * drawn_stroke_share, pinned_points(*inputs, view.tool_path), true,
                                  true};
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
  const double feed_mm_s = inputs->job.process.feed_mm_s;
  const std::array<double, 2> least = least_velocities(*inputs, curves[2]);
  table.push_back({"least that a curve through the pins can have", short_text(least[0], 3), "-",
                   short_text(least[1], 3), "-", "-", "-", "-", "-"});
  table.push_back(row_of("TTOM, ours, at points " + short_text(paper_step_mm, 3) + " mm apart",
                         view::rotary_peaks(resampled(curves[0], paper_step_mm), feed_mm_s)));
  const auto file = shop.keep(name, view::rotary_comparison_plot(curves, feed_mm_s, text));
  if (!file) return tl::unexpected(file.error());
  const double least_step_mm = view::least_spacing_mm(curves[0]);
  curves.erase(curves.begin());
  text.title += ", smoothed";
  const auto smoothed = shop.keep(name + "-smoothed", view::rotary_comparison_plot(curves, feed_mm_s, text));
  if (!smoothed) return tl::unexpected(smoothed.error());
  return ItemPage{
      "Position, angular velocity and angular acceleration of both rotary axes over the path. The paper prints peaks "
      "for "
      "A of the traditional orientations only; its curves have no table.",
      {*file, *smoothed},
      {table},
      orientation_assumed,
      {"The paper's peaks of TTOM, 1.48 rad/s and 7.95 rad/s², belong to one jump between CC points 1.48 · 8.33 / 7.95 "
       "= " +
           short_text(paper_step_mm, 3) +
           " mm apart. An axis that jumps has no acceleration of its own: the quotient of eq. 32 grows as one over the "
           "spacing. Our points stand as near as " +
           short_text(least_step_mm, 2) +
           " mm where the boundary turns, hence the larger number; at the paper's spacing ours is in the last row.",
       "Velocity falls from TTOM to VTOM, acceleration from TTOM to VTOM to ATOM to corridor. From VTOM to ATOM the "
       "velocity of A cannot fall: VTOM runs straight from pin to pin, and by the mean value theorem every curve "
       "through "
       "the same pins is somewhere as fast. The row before the last is that bound. [Sun2016] claims no fall there "
       "either: it calls the result of VTOM nearly a linear interpolation with small fluctuations left, and says of "
       "ATOM "
       "that neither velocity nor acceleration jumps.",
       "Interferences count CC points with the motion to the next. What TTOM leaves is such a motion: free at both "
       "ends, "
       "not on the swing between.",
       "Seconds are of the computer that wrote this page; the other numbers do not depend on it.",
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
