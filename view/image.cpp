#include "view/image.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::view {

Image reduced(const Image& large, int factor) {
  VOLUTE_CHECK(factor > 0 && large.width % factor == 0 && large.height % factor == 0, large.width, large.height,
               factor);
  Image small{large.width / factor, large.height / factor, {}};
  small.bgra.resize(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height) * 4);
  const auto stride = static_cast<std::size_t>(large.width) * 4;
  const unsigned count = static_cast<unsigned>(factor * factor);
  std::vector<unsigned> rows(stride);  // sums over the rows of one row of the small picture
  std::size_t out = 0;
  for (int y = 0; y < small.height; ++y) {
    std::fill(rows.begin(), rows.end(), 0U);
    for (int dy = 0; dy < factor; ++dy) {
      const std::uint8_t* row = &large.bgra[static_cast<std::size_t>(y * factor + dy) * stride];
      for (std::size_t i = 0; i < stride; ++i) rows[i] += row[i];
    }
    const unsigned* block = rows.data();
    for (int x = 0; x < small.width; ++x, block += static_cast<std::ptrdiff_t>(factor) * 4)
      for (int channel = 0; channel < 4; ++channel) {
        unsigned sum = 0;
        for (int dx = 0; dx < factor; ++dx) sum += block[dx * 4 + channel];
        small.bgra[out++] = static_cast<std::uint8_t>((sum + count / 2) / count);
      }
  }
  return small;
}

void round_shades(Image& image, int levels) {
  VOLUTE_CHECK(levels >= 2 && levels <= 256, levels);
  std::array<std::uint8_t, 256> rounded{};
  const double step = 255.0 / (levels - 1);
  for (std::size_t value = 0; value < rounded.size(); ++value)
    rounded[value] = static_cast<std::uint8_t>(std::lround(std::round(static_cast<double>(value) / step) * step));
  for (std::uint8_t& channel : image.bgra) channel = rounded[channel];
}

std::string png_bytes(const Image& image) {
  std::vector<std::uint8_t> pixels = image.bgra;
  const int stride = cairo_format_stride_for_width(CAIRO_FORMAT_RGB24, image.width);
  VOLUTE_CHECK(stride == image.width * 4, stride, image.width);
  cairo_surface_t* surface =
      cairo_image_surface_create_for_data(pixels.data(), CAIRO_FORMAT_RGB24, image.width, image.height, stride);
  std::string bytes;
  const auto append = [](void* out, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  };
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface, append, &bytes);
  cairo_surface_destroy(surface);
  VOLUTE_CHECK(status == CAIRO_STATUS_SUCCESS, cairo_status_to_string(status));
  return bytes;
}

}  // namespace volute::view
