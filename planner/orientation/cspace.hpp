// The allowed set at a CC point as a map: cells of orientations proved free, proved blocked, or too small to halve.
#pragma once

#include <vector>

#include "kinematics/model/orientation_map.hpp"
#include "planner/orientation/allowed_set.hpp"

namespace volute::planner {

struct CspaceOptions {
  geometry::Angle resolution = geometry::Angle::degrees(0.5);  ///< cells of this width and less are not halved
};

/// The map of station i, over tilt and yaw and over both rotaries.
///
/// A cell is free when the assembly in its middle stands farther from everything than its points there move within the
/// cell, and blocked when it stands deeper in something than that: so free and blocked hold for every orientation of
/// the cell. Points near the contact hardly move (TurnBound), so flat and bull ends, which touch there, are proved as
/// well as balls. Else the cell is halved, down to the resolution. Limits of tilt are exact; limits of width and travel
/// are told by middle and corners of a cell; the machine's links are looked at in the middle of each cell of the
/// rotaries' map.
///
/// Properties, each with a test of that name: 1. FreeCellsAreFreeThroughout. 2. BlockedCellsAreBlockedThroughout.
/// 3. CellsCoverTheRangesOnce. 4. FreeShareOfAWallIsItsClosedForm.
kinematics::OrientationMap orientation_map(const AllowedSet& allowed, int i, const CspaceOptions& options);

/// How far the axis may turn from `axis_P`, whichever way, before the assembly could touch anything: a lower bound, to
/// a hundredth of a degree; 0 where it touches already. The machine's links are not looked at.
double free_turn_rad(const AllowedSet& allowed, int i, const Vec3& axis_P);

}  // namespace volute::planner
