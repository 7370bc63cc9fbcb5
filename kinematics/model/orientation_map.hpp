// Which orientations of the tool are allowed at one CC point: what a C-space map shows.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vector.hpp"

namespace volute::kinematics {

/// free and blocked are proved for every orientation of the cell; unsure cells are as small as the map's resolution.
enum class OrientationState : std::uint8_t { free, blocked, unsure, tilt_limit, width_limit, travel_limit };

/// A box of orientations, rad.
struct OrientationCell {
  std::array<double, 2> least{}, greatest{};
  OrientationState state = OrientationState::unsure;
  bool centre_free = false;  ///< the middle of the cell is allowed
  int blocker = -1;          ///< index into OrientationMap::blockers of what the middle touches; -1: nothing
};

/// Two angles and the cells that cover their ranges without overlap.
struct OrientationChart {
  std::array<std::string, 2> names;  ///< "yaw", "tilt" or the letters of the rotaries; the first one is drawn across
  std::vector<OrientationCell> cells;
  /// Rad. Chosen at this CC point, when there is a plan, and at the points before and after it in the order of the
  /// path.
  std::optional<std::array<double, 2>> chosen;
  std::vector<std::array<double, 2>> path;
};

struct OrientationMap {
  int cc_point = 0;  ///< index among the cutting points
  geometry::Vec3 contact_P_mm = geometry::Vec3::Zero(), normal_P = geometry::Vec3::UnitZ();
  OrientationChart lean;              ///< yaw about the normal from the feed, tilt from the normal
  OrientationChart rotaries;          ///< axes[4] across, axes[3] up, within travel
  std::vector<std::string> blockers;  ///< "holder against post"
  double resolution_rad = 0.0;        ///< no cell is halved below this
  double free_share = 0.0;            ///< of the directions within the limits of tilt, by the middles of the cells
  /// How far the chosen axis may turn, whichever way, before anything could touch: a lower bound, rad.
  std::optional<double> margin_rad;
};

}  // namespace volute::kinematics
