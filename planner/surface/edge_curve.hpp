// The curve that stands for a mesh edge on the nominal surface ([Sun2016] 5.1): cubic Bezier through both ends, across
// both normals.
#pragma once

#include <array>

#include "geometry/vector.hpp"

namespace volute::planner {

using geometry::Vec3;

/// Point-normal interpolation, [Sun2016] eq. 15, 16. Departs from the source: eta = +(2 b.n_i + a b.n'_{i+1}) / (4 -
/// a^2), the sign that makes the curve tangent to the surface at its first end; mu keeps the printed sign. Also: both
/// normals are taken in the plane of the edge and their mean (the source: of the edge and n_i), for property 3.
/// Properties: 1. r(0), r(1) are the edge's ends. 2. r'(0).n_i = 0 and r'(1).n'_{i+1} = 0. 3. The curve from the other
/// end is the same curve. 4. On a sphere of radius R and edges of length e its distance from the sphere is O(e^4 /
/// R^3).
class EdgeCurve {
 public:
  /// Requires: unit normals, ends apart.
  EdgeCurve(const Vec3& from_mm, const Vec3& to_mm, const Vec3& normal_from, const Vec3& normal_to);

  [[nodiscard]] Vec3 point_mm(double t) const;
  /// dr/dt, mm.
  [[nodiscard]] Vec3 derivative_mm(double t) const;

 private:
  std::array<Vec3, 4> control_mm_;
};

}  // namespace volute::planner
