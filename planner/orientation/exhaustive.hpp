// Proof by search that nothing is allowed at a point: before a part is refused, and never otherwise.
#pragma once

#include <optional>
#include <vector>

#include "planner/orientation/allowed_set.hpp"

namespace volute::planner {

/// Directions round the normal out to tilt_max on rings no further apart than this, and no further apart on a ring.
constexpr geometry::Angle exhaustive_step = geometry::Angle::degrees(0.5);

/// The first allowed axis at station i, from the normal outwards; nothing when none of all is allowed.
std::optional<Vec3> exhaustive_search(const AllowedSet& allowed, int i, geometry::Angle step);

/// The stations where exhaustive_search finds nothing. Rings 2 degrees apart about `wanted` come first: they find most.
std::vector<int> stations_without_orientation(const AllowedSet& allowed, const std::vector<Vec3>& wanted);

}  // namespace volute::planner
