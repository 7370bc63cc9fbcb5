// A picture in memory, and what can be done with it without knowing what it shows.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/result.hpp"

namespace volute::view {

/// Red, green, blue from 0 to 1.
using Colour = std::array<float, 3>;

/// Rows from the top, 4 bytes a pixel: blue, green, red, alpha (255), as cairo's RGB24 wants them.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bgra;
};

/// Mean of `factor` x `factor` pixels: anti-aliasing of a picture drawn larger. Requires: sizes divisible by factor.
Image reduced(const Image& large, int factor);

/// Every channel rounded to one of `levels` evenly spaced values from 0 to 255: a PNG of line art then takes about half
/// the bytes. Requires: 2 <= levels <= 256. Property: rounding twice is rounding once.
void round_shades(Image& image, int levels);

/// PNG as bytes. Deterministic.
std::string png_bytes(const Image& image);

}  // namespace volute::view
