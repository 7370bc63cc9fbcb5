#include "planner/orientation/motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace volute::planner {

namespace {

/// Greatest magnitude and length-weighted mean square of samples.
struct Peak {
  double greatest = 0.0, sum_sq = 0.0, length = 0.0;
  void add(double value, double weight) {
    greatest = std::max(greatest, std::abs(value));
    sum_sq += weight * value * value;
    length += weight;
  }
  [[nodiscard]] double rms() const { return length > 0.0 ? std::sqrt(sum_sq / length) : 0.0; }
};

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

AxisMotionPeaks motion_peaks(std::span<const double> s_mm, std::span<const double> phi_rad, double feed_mm_s) {
  Peak velocity, acceleration, jerk;
  double v_last = 0.0, a_last = 0.0, step_last = 0.0;
  for (std::size_t i = 0; i + 1 < s_mm.size(); ++i) {
    const double step = s_mm[i + 1] - s_mm[i];
    const double v = (phi_rad[i + 1] - phi_rad[i]) / step * feed_mm_s;
    velocity.add(v, step);
    if (i > 0) {
      const double between = 0.5 * (step + step_last), a = (v - v_last) / between * feed_mm_s;
      acceleration.add(a, between);
      if (i > 1) jerk.add((a - a_last) / step_last * feed_mm_s, step_last);
      a_last = a;
    }
    v_last = v;
    step_last = step;
  }
  return {velocity.greatest, acceleration.greatest, jerk.greatest, velocity.rms(), acceleration.rms(), jerk.rms()};
}

double neighbour_turn_max_rad(std::span<const Station> stations, std::span<const Vec3> axes_P, double reach_mm) {
  const PointGrid grid(stations, reach_mm);
  double greatest = 0.0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    double nearest = reach_mm;
    int other = -1;
    grid.near(stations[i].contact_P_mm, [&](int j) {
      const double ahead = stations[static_cast<std::size_t>(j)].turn - stations[i].turn;
      if (ahead < 0.5 || ahead > 1.5) return;
      const double d = (stations[static_cast<std::size_t>(j)].contact_P_mm - stations[i].contact_P_mm).norm();
      if (d < nearest) nearest = d, other = j;
    });
    if (other < 0) continue;
    const Vec3& a = axes_P[i];
    const Vec3& b = axes_P[static_cast<std::size_t>(other)];
    greatest = std::max(greatest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return greatest;
}

}  // namespace volute::planner
