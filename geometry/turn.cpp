#include "geometry/turn.hpp"

#include <cmath>

namespace volute::geometry {

Eigen::Quaterniond turn_from_z(const Vec3& axis) {
  const Vec3 to = axis.normalized();
  const Vec3 across = Vec3::UnitZ().cross(to);
  if (to.z() < 0.0) {  // 1 + z would lose digits: the sine has them
    const double sine = across.norm();
    if (sine == 0.0) return {0.0, 1.0, 0.0, 0.0};
    const double t = std::sqrt(2.0 * (1.0 - to.z()));
    const Vec3 vector = 0.5 * t / sine * across;
    return {sine / t, vector.x(), vector.y(), vector.z()};
  }
  const double s = std::sqrt(2.0 * (1.0 + to.z()));
  const Vec3 vector = across / s;
  return {0.5 * s, vector.x(), vector.y(), vector.z()};
}

}  // namespace volute::geometry
