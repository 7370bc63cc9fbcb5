// The pictures of a run, each from the data that it needs.
#pragma once

#include "view/image.hpp"
#include "view/run_view.hpp"

namespace volute::view {

constexpr int picture_width = 1600, picture_height = 1200;

/// The tool path on the part, coloured by turn of the spiral; rapids in grey. From the trace when nothing was planned here.
Result<Image> path_picture(const RunView& view);
/// The machined surface coloured by deviation. Requires: view.cut with vertex deviations.
Result<Image> machined_picture(const RunView& view);

}  // namespace volute::view
