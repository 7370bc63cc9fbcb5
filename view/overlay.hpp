// What is written over a picture: title, colour bar, scale, axes triad. Drawn by cairo.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "view/camera.hpp"
#include "view/image.hpp"

namespace volute::view {

/// A bar from least to greatest with ticks and a label that says quantity and unit.
struct ColourBar {
  std::string label;
  double least = 0.0, greatest = 1.0;
  std::function<Colour(double share)> colour;  ///< share 0 at least, 1 at greatest
};

/// A colour with what it stands for.
struct ColourKey {
  std::string name;
  Colour colour{};
};

struct Overlay {
  std::string title;
  std::vector<std::string> notes;  ///< lines under the title
  const ColourBar* bar = nullptr;
  bool triad = true, scale = true;
  std::vector<ColourKey> keys = {};  ///< a list at the right, under the bar's place
  double text_scale = 1.0;           ///< times the size that suits 1200 pixels of height
};

/// Writes over `image` in place. The triad and the scale belong to `camera`.
void draw_overlay(Image& image, const Camera& camera, const Overlay& overlay);

/// 1, 2 or 5 times a power of ten, so that `span` holds about `wanted` of them.
double round_step(double span, int wanted);

}  // namespace volute::view
