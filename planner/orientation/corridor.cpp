#include "planner/orientation/corridor.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <tbb/parallel_for.h>

#include "planner/orientation/bounded_smooth.hpp"
#include "planner/orientation/lattice.hpp"
#include "planner/orientation/pin_loop.hpp"

namespace volute::planner {

using geometry::Angle;

namespace {

constexpr double layer_step_mm = 2.0;
constexpr int layers_least = 12;
constexpr Angle lattice_step = Angle::degrees(7.5);
constexpr int refinements = 2;
constexpr int chain_rounds_max = 200;
// Layers opened to both sides of one that touches: the way round an obstacle begins before it.
constexpr int open_beside = 6;
// After so many rounds a node that does not hold is given up with those beside it.
constexpr int narrow_rounds = 4;

constexpr int recentrings = 3;
constexpr int tightenings_max = 60;
constexpr double smoothing_length_mm = 12.0;
constexpr double free_width_rad = 0.5 * std::numbers::pi;  // of the bounds before they draw back
constexpr double least_width_rad = 1e-6;
constexpr double drawn_back_share = 0.9;
constexpr int share_bisections = 5;

using Coefficients = std::array<std::vector<double>, 2>;

class Corridor {
 public:
  Corridor(const AllowedSet& allowed, const std::vector<Vec3>& preferred)
      : allowed_(allowed),
        check_(allowed),
        preferred_(preferred),
        grid_(allowed.stations().back().s_mm, std::min(layer_step_mm, allowed.stations().back().s_mm / layers_least)) {
    for (const Station& station : allowed.stations()) weights_.push_back(grid_.at(station.s_mm));
    for (int j = 0; j < grid_.coefficients(); ++j) points_.push_back(nearest_station(grid_.place_mm(j)));
  }

  CorridorResult run();

 private:
  [[nodiscard]] int nearest_station(double s_mm) const;
  [[nodiscard]] std::vector<Rotaries> stations_of(const Coefficients& c) const;
  [[nodiscard]] Rotaries station_of(const Coefficients& c, std::size_t i) const;
  bool find_chain(Angle step);
  void widen(const std::vector<char>& bad, const LatticeChain::Chain& chain, int round, LatticeChain& lattice) const;
  void smooth();
  bool tighten_until_allowed(const Coefficients& base, Coefficients& lower, Coefficients& upper, Coefficients& found);
  [[nodiscard]] double allowed_share(std::size_t i, const Rotaries& base, const Rotaries& wanted) const;
  void draw_back(const std::vector<char>& bad, const Coefficients& base, const Coefficients& found, Coefficients& lower,
                 Coefficients& upper) const;

  const AllowedSet& allowed_;
  PathCheck check_;
  const std::vector<Vec3>& preferred_;
  SplineGrid grid_;
  std::vector<SplineGrid::Weights> weights_;
  std::vector<int> points_;
  Coefficients coefficients_;
  CorridorResult result_;
};

int Corridor::nearest_station(double s_mm) const {
  const auto stations = allowed_.stations();
  const auto after =
      std::lower_bound(stations.begin(), stations.end(), s_mm, [](const Station& a, double s) { return a.s_mm < s; });
  auto place = std::min(after - stations.begin(), std::ssize(stations) - 1);
  if (place > 0 &&
      s_mm - stations[static_cast<std::size_t>(place - 1)].s_mm < stations[static_cast<std::size_t>(place)].s_mm - s_mm)
    --place;
  return static_cast<int>(place);
}

Rotaries Corridor::station_of(const Coefficients& c, std::size_t i) const {
  Rotaries at{};
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t j = 0; j < 4; ++j)
      at[k] += weights_[i].weight[j] * c[k][static_cast<std::size_t>(weights_[i].first) + j];
  }
  return at;
}

std::vector<Rotaries> Corridor::stations_of(const Coefficients& c) const {
  std::vector<Rotaries> at(weights_.size());
  tbb::parallel_for(std::size_t{0}, at.size(), [&](std::size_t i) { at[i] = station_of(c, i); });
  return at;
}

/// Opens the layers round what touches; where they are open already, the nodes that the chain used there are given up.
void Corridor::widen(const std::vector<char>& bad, const LatticeChain::Chain& chain, int round,
                     LatticeChain& lattice) const {
  std::vector<char> wanted(points_.size(), 0), used(points_.size(), 0);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    if (bad[i] == 0) continue;
    const int first = weights_[i].first;
    for (int j = std::max(first - open_beside, 0);
         j <= std::min(first + 3 + open_beside, static_cast<int>(points_.size()) - 1); ++j) {
      if (!lattice.is_open(j)) wanted[static_cast<std::size_t>(j)] = 1;
    }
    for (int j = first; j < first + 4; ++j) {
      if (lattice.is_open(j)) used[static_cast<std::size_t>(j)] = 1;
    }
  }
  std::vector<int> opened;
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    if (wanted[j] != 0) opened.push_back(static_cast<int>(j));
    if (used[j] != 0) lattice.forbid(static_cast<int>(j), chain.nodes[j], round >= narrow_rounds);
  }
  lattice.open(opened);
}

bool Corridor::find_chain(Angle step) {
  const RotaryLattice lattice(allowed_.chart(), step);
  LatticeChain layers(allowed_, lattice, points_, preferred_);
  for (int round = 0; round < chain_rounds_max; ++round) {
    ++result_.iterations;
    const LatticeChain::Chain chain = layers.cheapest();
    if (chain.stuck >= 0) {
      const int point = points_[static_cast<std::size_t>(chain.stuck)];
      result_.stuck = {point};
      return false;
    }
    const std::vector<Rotaries> nodes = layers.unwrapped(chain);
    for (std::size_t k = 0; k < 2; ++k) {
      coefficients_[k].clear();
      for (const Rotaries& node : nodes) coefficients_[k].push_back(node[k]);
    }
    const std::vector<char> bad = check_.touching(stations_of(coefficients_));
    if (std::find(bad.begin(), bad.end(), 1) == bad.end()) {
      result_.layers = static_cast<int>(points_.size());
      for (int j = 0; j < result_.layers; ++j) result_.layers_opened += layers.is_open(j) ? 1 : 0;
      result_.stuck.clear();
      return true;
    }
    widen(bad, chain, round, layers);
  }
  return false;
}

/// How far from base towards wanted station i may go, by halving; 0 when not at all.
double Corridor::allowed_share(std::size_t i, const Rotaries& base, const Rotaries& wanted) const {
  double good = 0.0, bad = 1.0;
  for (int k = 0; k < share_bisections; ++k) {
    const double t = 0.5 * (good + bad);
    const Rotaries at = {base[0] + t * (wanted[0] - base[0]), base[1] + t * (wanted[1] - base[1])};
    (allowed_.blocked(static_cast<int>(i), at) == Blocked::no ? good : bad) = t;
  }
  return good;
}

void Corridor::draw_back(const std::vector<char>& bad, const Coefficients& base, const Coefficients& found,
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

bool Corridor::tighten_until_allowed(const Coefficients& base, Coefficients& lower, Coefficients& upper,
                                     Coefficients& found) {
  const SmoothnessWeights weights{grid_.step_mm(), smoothing_length_mm, 0.0};
  for (int round = 0; round < tightenings_max; ++round) {
    ++result_.iterations;
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t k = 0; k < 2; ++k) found[k] = smoothest_within(lower[k], upper[k], base[k], {}, weights);
    result_.solve_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::vector<char> bad = check_.touching(stations_of(found));
    if (std::find(bad.begin(), bad.end(), 1) == bad.end()) return true;
    draw_back(bad, base, found, lower, upper);
  }
  return false;
}

void Corridor::smooth() {
  for (int round = 0; round < recentrings; ++round) {
    const Coefficients base = coefficients_;
    Coefficients lower, upper, found;
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
    // The curve before stays when the bounds did not settle: it is allowed.
    if (tighten_until_allowed(base, lower, upper, found)) coefficients_ = found;
  }
}

CorridorResult Corridor::run() {
  Angle step = lattice_step;
  bool found = find_chain(step);
  for (int k = 0; !found && k < refinements; ++k) {
    if (!result_.stuck.empty() &&
        !allowed_.nearest(result_.stuck.front(), preferred_[static_cast<std::size_t>(result_.stuck.front())],
                          Angle())) {
      result_.stuck_empty = true;
      return result_;
    }
    step = 0.5 * step;
    found = find_chain(step);
  }
  if (!found) return result_;
  smooth();
  result_.at = stations_of(coefficients_);
  return result_;
}

}  // namespace

CorridorResult run_corridor(const AllowedSet& allowed, const std::vector<Vec3>& preferred) {
  return Corridor(allowed, preferred).run();
}

}  // namespace volute::planner
