#include "view/overlay.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "geometry/number_text.hpp"

namespace volute::view {

namespace {

using geometry::short_text;

struct CairoCloser {
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using CairoPtr = std::unique_ptr<cairo_t, CairoCloser>;
using SurfacePtr = std::unique_ptr<cairo_surface_t, CairoCloser>;

/// Text sizes follow the picture: `text_scale` at 1200 pixels of height.
double size_unit(const Image& image, const Overlay& overlay) { return overlay.text_scale * image.height / 1200.0; }

void write(cairo_t* cairo, double x, double y, const std::string& text, double size, bool bold = false) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
  cairo_move_to(cairo, x, y);
  cairo_show_text(cairo, text.c_str());
}

double text_width(cairo_t* cairo, const std::string& text, double size, bool bold = false) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  return extents.x_advance;
}

/// A light plate, so that words stay readable over whatever the picture has there.
void draw_title_plate(cairo_t* cairo, const Overlay& overlay, double unit) {
  double width = text_width(cairo, overlay.title, 32 * unit, true);
  for (const std::string& note : overlay.notes) width = std::max(width, text_width(cairo, note, 24 * unit));
  cairo_set_source_rgba(cairo, 1.0, 1.0, 1.0, 0.82);
  cairo_rectangle(cairo, 22 * unit, 20 * unit, width + 28 * unit,
                  54 * unit + 32 * unit * static_cast<double>(overlay.notes.size()));
  cairo_fill(cairo);
}

void draw_title(cairo_t* cairo, const Overlay& overlay, double unit) {
  if (overlay.title.empty() && overlay.notes.empty()) return;
  draw_title_plate(cairo, overlay, unit);
  cairo_set_source_rgb(cairo, 0.1, 0.1, 0.1);
  write(cairo, 36 * unit, 58 * unit, overlay.title, 32 * unit, true);
  double y = 96 * unit;
  for (const std::string& note : overlay.notes) {
    write(cairo, 36 * unit, y, note, 24 * unit);
    y += 32 * unit;
  }
}

void draw_bar(cairo_t* cairo, const Image& image, const ColourBar& bar, double unit) {
  const double x = image.width - 190 * unit, width = 34 * unit, top = 0.1 * image.height + 70 * unit,
               height = 0.75 * image.height - 140 * unit;
  constexpr int steps = 256;
  for (int i = 0; i < steps; ++i) {
    const Colour colour = bar.colour(1.0 - (i + 0.5) / steps);
    cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
    cairo_rectangle(cairo, x, top + height * i / steps, width, height / steps + 1.0);
    cairo_fill(cairo);
  }
  cairo_set_source_rgb(cairo, 0.1, 0.1, 0.1);
  cairo_set_line_width(cairo, 2 * unit);
  cairo_rectangle(cairo, x, top, width, height);
  cairo_stroke(cairo);
  const double span = bar.greatest - bar.least;
  if (span > 0.0) {
    const double step = round_step(span, 6);
    for (double tick = std::ceil(bar.least / step) * step; tick <= bar.greatest + 1e-9 * span; tick += step) {
      const double y = top + height * (bar.greatest - tick) / span;
      cairo_move_to(cairo, x + width, y);
      cairo_line_to(cairo, x + width + 8 * unit, y);
      cairo_stroke(cairo);
      write(cairo, x + width + 14 * unit, y + 8 * unit, short_text(std::abs(tick) < 1e-12 * span ? 0.0 : tick, 4),
            23 * unit);
    }
  }
  write(cairo, std::min(x, image.width - 24 * unit - text_width(cairo, bar.label, 24 * unit)), top - 22 * unit,
        bar.label, 24 * unit);
}

void draw_arrow(cairo_t* cairo, double x, double y, double dx, double dy, const char* name, const Colour& colour,
                double unit) {
  cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
  cairo_set_line_width(cairo, 4 * unit);
  cairo_move_to(cairo, x, y);
  cairo_line_to(cairo, x + dx, y + dy);
  cairo_stroke(cairo);
  write(cairo, x + dx * 1.22 - 7 * unit, y + dy * 1.22 + 8 * unit, name, 24 * unit, true);
}

void draw_triad(cairo_t* cairo, const Image& image, const Camera& camera, double unit) {
  const double x = 100 * unit, y = image.height - 100 * unit, length = 62 * unit;
  const std::array<const char*, 3> names{"x", "y", "z"};
  const std::array<Colour, 3> colours{{{0.80F, 0.25F, 0.10F}, {0.10F, 0.50F, 0.25F}, {0.10F, 0.30F, 0.75F}}};
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 direction = Vec3::Unit(axis);
    const double dx = direction.dot(camera.right) * length, dy = -direction.dot(camera.up) * length;
    if (std::hypot(dx, dy) > 0.1 * length)
      draw_arrow(cairo, x, y, dx, dy, names[static_cast<std::size_t>(axis)], colours[static_cast<std::size_t>(axis)],
                 unit);
  }
}

void draw_scale(cairo_t* cairo, const Image& image, const Camera& camera, double unit) {
  const double pixels_per_mm = image.height / (2.0 * camera.half_height);
  const double length_mm = round_step(image.width / pixels_per_mm, 7);
  const double x = 250 * unit, y = image.height - 60 * unit, length = length_mm * pixels_per_mm;
  cairo_set_source_rgb(cairo, 0.1, 0.1, 0.1);
  cairo_set_line_width(cairo, 4 * unit);
  cairo_move_to(cairo, x, y - 9 * unit);
  cairo_line_to(cairo, x, y);
  cairo_line_to(cairo, x + length, y);
  cairo_line_to(cairo, x + length, y - 9 * unit);
  cairo_stroke(cairo);
  write(cairo, x + length + 14 * unit, y + 6 * unit, short_text(length_mm) + " mm", 24 * unit);
}

void draw_keys(cairo_t* cairo, const Image& image, const std::vector<ColourKey>& keys, double unit) {
  double y = 0.1 * image.height + 70 * unit;
  cairo_set_source_rgba(cairo, 1.0, 1.0, 1.0, 0.82);
  cairo_rectangle(cairo, image.width - 345 * unit, y - 14 * unit, 330 * unit,
                  keys.empty() ? 0.0 : 40 * unit * static_cast<double>(keys.size()) + 12 * unit);
  cairo_fill(cairo);
  for (const ColourKey& key : keys) {
    const double x = image.width - 330 * unit;
    cairo_set_source_rgb(cairo, key.colour[0], key.colour[1], key.colour[2]);
    cairo_rectangle(cairo, x, y, 30 * unit, 24 * unit);
    cairo_fill(cairo);
    cairo_set_source_rgb(cairo, 0.1, 0.1, 0.1);
    write(cairo, x + 44 * unit, y + 20 * unit, key.name, 24 * unit);
    y += 40 * unit;
  }
}

}  // namespace

double round_step(double span, int wanted) {
  const double rough = span / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10.0 * power;
}

void draw_overlay(Image& image, const Camera& camera, const Overlay& overlay) {
  const SurfacePtr surface(cairo_image_surface_create_for_data(image.bgra.data(), CAIRO_FORMAT_RGB24, image.width,
                                                               image.height, image.width * 4));
  const CairoPtr cairo(cairo_create(surface.get()));
  const double unit = size_unit(image, overlay);
  draw_title(cairo.get(), overlay, unit);
  if (overlay.bar != nullptr) draw_bar(cairo.get(), image, *overlay.bar, unit);
  draw_keys(cairo.get(), image, overlay.keys, unit);
  if (overlay.triad) draw_triad(cairo.get(), image, camera, unit);
  if (overlay.scale) draw_scale(cairo.get(), image, camera, unit);
  cairo_surface_flush(surface.get());
}

}  // namespace volute::view
