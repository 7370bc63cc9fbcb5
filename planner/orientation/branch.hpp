// Which branch and turn of the rotaries stands for each of a row of tool axes: the row with the least motion.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/orientation/rotary_chart.hpp"

namespace volute::planner {

struct PlacedAxis {
  Vec3 axis_P;
  double s_mm = 0.0;
  bool pin_free_axis = false;
};
/// Values that stand for the axis; nothing where the rotary is free (at the pole).
using OptionalRotaries = std::array<std::optional<double>, 2>;

/// Dynamic programming over both branches and all turns within travel: least sum of (change)^2 / (arc length), the
/// energy of [Sun2016] eq. 27. An endless rotary takes the turn next to the value before. Where the chart comes from
/// another piece, the way from there counts like any other, so that of equal rows the one with the least turn in the
/// rapid stands. `pin_free_axis`: at the pole,
/// too, the value is kept. Nothing when an axis cannot be reached; its index is then in `unreachable`.
struct BranchChoice {
  std::vector<OptionalRotaries> at;
  int unreachable = -1;
  double jump_max_rad = 0.0;
};
BranchChoice choose_branches(const RotaryChart& chart, std::span<const PlacedAxis> axes);

/// The same with free values filled in linearly between their neighbours.
std::vector<Rotaries> filled(const BranchChoice& choice, std::span<const PlacedAxis> axes);

}  // namespace volute::planner
