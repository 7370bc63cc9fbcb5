#include "planner/path/path_interval.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "planner/contact.hpp"
#include "planner/path/cc_path.hpp"

namespace volute::planner {

double path_interval_mm(double ball_radius_mm, double scallop_mm, double curvature_per_mm) {
  const double r = ball_radius_mm, h = scallop_mm, k = curvature_per_mm;
  VOLUTE_CHECK(r > 0.0 && h > 0.0 && h < r, r, h);
  const double q = (2.0 * r * h - h * h) / ((1.0 + k * r) * (1.0 + k * h));
  return 2.0 * std::sqrt(q) * std::sqrt(1.0 - 0.25 * k * k * q);
}

double path_interval_eq20_mm(double ball_radius_mm, double scallop_mm, double curvature_per_mm) {
  VOLUTE_CHECK(ball_radius_mm > 0.0 && scallop_mm > 0.0, ball_radius_mm, scallop_mm);
  return std::sqrt(8.0 * scallop_mm * ball_radius_mm / (1.0 + curvature_per_mm * ball_radius_mm));
}

double IntervalRule::interval_mm(double curvature_per_mm) const {
  const double hollow_limit = (fit_min - 1.0) / radius_mm;
  const double k = std::max(curvature_per_mm, hollow_limit);
  return std::min(path_interval_mm(radius_mm, scallop_mm, k), interval_max_mm);
}

IntervalRule interval_rule(const kinematics::Cutter& cutter, double scallop_mm, const OrientationOptions& orientation) {
  const double radius_mm = clearing_radius_mm(cutter, orientation.tilt, orientation.yaw, scallop_mm);
  return {radius_mm, scallop_mm, 1.8 * cutter.radius_mm};
}

IntervalField::IntervalField(const TriangleMesh& mesh, const IntervalRule& rule)
    : IntervalField(mesh, rule, geometry::triangle_curvature(mesh)) {}

IntervalField::IntervalField(const TriangleMesh& mesh, const IntervalRule& rule, std::vector<Mat3> curvature)
    : rule_(rule), tensor_(std::move(curvature)) {
  VOLUTE_CHECK(tensor_.size() == mesh.triangles.size(), tensor_.size(), mesh.triangles.size());
  const std::vector<Vec3> normals = geometry::triangle_normals(mesh);
  double area = 0.0, too_tight = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double triangle_mm2 = geometry::triangle_area_mm2(mesh, static_cast<Index>(t));
    const geometry::PrincipalCurvature principal = geometry::principal_curvature(tensor_[t], normals[t]);
    const double least = principal.least_per_mm;
    widest_mm_.push_back(rule_.interval_mm(least));
    narrowest_mm_.push_back(rule_.interval_mm(principal.greatest_per_mm));
    lower_bound_mm_ += triangle_mm2 / widest_mm_.back();
    area += triangle_mm2;
    if (1.0 + least * rule_.radius_mm <= 0.0) too_tight += triangle_mm2;
  }
  too_tight_share_ = area > 0.0 ? too_tight / area : 0.0;
}

}  // namespace volute::planner
