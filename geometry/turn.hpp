// The turn that stands a frame on a direction.
#pragma once

#include "geometry/vector.hpp"

namespace volute::geometry {

/// The shortest turn that takes the z axis to `axis` (any length above 0). Opposite to z: half a turn about x.
/// Accuracy: the turned z axis stands within 2e-15 of `axis`, next to the opposite direction too.
/// Properties: 1. The turn's own axis is at right angles to z. 2. turn_from_z(UnitZ()) is no turn.
/// Eigen's Quaternion::FromTwoVectors does the same with a singular value decomposition for the opposite case, whose
/// templates took 14 s of every source that called it.
Eigen::Quaterniond turn_from_z(const Vec3& axis);

}  // namespace volute::geometry
