#include "view/cspace.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "geometry/number_text.hpp"
#include "view/overlay.hpp"

namespace volute::view {

namespace {

using geometry::short_text;
using kinematics::OrientationCell;
using kinematics::OrientationChart;
using kinematics::OrientationMap;
using kinematics::OrientationState;

constexpr int width = 1800, height = 1000;
constexpr double degrees_per_radian = 180.0 / std::numbers::pi;
constexpr double panel_top = 170, panel_height = 640, panel_width = 760;
// A chosen path that goes round the end of an endless axis is not drawn across the picture.
constexpr double wrap_rad = std::numbers::pi;

struct CairoCloser {
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using CairoPtr = std::unique_ptr<cairo_t, CairoCloser>;
using SurfacePtr = std::unique_ptr<cairo_surface_t, CairoCloser>;

constexpr Colour free_colour{0.62F, 0.86F, 0.66F}, tilt_colour{0.86F, 0.86F, 0.86F}, width_colour{0.74F, 0.74F, 0.78F},
    travel_colour{0.60F, 0.60F, 0.60F}, ink{0.10F, 0.10F, 0.10F}, chosen_colour{0.0F, 0.0F, 0.0F},
    unsure_colour{1.0F, 1.0F, 1.0F};
/// Okabe and Ito, without green and black.
constexpr std::array<Colour, 6> blocker_colours{{{0.84F, 0.37F, 0.00F},
                                                 {0.00F, 0.45F, 0.70F},
                                                 {0.80F, 0.47F, 0.65F},
                                                 {0.90F, 0.62F, 0.00F},
                                                 {0.34F, 0.71F, 0.91F},
                                                 {0.45F, 0.30F, 0.15F}}};

Colour blocker_colour(int blocker) {
  return blocker < 0 ? ink : blocker_colours[static_cast<std::size_t>(blocker) % blocker_colours.size()];
}

/// An unsure cell is white: a thin line along the border of what is free.
Colour cell_colour(const OrientationCell& cell) {
  switch (cell.state) {
    case OrientationState::free:
      return free_colour;
    case OrientationState::blocked:
      return blocker_colour(cell.blocker);
    case OrientationState::tilt_limit:
      return tilt_colour;
    case OrientationState::width_limit:
      return width_colour;
    case OrientationState::travel_limit:
      return travel_colour;
    case OrientationState::unsure:
      break;
  }
  return unsure_colour;
}

void ink_with(cairo_t* cairo, const Colour& colour) { cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]); }

double text_width(cairo_t* cairo, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  return extents.x_advance;
}

/// `side`: 0 left-aligned at x, 0.5 centred, 1 right-aligned.
void write(cairo_t* cairo, double x, double y, const std::string& text, double size, double side, bool bold = false) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
  cairo_move_to(cairo, x - side * text_width(cairo, text), y);
  cairo_show_text(cairo, text.c_str());
}

/// Degrees of a chart to pixels of its panel.
struct Panel {
  double left = 0.0;
  std::array<double, 2> least{}, greatest{};
  [[nodiscard]] double x(double rad) const { return left + (rad - least[0]) / (greatest[0] - least[0]) * panel_width; }
  [[nodiscard]] double y(double rad) const {
    return panel_top + (greatest[1] - rad) / (greatest[1] - least[1]) * panel_height;
  }
};

Panel panel_of(const OrientationChart& chart, double left) {
  Panel panel{left, {1e9, 1e9}, {-1e9, -1e9}};
  for (const OrientationCell& cell : chart.cells) {
    for (std::size_t k = 0; k < 2; ++k) {
      panel.least[k] = std::min(panel.least[k], cell.least[k]);
      panel.greatest[k] = std::max(panel.greatest[k], cell.greatest[k]);
    }
  }
  return panel;
}

void draw_cells(cairo_t* cairo, const OrientationChart& chart, const Panel& panel) {
  // Without anti-aliasing neighbours meet without a seam.
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
  for (const OrientationCell& cell : chart.cells) {
    ink_with(cairo, cell_colour(cell));
    const double x0 = std::round(panel.x(cell.least[0])), x1 = std::round(panel.x(cell.greatest[0])),
                 y0 = std::round(panel.y(cell.greatest[1])), y1 = std::round(panel.y(cell.least[1]));
    cairo_rectangle(cairo, x0, y0, std::max(x1 - x0, 1.0), std::max(y1 - y0, 1.0));
    cairo_fill(cairo);
  }
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
}

void draw_choice(cairo_t* cairo, const OrientationChart& chart, const Panel& panel) {
  ink_with(cairo, chosen_colour);
  cairo_set_line_width(cairo, 3.0);
  for (std::size_t k = 0; k + 1 < chart.path.size(); ++k) {
    const auto &a = chart.path[k], &b = chart.path[k + 1];
    if (std::abs(b[0] - a[0]) > wrap_rad || std::abs(b[1] - a[1]) > wrap_rad) continue;
    cairo_move_to(cairo, panel.x(a[0]), panel.y(a[1]));
    cairo_line_to(cairo, panel.x(b[0]), panel.y(b[1]));
    cairo_stroke(cairo);
  }
  if (!chart.chosen) return;
  const double x = panel.x((*chart.chosen)[0]), y = panel.y((*chart.chosen)[1]);
  cairo_arc(cairo, x, y, 11.0, 0.0, 2.0 * std::numbers::pi);
  cairo_set_source_rgb(cairo, 1.0, 1.0, 1.0);
  cairo_fill_preserve(cairo);
  ink_with(cairo, chosen_colour);
  cairo_set_line_width(cairo, 4.0);
  cairo_stroke(cairo);
}

void draw_frame(cairo_t* cairo, const OrientationChart& chart, const Panel& panel) {
  ink_with(cairo, ink);
  cairo_set_line_width(cairo, 2.0);
  cairo_rectangle(cairo, panel.left, panel_top, panel_width, panel_height);
  cairo_stroke(cairo);
  for (std::size_t k = 0; k < 2; ++k) {
    const double least = panel.least[k] * degrees_per_radian, greatest = panel.greatest[k] * degrees_per_radian;
    // Angles are read in halves and thirds of a right angle.
    const double step = greatest - least > 200.0 ? 60.0 : greatest - least > 100.0 ? 30.0 : 15.0;
    for (double tick = std::ceil(least / step - 1e-9) * step; tick <= greatest + 1e-9; tick += step) {
      const std::string text = short_text(std::abs(tick) < 1e-9 ? 0.0 : tick, 4);
      if (k == 0) {
        const double x = panel.x(tick / degrees_per_radian);
        cairo_move_to(cairo, x, panel_top + panel_height);
        cairo_line_to(cairo, x, panel_top + panel_height + 8);
        write(cairo, x, panel_top + panel_height + 34, text, 22, 0.5);
      } else {
        const double y = panel.y(tick / degrees_per_radian);
        cairo_move_to(cairo, panel.left - 8, y);
        cairo_line_to(cairo, panel.left, y);
        write(cairo, panel.left - 14, y + 8, text, 22, 1.0);
      }
      cairo_stroke(cairo);
    }
  }
  write(cairo, panel.left + 0.5 * panel_width, panel_top + panel_height + 68, chart.names[0] + ", deg", 24, 0.5, true);
  write(cairo, panel.left - 60, panel_top - 14, chart.names[1] + ", deg", 24, 0.0, true);
}

/// Only what the picture shows.
std::vector<ColourKey> keys_of(const OrientationMap& map) {
  const auto shows = [&](OrientationState state) {
    const auto in = [&](const OrientationChart& chart) {
      return std::any_of(chart.cells.begin(), chart.cells.end(),
                         [&](const OrientationCell& cell) { return cell.state == state; });
    };
    return in(map.lean) || in(map.rotaries);
  };
  std::vector<ColourKey> keys;
  if (shows(OrientationState::free)) keys.push_back({"free", free_colour});
  for (std::size_t k = 0; k < map.blockers.size(); ++k)
    keys.push_back({map.blockers[k], blocker_colour(static_cast<int>(k))});
  if (shows(OrientationState::unsure)) keys.push_back({"not told apart", unsure_colour});
  if (shows(OrientationState::tilt_limit)) keys.push_back({"tilt limit", tilt_colour});
  if (shows(OrientationState::width_limit)) keys.push_back({"cut too narrow", width_colour});
  if (shows(OrientationState::travel_limit)) keys.push_back({"axis travel", travel_colour});
  return keys;
}

void draw_keys(cairo_t* cairo, const OrientationMap& map) {
  double x = 100, y = 920;
  for (const ColourKey& key : keys_of(map)) {
    cairo_set_font_size(cairo, 22);
    const double room = 44 + text_width(cairo, key.name) + 34;
    if (x + room > width - 40) x = 100, y += 38;
    ink_with(cairo, key.colour);
    cairo_rectangle(cairo, x, y - 20, 32, 24);
    cairo_fill_preserve(cairo);
    ink_with(cairo, ink);
    cairo_set_line_width(cairo, 1.0);
    cairo_stroke(cairo);
    write(cairo, x + 42, y, key.name, 22, 0.0);
    x += room;
  }
}

std::string resolution_text(const OrientationMap& map) {
  const auto percent = [](const OrientationChart& chart) { return short_text(100.0 * unsure_share(chart), 2) + " %"; };
  return "free and blocked are proved for whole cells; not told apart at " +
         short_text(map.resolution_rad * degrees_per_radian, 3) + " deg: " + percent(map.lean) + " and " +
         percent(map.rotaries) + " of the areas";
}

std::string point_text(const OrientationMap& map) {
  const geometry::Vec3& p = map.contact_P_mm;
  std::string text = "CC point " + std::to_string(map.cc_point) + " at (" + short_text(p.x(), 4) + ", " +
                     short_text(p.y(), 4) + ", " + short_text(p.z(), 4) + ") mm; " +
                     short_text(100.0 * map.free_share, 3) + " % of the directions within the tilt limits are free";
  return text;
}

std::string choice_text(const OrientationMap& map) {
  if (!map.margin_rad) return {};
  return "ring: the orientation chosen, free for " + short_text(*map.margin_rad * degrees_per_radian, 3) +
         " deg all round at least; line: the path before and after";
}

}  // namespace

double unsure_share(const OrientationChart& chart) {
  double unsure = 0.0, all = 0.0;
  for (const OrientationCell& cell : chart.cells) {
    const double area = (cell.greatest[0] - cell.least[0]) * (cell.greatest[1] - cell.least[1]);
    all += area;
    if (cell.state == OrientationState::unsure) unsure += area;
  }
  return all > 0.0 ? unsure / all : 0.0;
}

Image draw_cspace_map(const OrientationMap& map, const std::string& title) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height), 255)};
  {
    const SurfacePtr surface(
        cairo_image_surface_create_for_data(image.bgra.data(), CAIRO_FORMAT_RGB24, width, height, 4 * width));
    const CairoPtr cairo(cairo_create(surface.get()));
    ink_with(cairo.get(), ink);
    write(cairo.get(), 40, 52, title, 32, 0.0, true);
    write(cairo.get(), 40, 90, point_text(map), 22, 0.0);
    write(cairo.get(), 40, 120, choice_text(map), 22, 0.0);
    double left = 110;
    for (const OrientationChart* chart : {&map.lean, &map.rotaries}) {
      const Panel panel = panel_of(*chart, left);
      draw_cells(cairo.get(), *chart, panel);
      draw_choice(cairo.get(), *chart, panel);
      draw_frame(cairo.get(), *chart, panel);
      left += panel_width + 130;
    }
    draw_keys(cairo.get(), map);
    write(cairo.get(), width - 40, height - 16, resolution_text(map), 20, 1.0);
    cairo_surface_flush(surface.get());
  }
  // cairo leaves the fourth byte of RGB24 undefined.
  for (std::size_t k = 3; k < image.bgra.size(); k += 4) image.bgra[k] = 255;
  return image;
}

}  // namespace volute::view
