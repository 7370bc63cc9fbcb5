#include "planner/orientation/neighbours.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace volute::planner {

namespace {

/// Buckets of points in cells of a grid, sorted, so that the order never depends on hashing.
class PointGrid {
 public:
  PointGrid(std::span<const Station> stations, double cell_mm) : cell_mm_(cell_mm) {
    for (std::size_t i = 0; i < stations.size(); ++i)
      entries_.push_back({key(cell(stations[i].contact_P_mm)), static_cast<int>(i)});
    std::sort(entries_.begin(), entries_.end());
  }
  template <class Visit>
  void near(const Vec3& point_mm, Visit visit) const {
    const Eigen::Array3i c = cell(point_mm);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const std::uint64_t k = key(c + Eigen::Array3i(dx, dy, dz));
          for (auto it = std::lower_bound(entries_.begin(), entries_.end(), std::pair<std::uint64_t, int>{k, -1});
               it != entries_.end() && it->first == k; ++it)
            visit(it->second);
        }
      }
    }
  }

 private:
  [[nodiscard]] Eigen::Array3i cell(const Vec3& p) const { return (p / cell_mm_).array().floor().cast<int>(); }
  static std::uint64_t key(const Eigen::Array3i& c) {
    std::uint64_t k = 0;
    for (Eigen::Index i = 0; i < 3; ++i) k = (k << 21) | (static_cast<std::uint64_t>(c[i] + (1 << 20)) & 0x1FFFFF);
    return k;
  }
  double cell_mm_;
  std::vector<std::pair<std::uint64_t, int>> entries_;
};

}  // namespace

std::vector<Beside> neighbouring_stations(std::span<const Station> stations, std::span<const int> wanted,
                                          double reach_mm) {
  const PointGrid grid(stations, reach_mm);
  std::vector<Beside> found(wanted.size(), {-1, -1});
  tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t k) {
    const Station& here = stations[static_cast<std::size_t>(wanted[k])];
    std::array<double, 2> nearest = {reach_mm, reach_mm};
    grid.near(here.contact_P_mm, [&](int j) {
      const Station& there = stations[static_cast<std::size_t>(j)];
      const double ahead = there.turn - here.turn;
      if (std::abs(ahead) < 0.5 || std::abs(ahead) > 1.5) return;
      const std::size_t side = ahead > 0.0 ? 1 : 0;
      const double d = (there.contact_P_mm - here.contact_P_mm).norm();
      if (d < nearest[side]) nearest[side] = d, found[k][side] = j;
    });
  });
  return found;
}

double neighbour_turn_max_rad(std::span<const Station> stations, std::span<const Vec3> axes_P, double reach_mm) {
  std::vector<int> all(stations.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<Beside> beside = neighbouring_stations(stations, all, reach_mm);
  double greatest = 0.0;
  for (std::size_t i = 0; i < beside.size(); ++i) {
    if (beside[i][1] < 0) continue;
    const Vec3& a = axes_P[i];
    const Vec3& b = axes_P[static_cast<std::size_t>(beside[i][1])];
    greatest = std::max(greatest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return greatest;
}

}  // namespace volute::planner
