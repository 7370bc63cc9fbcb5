// Colours for values, readable by colour-blind people.
#pragma once

#include "view/image.hpp"

namespace volute::view {

/// Viridis: dark blue to yellow, lightness rising evenly. `share` in [0, 1]; outside is drawn as the nearer end.
Colour sequential_colour(double share);
/// Blue - light grey - red-brown for deviations: `share` in [-1, 1], 0 in the middle.
Colour diverging_colour(double share);

}  // namespace volute::view
