// Several pictures as one: panels with captions, as figures of papers have them.
#pragma once

#include <string>
#include <vector>

#include "view/image.hpp"
#include "view/pictures.hpp"

namespace volute::view {

struct FigurePanel {
  std::string caption;  ///< "(a) ..."; stands under the picture
  Image image;
};

/// Adds a panel, or hands the error on.
Result<void> add_panel(std::vector<FigurePanel>& panels, const std::string& caption, Result<Image> image);

/// The style of a panel: without title, with text that can still be read.
PictureStyle panel_style(int width_px = 560, int height_px = 420);

/// The panels row by row, `columns` in a row, each with its caption under it, on white, in 32 shades a channel (a
/// document holds many). Requires: at least one panel,
/// columns >= 1, all panels of one size.
Image figure_sheet(const std::vector<FigurePanel>& panels, int columns);

}  // namespace volute::view
