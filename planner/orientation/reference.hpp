// A calm target for the tool axis at every point: what pins are taken from and what dodging starts from.
#pragma once

#include <vector>

#include "planner/orientation/allowed_set.hpp"
#include "planner/orientation/turn_means.hpp"

namespace volute::planner {

/// The planned axes (tilt and yaw in the feed frame), averaged over one turn of the spiral round each point (over
/// `window_mm` of path where there are no turns), then turned the least to keep the tilt limits; where another limit
/// still stands against it, moved towards the planned axis until none does. On a spiral the lean along the feed
/// averages out over the turn, so that the rotaries need not go round with the feed; on an open path it stays.
/// `turns`: of the whole path, where the stations are one piece of several; empty: the stations' own turns.
std::vector<Vec3> reference_axes(const AllowedSet& allowed, double window_mm, const TurnMeans* turns = nullptr);

}  // namespace volute::planner
