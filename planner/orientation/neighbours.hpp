// Which places of the turn before and of the turn after lie beside each place of the path.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "planner/orientation/stations.hpp"

namespace volute::planner {

/// Neighbouring passes are looked for within this distance.
constexpr double neighbour_reach_mm = 5.0;

/// Stations nearest to a station on the turn before and on the turn after (between half a turn and one and a half away,
/// so that passes beside a floating hole are found too); -1: none within reach.
using Beside = std::array<int, 2>;

/// One entry a station of `wanted`, in its order. Without turns all are -1. Deterministic: of equally near stations the
/// first.
std::vector<Beside> neighbouring_stations(std::span<const Station> stations, std::span<const int> wanted,
                                          double reach_mm);

/// The largest angle between the axis at a point and the axis at the nearest point of the next turn of the spiral
/// (contact points within `reach_mm`). 0 without turns.
double neighbour_turn_max_rad(std::span<const Station> stations, std::span<const Vec3> axes_P, double reach_mm);

}  // namespace volute::planner
