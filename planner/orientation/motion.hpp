// What the rotary axes do at programmed feed, before any control: the numbers by which methods are compared.
#pragma once

#include <span>

#include "planner/orientation/orient.hpp"

namespace volute::planner {

/// Difference quotients of [Sun2016] eq. 26 and 32 and the third of the same kind, at constant feed; r.m.s. weighted by
/// length. All 0 where there are too few points. Each is the mean of the derivative over its places (6, 2 and 1 times a
/// divided difference), so at any spacing: 1. CubicsGiveTheirDerivatives: of a cubic the third is exact everywhere.
/// 2. NoQuotientPassesTheDerivative: none is above the largest derivative of a curve through the points.
AxisMotionPeaks motion_peaks(std::span<const double> s_mm, std::span<const double> phi_rad, double feed_mm_s);

}  // namespace volute::planner
