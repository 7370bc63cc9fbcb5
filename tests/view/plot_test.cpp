#include <gtest/gtest.h>

#include <regex>

#include "view/plot.hpp"

namespace volute::view {
namespace {

Plot spike_plot(int points) {
  PlotSeries series{"A", "#000", {}};
  for (int i = 0; i < points; ++i) series.points.emplace_back(i, i == points / 3 ? 50.0 : 0.0);
  return {"spike", "time, s", {{"velocity, deg/s", {series}, {60.0, 1000.0}}}};
}

TEST(Plot, ThinningKeepsAPeakOfOneSample) {
  const std::string svg = svg_text(spike_plot(200'000));
  EXPECT_LT(svg.size(), 200'000U) << "200,000 samples must not become 200,000 points";
  // The curve's highest point: y of the spike lies above y of the rest by most of the panel.
  const std::regex curve("stroke-width=\"1.6\"[^>]* d=\"([^\"]*)\"");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(svg, found, curve));
  const std::string path = found[1];
  double least = 1e9, greatest = -1e9;
  const std::regex pair("[ML]([0-9.]+) ([0-9.]+)");
  for (std::sregex_iterator it(path.begin(), path.end(), pair), end; it != end; ++it) {
    least = std::min(least, std::stod((*it)[2]));
    greatest = std::max(greatest, std::stod((*it)[2]));
  }
  EXPECT_GT(greatest - least, 150.0);
}

TEST(Plot, NearLimitIsDrawnAndAFarOneIsNot) {
  const std::string svg = svg_text(spike_plot(100));
  std::size_t dashed = 0;
  for (std::size_t at = svg.find("stroke-dasharray"); at != std::string::npos;
       at = svg.find("stroke-dasharray", at + 1))
    ++dashed;
  EXPECT_EQ(dashed, 1U) << "60 is near the curve's 50, 1000 is not";
}

TEST(Plot, TextIsEscaped) {
  Plot plot = spike_plot(10);
  plot.title = "a<b & c";
  EXPECT_NE(svg_text(plot).find("a&lt;b &amp; c"), std::string::npos);
}

}  // namespace
}  // namespace volute::view
