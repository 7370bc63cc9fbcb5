// Rotary axes of several orientations of one path in one plot ([Sun2016] Fig. 20).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "view/plot.hpp"

namespace volute::view {

/// What both rotary axes do over the path in one of the orientations compared.
struct RotaryCurve {
  std::string name;
  std::vector<double> length_mm;                    ///< of the path up to each point, rising
  std::vector<std::array<double, 2>> rotaries_rad;  ///< one an entry of length_mm
};

struct RotaryPlotText {
  std::string title;
  std::array<std::string, 2> axis_names{"A", "C"};
};

/// Panels one above the other: position, angular velocity and angular acceleration of the first axis, then of the
/// second. Velocity and acceleration are the difference quotients of [Sun2016] eqs. 26 and 32 at constant feed, the
/// former drawn between the points, the latter at them. Points at the same length are one. Requires: curves with at
/// least three points of different length, feed above 0.
Plot rotary_comparison_plot(const std::vector<RotaryCurve>& curves, double feed_mm_s, const RotaryPlotText& text);

/// Greatest magnitudes of those quotients.
struct RotaryPeak {
  double velocity_rad_s = 0.0, acceleration_rad_s2 = 0.0;
};
std::array<RotaryPeak, 2> rotary_peaks(const RotaryCurve& curve, double feed_mm_s);

/// Between points of different length. Requires: two of these.
double least_spacing_mm(const RotaryCurve& curve);

}  // namespace volute::view
