#include "planner/path/even_measure.hpp"

#include <cmath>
#include <vector>

namespace volute::planner {
namespace {

/// Points at equal arc length along the piece.
std::vector<Vec3> evenly_spaced(const CcPiece& piece, double spacing_mm) {
  std::vector<Vec3> out;
  if (piece.points.empty()) return out;
  out.push_back(piece.points.front().point_P_mm);
  double behind = 0.0;  // arc length since the last point put out
  for (std::size_t i = 1; i < piece.points.size(); ++i) {
    const Vec3 &a = piece.points[i - 1].point_P_mm, &b = piece.points[i].point_P_mm;
    const double length = (b - a).norm();
    double along = spacing_mm - behind;
    for (; along <= length; along += spacing_mm) out.push_back(a + (b - a) * (along / length));
    behind = length - (along - spacing_mm);
  }
  return out;
}

}  // namespace

double path_length_mm(const CcPath& path) {
  double sum = 0.0;
  for (const CcPiece& piece : path.pieces) {
    for (std::size_t i = 1; i < piece.points.size(); ++i) {
      sum += (piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm).norm();
    }
  }
  return sum;
}

int sharp_corners(const CcPath& path, double chord_mm, geometry::Angle angle) {
  constexpr std::size_t steps = 8;  // samples a chord
  const double cosine = cos(angle);
  int count = 0;
  for (const CcPiece& piece : path.pieces) {
    const auto p = evenly_spaced(piece, chord_mm / steps);
    std::size_t last = 0;
    bool any = false;
    for (std::size_t i = steps; i + steps < p.size(); ++i) {
      const Vec3 before = p[i] - p[i - steps], after = p[i + steps] - p[i];
      if (before.dot(after) >= cosine * before.norm() * after.norm()) continue;
      if (!any || i - last > steps) ++count;
      last = i;
      any = true;
    }
  }
  return count;
}

}  // namespace volute::planner
