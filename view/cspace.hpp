// C-space map: which orientations are allowed at a CC point, what forbids the others, and what was chosen.
#pragma once

#include <string>

#include "kinematics/model/orientation_map.hpp"
#include "view/image.hpp"

namespace volute::view {

/// Two panels side by side, yaw and tilt, and the two rotaries: free cells green, blocked ones in the colour of what
/// blocks, cells that cannot be told apart at the resolution white, limits in greys; the orientations that the path
/// takes before and after as a line, the one chosen here as a ring. 1800 x 1000 pixels. `title`: the line on top; the
/// point, its share of free directions, margin, resolution and the share of what it could not tell apart are written
/// too. Deterministic.
Image draw_cspace_map(const kinematics::OrientationMap& map, const std::string& title);

/// Share of a chart's area that is neither proved free nor proved blocked, nor forbidden by a limit.
double unsure_share(const kinematics::OrientationChart& chart);

}  // namespace volute::view
