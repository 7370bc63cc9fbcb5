// Line plots as SVG: panels one above the other with a common x axis.
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vector.hpp"

namespace volute::view {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

struct PlotSeries {
  std::string name;
  std::string colour;                  ///< SVG colour
  std::vector<geometry::Vec2> points;  ///< x rising
};

struct PlotPanel {
  std::string y_label;  ///< quantity and unit
  std::vector<PlotSeries> series;
  std::vector<double> limits;  ///< drawn as dashed lines when the curves come near them, else told in words
  std::optional<geometry::Vec2> y_range = {};  ///< least and greatest value in sight; none: that of the curves
};

struct Plot {
  std::string title, x_label;
  std::vector<PlotPanel> panels;
};

/// Colours that stay apart for colour-blind readers (Okabe and Ito), in order.
const std::vector<std::string>& plot_colours();

/// The plot as SVG, 1200 wide, 240 a panel. Every series is thinned to its least and greatest value per pixel column:
/// peaks stay.
std::string svg_text(const Plot& plot);

}  // namespace volute::view
