#include "view/figure_sheet.hpp"

#include <cairo.h>

#include <algorithm>
#include <memory>

#include "geometry/check.hpp"

namespace volute::view {

namespace {

constexpr int caption_height = 34, sheet_gap = 10, sheet_shades = 32;
constexpr double caption_size = 17.0, least_caption_size = 11.0, panel_text_unit = 0.62;

struct CairoCloser {
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};

void copy_into(Image& sheet, const Image& panel, int x, int y) {
  for (int row = 0; row < panel.height; ++row) {
    const auto from = static_cast<std::size_t>(row) * static_cast<std::size_t>(panel.width) * 4;
    const auto to =
        (static_cast<std::size_t>(y + row) * static_cast<std::size_t>(sheet.width) + static_cast<std::size_t>(x)) * 4;
    std::copy_n(&panel.bgra[from], static_cast<std::size_t>(panel.width) * 4, &sheet.bgra[to]);
  }
}

/// Centred under its panel; smaller where the words are many.
void write_caption(cairo_t* cairo, const std::string& caption, int x, int y, int width) {
  cairo_set_source_rgb(cairo, 0.1, 0.1, 0.1);
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, caption_size);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, caption.c_str(), &extents);
  if (extents.x_advance > width) {
    cairo_set_font_size(cairo, std::max(least_caption_size, caption_size * width / extents.x_advance));
    cairo_text_extents(cairo, caption.c_str(), &extents);
  }
  cairo_move_to(cairo, x + 0.5 * (width - extents.x_advance), y + 22);
  cairo_show_text(cairo, caption.c_str());
}

}  // namespace

Result<void> add_panel(std::vector<FigurePanel>& panels, const std::string& caption, Result<Image> image) {
  if (!image) return tl::unexpected(image.error());
  panels.push_back({caption, std::move(*image)});
  return {};
}

PictureStyle panel_style(int width_px, int height_px) {
  return {width_px, height_px, panel_text_unit * 1200.0 / height_px, false};
}

Image figure_sheet(const std::vector<FigurePanel>& panels, int columns) {
  VOLUTE_CHECK(!panels.empty() && columns >= 1, panels.size(), columns);
  const int width = panels.front().image.width, height = panels.front().image.height;
  for (const FigurePanel& panel : panels)
    VOLUTE_CHECK(panel.image.width == width && panel.image.height == height, panel.image.width, panel.image.height);
  const int count = static_cast<int>(panels.size()), across = std::min(columns, count);
  const int rows = (count + across - 1) / across, cell = height + caption_height;
  Image sheet{across * width + (across + 1) * sheet_gap, rows * cell + (rows + 1) * sheet_gap, {}};
  sheet.bgra.assign(static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height) * 4, 255);
  const auto place = [&](int i) {
    return std::array{sheet_gap + (i % across) * (width + sheet_gap), sheet_gap + (i / across) * (cell + sheet_gap)};
  };
  for (int i = 0; i < count; ++i) copy_into(sheet, panels[static_cast<std::size_t>(i)].image, place(i)[0], place(i)[1]);
  const std::unique_ptr<cairo_surface_t, CairoCloser> surface(cairo_image_surface_create_for_data(
      sheet.bgra.data(), CAIRO_FORMAT_RGB24, sheet.width, sheet.height, sheet.width * 4));
  const std::unique_ptr<cairo_t, CairoCloser> cairo(cairo_create(surface.get()));
  for (int i = 0; i < count; ++i)
    write_caption(cairo.get(), panels[static_cast<std::size_t>(i)].caption, place(i)[0], place(i)[1] + height, width);
  cairo_surface_flush(surface.get());
  round_shades(sheet, sheet_shades);
  return sheet;
}

}  // namespace volute::view
