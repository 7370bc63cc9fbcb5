#include "view/plot.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/number_text.hpp"
#include "view/overlay.hpp"

namespace volute::view {

namespace {

using geometry::fixed_text;
using geometry::short_text;
using geometry::Vec2;

constexpr double plot_width = 1200, panel_height = 240, left = 110, right = 30, title_room = 64, bottom_room = 58,
                 gap = 18;
// The strip on top of each panel in which its keys stand: no curve comes there.
constexpr double legend_height = 28;
/// Curves that leave the panel are drawn this far beyond it, under the clip.
constexpr double clip_reach = 2000.0;
/// A limit farther away than this many times the curve's own range is left out of the panel's range.
constexpr double limit_reach = 1.6;

struct Range {
  double least = 1e300, greatest = -1e300;
};
void grow(Range& range, double value) {
  range.least = std::min(range.least, value);
  range.greatest = std::max(range.greatest, value);
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

std::string text_at(double x, double y, const std::string& text, const char* extra = "") {
  return "<text x=\"" + fixed_text(x, 1) + "\" y=\"" + fixed_text(y, 1) + "\" " + extra + ">" + escaped(text) +
         "</text>\n";
}

Range x_range(const Plot& plot) {
  Range range;
  for (const PlotPanel& panel : plot.panels)
    for (const PlotSeries& series : panel.series)
      for (const Vec2& point : series.points) grow(range, point.x());
  if (range.least >= range.greatest) range = {0.0, 1.0};
  return range;
}

Range y_range(const PlotPanel& panel) {
  Range range;
  if (panel.y_range)
    range = {panel.y_range->x(), panel.y_range->y()};
  else
    for (const PlotSeries& series : panel.series)
      for (const Vec2& point : series.points) grow(range, point.y());
  if (range.least > range.greatest) return {0.0, 1.0};
  const double reach = limit_reach * std::max(std::abs(range.least), std::abs(range.greatest));
  for (const double limit : panel.limits)
    if (std::abs(limit) <= reach) grow(range, limit);
  const double margin = std::max(0.06 * (range.greatest - range.least), 1e-6 + 1e-3 * std::abs(range.greatest));
  const double legend_share = legend_height / (panel_height - legend_height);
  return {range.least - margin, range.greatest + margin + legend_share * (range.greatest - range.least + margin)};
}

/// Per pixel column the first, least, greatest and last point: what the eye would see of them all.
std::vector<Vec2> thinned(const std::vector<Vec2>& points, const Range& x) {
  const double columns = plot_width - left - right;
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < points.size();) {
    const auto column = std::floor((points[i].x() - x.least) / (x.greatest - x.least) * columns);
    std::size_t least = i, greatest = i, last = i;
    for (; last + 1 < points.size() &&
           std::floor((points[last + 1].x() - x.least) / (x.greatest - x.least) * columns) == column;
         ++last) {
      if (points[last + 1].y() < points[least].y()) least = last + 1;
      if (points[last + 1].y() > points[greatest].y()) greatest = last + 1;
    }
    std::array<std::size_t, 4> chosen{i, least, greatest, last};
    std::sort(chosen.begin(), chosen.end());
    const auto* end = std::unique(chosen.begin(), chosen.end());
    for (const auto* index = chosen.begin(); index != end; ++index) kept.push_back(points[*index]);
    i = last + 1;
  }
  return kept;
}

/// Maps values to pixels inside one panel.
struct PanelFrame {
  Range x, y;
  double top = 0.0;
  [[nodiscard]] double px(double value) const {
    return left + (value - x.least) / (x.greatest - x.least) * (plot_width - left - right);
  }
  [[nodiscard]] double py(double value) const {
    return top + (y.greatest - value) / (y.greatest - y.least) * panel_height;
  }
};

std::string grid(const PanelFrame& frame, bool label_x) {
  std::string out;
  const double step_y = round_step(frame.y.greatest - frame.y.least, 4);
  for (double tick = std::ceil(frame.y.least / step_y) * step_y; tick <= frame.y.greatest; tick += step_y) {
    const double y = frame.py(tick);
    out += "<path class=\"grid\" d=\"M" + fixed_text(left, 0) + " " + fixed_text(y, 1) + "H" +
           fixed_text(plot_width - right, 0) + "\"/>\n";
    out += text_at(left - 8, y + 5, short_text(std::abs(tick) < 1e-9 * step_y ? 0.0 : tick, 5), "text-anchor=\"end\"");
  }
  const double step_x = round_step(frame.x.greatest - frame.x.least, 10);
  for (double tick = std::ceil(frame.x.least / step_x) * step_x; tick <= frame.x.greatest * (1.0 + 1e-12);
       tick += step_x) {
    const double x = frame.px(tick);
    out += "<path class=\"grid\" d=\"M" + fixed_text(x, 1) + " " + fixed_text(frame.top, 1) + "v" +
           fixed_text(panel_height, 0) + "\"/>\n";
    if (label_x)
      out += text_at(x, frame.top + panel_height + 20, short_text(std::abs(tick) < 1e-9 * step_x ? 0.0 : tick, 6),
                     "text-anchor=\"middle\"");
  }
  return out;
}

std::string curve(const PlotSeries& series, const PanelFrame& frame) {
  std::string path;
  for (const Vec2& point : thinned(series.points, frame.x)) {
    const double y = std::clamp(frame.py(point.y()), frame.top - clip_reach, frame.top + panel_height + clip_reach);
    path += (path.empty() ? "M" : "L") + fixed_text(frame.px(point.x()), 1) + " " + fixed_text(y, 1);
  }
  return "<path fill=\"none\" stroke-width=\"1.6\" stroke=\"" + series.colour + "\" d=\"" + path + "\"/>\n";
}

std::string limit_lines(const PlotPanel& panel, const PanelFrame& frame) {
  std::string out;
  for (const double limit : panel.limits) {
    if (limit < frame.y.least || limit > frame.y.greatest) continue;
    out += "<path stroke=\"#b00020\" stroke-width=\"1.4\" stroke-dasharray=\"7 5\" d=\"M" + fixed_text(left, 0) + " " +
           fixed_text(frame.py(limit), 1) + "H" + fixed_text(plot_width - right, 0) + "\"/>\n";
  }
  return out;
}

/// The limits of which neither side is near enough to the curves to be drawn, each once: "limits ±180, ±600 are farther
/// out".
std::string hidden_limits(const PlotPanel& panel, const PanelFrame& frame) {
  const auto drawn = [&](double limit) { return limit >= frame.y.least && limit <= frame.y.greatest; };
  std::vector<double> hidden;
  for (const double limit : panel.limits)
    if (!drawn(limit) && !drawn(-limit)) hidden.push_back(std::abs(limit));
  std::sort(hidden.begin(), hidden.end());
  hidden.erase(std::unique(hidden.begin(), hidden.end()), hidden.end());
  std::string words;
  for (const double limit : hidden) words += (words.empty() ? "limits ±" : ", ±") + short_text(limit, 6);
  return words.empty() ? words : words + " are farther out";
}

std::string legend(const PlotPanel& panel, const PanelFrame& frame) {
  double x = left + 12;
  for (const PlotSeries& series : panel.series) x += 60 + 9.0 * static_cast<double>(series.name.size());
  std::string out = "<rect x=\"" + fixed_text(left + 4, 0) + "\" y=\"" + fixed_text(frame.top + 3, 0) + "\" width=\"" +
                    fixed_text(x - left - 30, 0) + "\" height=\"22\" fill=\"#fff\" fill-opacity=\"0.85\"/>\n";
  if (const std::string words = hidden_limits(panel, frame); !words.empty())
    out += text_at(plot_width - right - 8, frame.top + 19, words, "text-anchor=\"end\" fill=\"#b00020\"");
  x = left + 12;
  for (const PlotSeries& series : panel.series) {
    out += "<path stroke-width=\"3\" stroke=\"" + series.colour + "\" d=\"M" + fixed_text(x, 0) + " " +
           fixed_text(frame.top + 14, 0) + "h22\"/>\n";
    out += text_at(x + 28, frame.top + 19, series.name, "class=\"key\"");
    x += 60 + 9.0 * static_cast<double>(series.name.size());
  }
  return out;
}

std::string panel_text(const PlotPanel& panel, const PanelFrame& frame, bool label_x) {
  std::string out = grid(frame, label_x);
  out += "<rect x=\"" + fixed_text(left, 0) + "\" y=\"" + fixed_text(frame.top, 0) + "\" width=\"" +
         fixed_text(plot_width - left - right, 0) + "\" height=\"" + fixed_text(panel_height, 0) +
         "\" fill=\"none\" stroke=\"#444\"/>\n";
  out += limit_lines(panel, frame);
  const std::string clip = "panel" + fixed_text(frame.top, 0);
  out += "<clipPath id=\"" + clip + "\"><rect x=\"" + fixed_text(left, 0) + "\" y=\"" + fixed_text(frame.top, 0) +
         "\" width=\"" + fixed_text(plot_width - left - right, 0) + "\" height=\"" + fixed_text(panel_height, 0) +
         "\"/></clipPath>\n<g clip-path=\"url(#" + clip + ")\">\n";
  for (const PlotSeries& series : panel.series) out += curve(series, frame);
  out += "</g>\n";
  const double middle = frame.top + panel_height / 2;
  out += "<text transform=\"translate(24 " + fixed_text(middle, 0) + ") rotate(-90)\" text-anchor=\"middle\">" +
         escaped(panel.y_label) + "</text>\n";
  return out + legend(panel, frame);
}

}  // namespace

const std::vector<std::string>& plot_colours() {
  static const std::vector<std::string> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#000000"};
  return colours;
}

std::string svg_text(const Plot& plot) {
  const double count = static_cast<double>(plot.panels.size());
  const double height = title_room + count * (panel_height + gap) + bottom_room;
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + fixed_text(plot_width, 0) + " " +
                    fixed_text(height, 0) +
                    "\" font-family=\"DejaVu Sans, sans-serif\" "
                    "font-size=\"14\">\n<style>.grid{stroke:#ddd;fill:none}.key{font-weight:bold}</style>\n";
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
         text_at(left, 36, plot.title, "font-size=\"20\" font-weight=\"bold\"");
  const Range x = x_range(plot);
  double top = title_room;
  for (std::size_t i = 0; i < plot.panels.size(); ++i, top += panel_height + gap)
    out += panel_text(plot.panels[i], {x, y_range(plot.panels[i]), top}, i + 1 == plot.panels.size());
  out += text_at((left + plot_width - right) / 2, height - 12, plot.x_label, "text-anchor=\"middle\"");
  return out + "</svg>\n";
}

}  // namespace volute::view
