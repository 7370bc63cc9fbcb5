// What the rotary axes do at programmed feed, before any control: the numbers by which methods are compared.
#pragma once

#include <span>

#include "planner/orientation/orient.hpp"
#include "planner/orientation/rotary_chart.hpp"
#include "planner/orientation/stations.hpp"

namespace volute::planner {

/// Difference quotients of [Sun2016] eq. 26 and 32 and the next one of the same kind, at constant feed; r.m.s. weighted
/// by length. All 0 where there are too few points.
AxisMotionPeaks motion_peaks(std::span<const double> s_mm, std::span<const double> phi_rad, double feed_mm_s);

/// The largest angle between the axis at a point and the axis at the nearest point of the next turn of the spiral
/// (contact points within `reach_mm`). 0 without turns.
double neighbour_turn_max_rad(std::span<const Station> stations, std::span<const Vec3> axes_P, double reach_mm);

}  // namespace volute::planner
