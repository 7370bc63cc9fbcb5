#include "planner/orientation/corridor_smoother.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace volute::planner {

namespace {

constexpr double full_turn_rad = 2.0 * std::numbers::pi;
constexpr double grid_step_mm = 2.0;
constexpr int steps_least = 12;

constexpr double smoothing_length_mm = 12.0;
constexpr double free_width_rad = 0.5 * std::numbers::pi;  // of the bounds before they draw back
constexpr double least_width_rad = 1e-6;
constexpr double drawn_back_share = 0.9;
constexpr int share_bisections = 5;
// Turning away from the neighbouring pass by an angle weighs as much as turning by it over this length of path.
constexpr double alike_length_mm = 30.0;
constexpr double influence_step_rad = 1e-4;
// Holds a value to about a billionth of a radian against the forces of the smoothing.
constexpr double held_weight = 1e7;
// Each takes the spline nearer to the curve that it follows, by the square of the step once more.
constexpr int corrections_max = 4;

/// The cubic through four values at four places.
double cubic_at(std::span<const Station> stations, const std::vector<Rotaries>& at, std::size_t first, std::size_t k,
                double s_mm) {
  double sum = 0.0;
  for (std::size_t a = first; a < first + 4; ++a) {
    double share = at[a][k];
    for (std::size_t b = first; b < first + 4; ++b) {
      if (b != a) share *= (s_mm - stations[b].s_mm) / (stations[a].s_mm - stations[b].s_mm);
    }
    sum += share;
  }
  return sum;
}

void extend(std::vector<double>& c) {
  const std::size_t n = c.size();
  c[0] = 2.0 * c[1] - c[2];
  c[n - 1] = 2.0 * c[n - 2] - c[n - 3];
}

}  // namespace

CorridorSmoother::CorridorSmoother(const AllowedSet& allowed)
    : allowed_(allowed),
      check_(allowed),
      grid_(allowed.stations().back().s_mm, std::min(grid_step_mm, allowed.stations().back().s_mm / steps_least)) {
  for (const Station& station : allowed.stations()) weights_.push_back(grid_.at(station.s_mm));
  for (int j = 0; j < grid_.coefficients(); ++j) points_.push_back(nearest_station(grid_.place_mm(j)));
  beside_ = neighbouring_stations(allowed.stations(), points_, neighbour_reach_mm);
}

int CorridorSmoother::nearest_station(double s_mm) const {
  const auto stations = allowed_.stations();
  const auto after =
      std::lower_bound(stations.begin(), stations.end(), s_mm, [](const Station& a, double s) { return a.s_mm < s; });
  auto place = std::min(after - stations.begin(), std::ssize(stations) - 1);
  if (place > 0 &&
      s_mm - stations[static_cast<std::size_t>(place - 1)].s_mm < stations[static_cast<std::size_t>(place)].s_mm - s_mm)
    --place;
  return static_cast<int>(place);
}

Rotaries CorridorSmoother::station_of(const Coefficients& c, std::size_t i) const {
  Rotaries at{};
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t j = 0; j < 4; ++j)
      at[k] += weights_[i].weight[j] * c[k][static_cast<std::size_t>(weights_[i].first) + j];
  }
  return at;
}

std::vector<Rotaries> CorridorSmoother::stations_of(const Coefficients& c) const {
  std::vector<Rotaries> at(weights_.size());
  tbb::parallel_for(std::size_t{0}, at.size(), [&](std::size_t i) { at[i] = station_of(c, i); });
  return at;
}

/// Values at the places of the coefficients, and at both ends one more on the line through the last two.
Coefficients CorridorSmoother::sampled(const std::vector<Rotaries>& at) const {
  const auto stations = allowed_.stations();
  const auto count = static_cast<std::size_t>(grid_.coefficients());
  Coefficients c;
  for (std::size_t k = 0; k < 2; ++k) {
    c[k].resize(count);
    for (std::size_t j = 1; j + 1 < count; ++j) {
      const double s = grid_.place_mm(static_cast<int>(j));
      const auto after = std::lower_bound(stations.begin(), stations.end(), s,
                                          [](const Station& a, double value) { return a.s_mm < value; });
      const auto first = std::clamp<std::ptrdiff_t>(after - stations.begin() - 2, 0, std::ssize(stations) - 4);
      c[k][j] = stations.size() < 4 ? at[static_cast<std::size_t>(points_[j])][k]
                                    : cubic_at(stations, at, static_cast<std::size_t>(first), k, s);
    }
    extend(c[k]);
  }
  return c;
}

std::optional<Coefficients> CorridorSmoother::following(const std::vector<Rotaries>& at) {
  const Coefficients wanted = sampled(at);
  Coefficients c = wanted;
  for (int round = 0; round <= corrections_max; ++round) {
    const std::vector<char> bad = touching(c);
    if (std::find(bad.begin(), bad.end(), 1) == bad.end()) return c;
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<double> corrected = c[k];
      for (std::size_t j = 1; j + 1 < c[k].size(); ++j)
        corrected[j] += wanted[k][j] - grid_.value(c[k], grid_.place_mm(static_cast<int>(j)));
      extend(corrected);
      c[k] = std::move(corrected);
    }
  }
  return std::nullopt;
}

/// The rotaries that stand for an axis and lie nearest to `to`, a free rotary at `to`.
Rotaries CorridorSmoother::nearest_way(const Vec3& axis_P, const Rotaries& to, const Rotaries& influence) const {
  Rotaries best = to;
  double least = std::numeric_limits<double>::infinity();
  for (const RotaryChoice& choice : allowed_.chart().choices(axis_P)) {
    Rotaries way = choice.at;
    double distance_sq = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      way[k] = choice.free_axis == static_cast<int>(k)
                   ? to[k]
                   : way[k] + full_turn_rad * std::round((to[k] - way[k]) / full_turn_rad);
      distance_sq += influence[k] * influence[k] * (way[k] - to[k]) * (way[k] - to[k]);
    }
    if (distance_sq < least) least = distance_sq, best = way;
  }
  return best;
}

/// Draws every coefficient to where the neighbouring passes stand, by as much as its rotary turns the tool there.
std::array<Attraction, 2> CorridorSmoother::alike(const Coefficients& c) const {
  const std::size_t n = points_.size();
  std::array<Attraction, 2> pulls;
  for (Attraction& pull : pulls) pull.weight.assign(n, 0.0), pull.target.assign(n, 0.0);
  const double unit = grid_.step_mm() / (alike_length_mm * alike_length_mm);
  const RotaryChart& chart = allowed_.chart();
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t j) {
    const Rotaries here = {c[0][j], c[1][j]};
    Rotaries influence{};
    for (std::size_t k = 0; k < 2; ++k) {
      Rotaries less = here, more = here;
      less[k] -= influence_step_rad, more[k] += influence_step_rad;
      influence[k] = (chart.axis_P(more) - chart.axis_P(less)).norm() / (2.0 * influence_step_rad);
    }
    for (const int other : beside_[j]) {
      if (other < 0) continue;
      const Rotaries there = station_of(c, static_cast<std::size_t>(other));
      const Rotaries way = nearest_way(chart.axis_P(there), here, influence);
      for (std::size_t k = 0; k < 2; ++k) {
        pulls[k].weight[j] += unit * influence[k] * influence[k];
        pulls[k].target[j] += way[k];
      }
    }
    const int count = (beside_[j][0] >= 0 ? 1 : 0) + (beside_[j][1] >= 0 ? 1 : 0);
    for (std::size_t k = 0; k < 2 && count > 0; ++k) pulls[k].target[j] /= count;
  });
  return pulls;
}

/// How far from base towards wanted station i may go, by halving; 0 when not at all.
double CorridorSmoother::allowed_share(std::size_t i, const Rotaries& base, const Rotaries& wanted) const {
  double good = 0.0, bad = 1.0;
  for (int k = 0; k < share_bisections; ++k) {
    const double t = 0.5 * (good + bad);
    const Rotaries at = {base[0] + t * (wanted[0] - base[0]), base[1] + t * (wanted[1] - base[1])};
    (allowed_.blocked(static_cast<int>(i), at) == Blocked::no ? good : bad) = t;
  }
  return good;
}

void CorridorSmoother::draw_back(const std::vector<char>& bad, const Coefficients& base, const Coefficients& found,
                                 Coefficients& lower, Coefficients& upper) const {
  std::vector<double> station_share(bad.size(), 1.0), share(points_.size(), 1.0);
  tbb::parallel_for(std::size_t{0}, bad.size(), [&](std::size_t i) {
    if (bad[i] != 0) station_share[i] = drawn_back_share * allowed_share(i, station_of(base, i), station_of(found, i));
  });
  for (std::size_t i = 0; i < bad.size(); ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      double& s = share[static_cast<std::size_t>(weights_[i].first) + j];
      s = std::min(s, station_share[i]);
    }
  }
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t j = 0; j < share.size(); ++j) {
      if (share[j] >= 1.0) continue;
      const double to = base[k][j] + share[j] * (found[k][j] - base[k][j]);
      if (to >= base[k][j]) upper[k][j] = std::min(upper[k][j], std::max(to, base[k][j] + least_width_rad));
      if (to <= base[k][j]) lower[k][j] = std::max(lower[k][j], std::min(to, base[k][j] - least_width_rad));
    }
  }
}

std::vector<HeldValue> CorridorSmoother::held_values(const std::vector<HeldStation>& held, std::size_t k) const {
  std::vector<HeldValue> values;
  for (const HeldStation& one : held) {
    if (!one.rotary[k]) continue;
    const auto i = static_cast<std::size_t>(one.station);
    values.push_back({weights_[i].first, weights_[i].weight, one.value[k], held_weight});
  }
  return values;
}

std::optional<Coefficients> CorridorSmoother::smoothed(const Coefficients& base, const SmoothingAims& aims,
                                                       int tightenings_max) {
  Coefficients lower, upper, found = base;
  for (std::size_t k = 0; k < 2; ++k) {
    const bool endless = allowed_.chart().is_endless(static_cast<int>(k));
    const kinematics::Axis& axis = allowed_.chart().axis(static_cast<int>(k));
    for (const double c : base[k]) {
      lower[k].push_back(endless ? c - free_width_rad
                                 : std::min(std::max(c - free_width_rad, *axis.travel_min), c - least_width_rad));
      upper[k].push_back(endless ? c + free_width_rad
                                 : std::max(std::min(c + free_width_rad, *axis.travel_max), c + least_width_rad));
    }
  }
  const SmoothnessWeights weights{grid_.step_mm(), smoothing_length_mm};
  for (int round = 0; round < tightenings_max; ++round) {
    ++iterations_;
    std::array<Attraction, 2> pulls = alike(found);
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t k = 0; k < 2; ++k) {
      found[k] = smoothest_within(
          {lower[k], upper[k], base[k], weights, std::move(pulls[k]), held_values(aims.held, k), aims.peaks[k]});
    }
    solve_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::vector<char> bad = touching(found);
    if (std::find(bad.begin(), bad.end(), 1) == bad.end()) return found;
    draw_back(bad, base, found, lower, upper);
  }
  return std::nullopt;
}

}  // namespace volute::planner
