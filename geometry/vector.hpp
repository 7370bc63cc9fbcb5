// Vectors and rigid transforms used by every folder. Length unit: millimetre unless a name says otherwise.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace volute::geometry {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// A rigid transform X_AB: it takes coordinates in frame B to coordinates in frame A, p_A = X_AB * p_B.
using Transform = Eigen::Isometry3d;

}  // namespace volute::geometry
