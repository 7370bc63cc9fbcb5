#include "view/orientation_plot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/check.hpp"

namespace volute::view {

namespace {

using geometry::Vec2;

constexpr double least_step_mm = 1e-6;

struct Rates {
  std::vector<Vec2> position_deg, velocity_rad_s, acceleration_rad_s2;
};

std::vector<std::size_t> distinct_points(const RotaryCurve& curve) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < curve.length_mm.size(); ++i)
    if (kept.empty() || curve.length_mm[i] - curve.length_mm[kept.back()] > least_step_mm) kept.push_back(i);
  return kept;
}

Rates rates_of(const RotaryCurve& curve, std::size_t axis, double feed_mm_s) {
  const std::vector<std::size_t> at = distinct_points(curve);
  VOLUTE_CHECK(at.size() >= 3, at.size());
  Rates rates;
  const auto s = [&](std::size_t k) { return curve.length_mm[at[k]]; };
  const auto phi = [&](std::size_t k) { return curve.rotaries_rad[at[k]][axis]; };
  const auto slope = [&](std::size_t k) { return (phi(k + 1) - phi(k)) / (s(k + 1) - s(k)); };
  for (std::size_t k = 0; k < at.size(); ++k) {
    rates.position_deg.emplace_back(s(k), phi(k) * degrees_per_radian);
    if (k + 1 < at.size()) rates.velocity_rad_s.emplace_back(0.5 * (s(k) + s(k + 1)), slope(k) * feed_mm_s);
    if (k > 0 && k + 1 < at.size())
      rates.acceleration_rad_s2.emplace_back(
          s(k), 2.0 * feed_mm_s * feed_mm_s * (slope(k) - slope(k - 1)) / (s(k + 1) - s(k - 1)));
  }
  return rates;
}

}  // namespace

Plot rotary_comparison_plot(const std::vector<RotaryCurve>& curves, double feed_mm_s, const RotaryPlotText& text) {
  VOLUTE_CHECK(feed_mm_s > 0.0, feed_mm_s);
  Plot plot{text.title, "length of the cutting path, mm", {}};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::string& letter = text.axis_names[axis];
    PlotPanel position{letter + ", deg", {}, {}}, velocity{"velocity of " + letter + ", rad/s", {}, {}},
        acceleration{"accel. of " + letter + ", rad/s²", {}, {}};
    for (std::size_t i = 0; i < curves.size(); ++i) {
      Rates rates = rates_of(curves[i], axis, feed_mm_s);
      const std::string& colour = plot_colours()[i % plot_colours().size()];
      position.series.push_back({curves[i].name, colour, std::move(rates.position_deg)});
      velocity.series.push_back({curves[i].name, colour, std::move(rates.velocity_rad_s)});
      acceleration.series.push_back({curves[i].name, colour, std::move(rates.acceleration_rad_s2)});
    }
    for (PlotPanel* panel : {&position, &velocity, &acceleration}) plot.panels.push_back(std::move(*panel));
  }
  return plot;
}

std::array<RotaryPeak, 2> rotary_peaks(const RotaryCurve& curve, double feed_mm_s) {
  std::array<RotaryPeak, 2> peaks;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Rates rates = rates_of(curve, axis, feed_mm_s);
    for (const Vec2& v : rates.velocity_rad_s)
      peaks[axis].velocity_rad_s = std::max(peaks[axis].velocity_rad_s, std::abs(v.y()));
    for (const Vec2& a : rates.acceleration_rad_s2)
      peaks[axis].acceleration_rad_s2 = std::max(peaks[axis].acceleration_rad_s2, std::abs(a.y()));
  }
  return peaks;
}

double least_spacing_mm(const RotaryCurve& curve) {
  const std::vector<std::size_t> at = distinct_points(curve);
  VOLUTE_CHECK(at.size() >= 2, at.size());
  double least = curve.length_mm[at[1]] - curve.length_mm[at[0]];
  for (std::size_t k = 1; k + 1 < at.size(); ++k)
    least = std::min(least, curve.length_mm[at[k + 1]] - curve.length_mm[at[k]]);
  return least;
}

}  // namespace volute::view
