#include "tests/planner/path/dense_scallop.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/mesh_measure.hpp"

namespace volute::planner::samples {

double greatest_scallop_ratio(const geometry::TriangleMesh& mesh, const CcPath& path, double radius_mm,
                              double scallop_mm, int count, unsigned seed) {
  const auto normals = geometry::vertex_normals(mesh);
  std::vector<Vec3> centres;
  for (const CcPiece& piece : path.pieces) {
    for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
      const CcPoint &a = piece.points[i], &b = piece.points[i + 1];
      const int steps = 1 + static_cast<int>((b.point_P_mm - a.point_P_mm).norm() / 0.1);
      for (int s = 0; s < steps; ++s) {
        const double w = static_cast<double>(s) / steps;
        centres.push_back((1 - w) * a.point_P_mm + w * b.point_P_mm +
                          radius_mm * ((1 - w) * a.normal_P + w * b.normal_P).normalized());
      }
    }
  }
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::size_t> pick(0, mesh.triangles.size() - 1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto& t = mesh.triangles[pick(random)];
    double a = share(random), b = share(random);
    if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
    const auto mix = [&](const std::vector<Vec3>& v) {
      return Vec3(a * v[static_cast<std::size_t>(t[0])] + b * v[static_cast<std::size_t>(t[1])] +
                  (1.0 - a - b) * v[static_cast<std::size_t>(t[2])]);
    };
    const Vec3 x = mix(mesh.vertices_mm), n = mix(normals).normalized();
    double least = radius_mm;
    for (const Vec3& c : centres) {
      const Vec3 d = c - x;
      const double along = d.dot(n), disc = radius_mm * radius_mm - d.squaredNorm() + along * along;
      if (disc >= 0.0) least = std::min(least, along - std::sqrt(disc));
    }
    worst = std::max(worst, least / scallop_mm);
  }
  return worst;
}

}  // namespace volute::planner::samples
