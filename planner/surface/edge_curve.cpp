#include "planner/surface/edge_curve.hpp"

namespace volute::planner {

namespace {

/// The unit projection of `normal` on the plane of `edge` and `other`; `normal` itself where it stands across that
/// plane.
Vec3 in_normal_section(const Vec3& normal, const Vec3& edge, const Vec3& other) {
  const Vec3 across = edge.cross(other);
  if (across.norm() < 1e-12 * edge.norm()) return normal;
  const Vec3 unit = across.normalized();
  const Vec3 projected = normal - normal.dot(unit) * unit;
  return projected.norm() > 1e-6 ? Vec3(projected.normalized()) : normal;
}

}  // namespace

EdgeCurve::EdgeCurve(const Vec3& from_mm, const Vec3& to_mm, const Vec3& normal_from, const Vec3& normal_to) {
  const Vec3 b = to_mm - from_mm;
  // Each end's normal is taken in the plane of the edge and the mean normal: the same curve from either end.
  const Vec3 mean = normal_from + normal_to;
  const Vec3 n0 = in_normal_section(normal_from, b, mean), n1 = in_normal_section(normal_to, b, mean);
  const double a = n0.dot(n1);
  const double eta = (2.0 * b.dot(n0) + a * b.dot(n1)) / (4.0 - a * a);
  const double mu = -(2.0 * b.dot(n1) + a * b.dot(n0)) / (4.0 - a * a);
  control_mm_ = {from_mm, (2.0 * from_mm + to_mm - 2.0 * eta * n0 - mu * n1) / 3.0,
                 (2.0 * to_mm + from_mm - 2.0 * mu * n1 - eta * n0) / 3.0, to_mm};
}

Vec3 EdgeCurve::point_mm(double t) const {
  const double s = 1.0 - t;
  return s * s * s * control_mm_[0] + 3.0 * s * s * t * control_mm_[1] + 3.0 * s * t * t * control_mm_[2] +
         t * t * t * control_mm_[3];
}

Vec3 EdgeCurve::derivative_mm(double t) const {
  const double s = 1.0 - t;
  return 3.0 * (s * s * (control_mm_[1] - control_mm_[0]) + 2.0 * s * t * (control_mm_[2] - control_mm_[1]) +
                t * t * (control_mm_[3] - control_mm_[2]));
}

}  // namespace volute::planner
