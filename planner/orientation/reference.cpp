#include "planner/orientation/reference.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace volute::planner {

namespace {

constexpr int bisections = 12;
// How much the machine's rest direction weighs against the mean: it decides only where the mean all but vanishes.
constexpr double rest_share = 0.05;

struct Window {
  std::size_t from, to;
};  // half open

bool turns_rise(std::span<const Station> stations) {
  const auto falls = std::adjacent_find(stations.begin(), stations.end(),
                                        [](const Station& a, const Station& b) { return b.turn < a.turn - 0.5; });
  return falls == stations.end() && stations.back().turn - stations.front().turn > 1.0;
}

/// Half a turn, or half the window, to both sides.
std::vector<Window> windows(std::span<const Station> stations, double window_mm) {
  const bool by_turn = turns_rise(stations);
  const double half = by_turn ? 0.5 : 0.5 * window_mm;
  const auto place = [&](std::size_t i) { return by_turn ? stations[i].turn : stations[i].s_mm; };
  std::vector<Window> all(stations.size());
  std::size_t from = 0, to = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    while (from < i && place(from) < place(i) - half) ++from;
    while (to < stations.size() && place(to) <= place(i) + half) ++to;
    all[i] = {from, std::max(to, i + 1)};
  }
  return all;
}

Vec3 moved_inside(const AllowedSet& allowed, int i, const Vec3& axis, const Vec3& planned) {
  const auto stands = [&](const Vec3& a) {
    return allowed.process_limit(i, a) == Blocked::no && allowed.chart().reaches(a);
  };
  if (stands(axis) || !stands(planned)) return axis;
  double good = 1.0, bad = 0.0;
  for (int round = 0; round < bisections; ++round) {
    const double t = 0.5 * (good + bad);
    (stands((axis + t * (planned - axis)).normalized()) ? good : bad) = t;
  }
  return (axis + good * (planned - axis)).normalized();
}

}  // namespace

std::vector<Vec3> reference_axes(const AllowedSet& allowed, double window_mm, const TurnMeans* turns) {
  const std::span<const Station> stations = allowed.stations();
  const std::size_t n = stations.size();
  std::vector<Vec3> planned(n), sums(n + 1, Vec3::Zero()), axes(n);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) { planned[i] = allowed.planned_axis(static_cast<int>(i)); });
  for (std::size_t i = 0; i < n; ++i) {
    const double before = i > 0 ? stations[i].s_mm - stations[i - 1].s_mm : 0.0;
    const double behind = i + 1 < n ? stations[i + 1].s_mm - stations[i].s_mm : 0.0;
    sums[i + 1] = sums[i] + std::max(0.5 * (before + behind), 1e-6) * planned[i];
  }
  const std::vector<Window> window = windows(stations, window_mm);
  const Vec3 rest = allowed.chart().rest_axis_P();
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
    const Vec3 sum = sums[window[i].to] - sums[window[i].from];
    const double length = stations[window[i].to - 1].s_mm - stations[window[i].from].s_mm;
    const Vec3 mean = turns != nullptr ? turns->mean(stations[i].turn) : Vec3(sum / std::max(length, 1e-6));
    Vec3 axis = mean.norm() > 0.5 ? mean : mean + rest_share * rest;
    axis = axis.norm() > 1e-9 ? axis.normalized() : planned[i];
    axes[i] = moved_inside(allowed, static_cast<int>(i), allowed.within_tilt(static_cast<int>(i), axis), planned[i]);
  });
  return axes;
}

}  // namespace volute::planner
