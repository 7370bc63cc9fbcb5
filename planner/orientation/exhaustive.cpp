#include "planner/orientation/exhaustive.hpp"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

#include "geometry/turn.hpp"

namespace volute::planner {

using geometry::Angle;

std::optional<Vec3> exhaustive_search(const AllowedSet& allowed, int i, Angle step) {
  const Vec3& normal = allowed.stations()[static_cast<std::size_t>(i)].normal_P;
  const Eigen::Quaterniond turn = geometry::turn_from_z(normal);
  const double quarter = 0.5 * std::numbers::pi;
  const int rings = static_cast<int>(std::ceil(quarter / step.radians()));
  for (int r = 0; r <= rings; ++r) {
    // Tilt limits are looked at by the set; past a right angle nothing is ever allowed.
    const double polar = quarter * r / rings;
    const int count = std::max(1, static_cast<int>(std::ceil(4.0 * quarter * std::sin(polar) / step.radians())));
    for (int k = 0; k < count; ++k) {
      const double a = 4.0 * quarter * k / count;
      const Vec3 axis = turn * Vec3(std::sin(polar) * std::cos(a), std::sin(polar) * std::sin(a), std::cos(polar));
      if (allowed.blocked(i, axis) == Blocked::no) return axis;
    }
  }
  return std::nullopt;
}

std::vector<int> stations_without_orientation(const AllowedSet& allowed, const std::vector<Vec3>& wanted) {
  const std::size_t n = wanted.size();
  std::vector<char> empty(n, 0);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
    const int station = static_cast<int>(i);
    if (!allowed.nearest(station, wanted[i], Angle()) && !exhaustive_search(allowed, station, exhaustive_step))
      empty[i] = 1;
  });
  std::vector<int> found;
  for (std::size_t i = 0; i < n; ++i) {
    if (empty[i] != 0) found.push_back(static_cast<int>(i));
  }
  return found;
}

}  // namespace volute::planner
