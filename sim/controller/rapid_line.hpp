// A straight rapid, as its planner needs it.
#pragma once

#include <array>
#include <optional>

#include "sim/controller/path_point.hpp"

namespace volute::sim {

/// A straight rapid: of the tip while both rotaries turn evenly or the axis vector follows the great circle (`tcp`), or
/// of all axes.
struct RapidLine {
  bool tcp = false;
  Vec3 from_tip_P_mm, to_tip_P_mm;
  AxisVector from_q, to_q;
  double least_time_s = 0.0;  ///< as the rapid feed and the least block time have it
  /// The great circle's ends; nothing: the rotaries turn evenly.
  std::optional<std::array<Vec3, 2>> circle_P = std::nullopt;
};

/// The direction at a share of the way on the great circle. Requires: an angle above rounding and below half a turn.
Vec3 on_circle(const Vec3& from, const Vec3& to, double share);

}  // namespace volute::sim
