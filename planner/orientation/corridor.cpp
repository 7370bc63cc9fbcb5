#include "planner/orientation/corridor.hpp"

#include <algorithm>
#include <cmath>

#include "planner/orientation/corridor_smoother.hpp"
#include "planner/orientation/exhaustive.hpp"
#include "planner/orientation/lattice.hpp"
#include "planner/orientation/motion.hpp"

namespace volute::planner {

using geometry::Angle;

namespace {

/// Of the lattice: in the rotaries, and in layers every so many coefficients of the spline. Wide layers spread a turn
/// over a long way, since a step costs the same wherever it is made; narrow ones get through narrow places.
struct Resolution {
  Angle step;
  int stride;
};
constexpr std::array<Resolution, 4> resolutions = {
    Resolution{Angle::degrees(7.5), 4}, Resolution{Angle::degrees(7.5), 1}, Resolution{Angle::degrees(3.75), 1},
    Resolution{Angle::degrees(1.875), 1}};
constexpr int chain_rounds_max = 100;
// Coefficients whose layers are opened to both sides of one that touches: the way round an obstacle begins before it.
constexpr int open_beside = 12;
// After so many rounds a node that does not hold is given up with those beside it.
constexpr int narrow_rounds = 4;

constexpr int recentrings = 2, tightenings_max = 40;
constexpr int lowerings_max = 8, lowering_tightenings_max = 12;
// Another round is made while some peak still falls by this share.
constexpr double worthwhile_share = 0.05;
// Peaks are limited to this share of what they were: what the solver may miss must not show.
constexpr double limit_share = 1.0 - 1e-5;
constexpr double peak_price = 0.25;
constexpr double same_share = 1e-9, same_rad = 1e-9;
constexpr double held_rad = 1e-6;
// A rotary whose acceleration stays below this, rad/mm^2, is straight up to rounding: there is nothing to lower.
constexpr double straight_rad_mm2 = 1e-9;

bool any(const std::vector<char>& marks) { return std::find(marks.begin(), marks.end(), 1) != marks.end(); }

class Corridor {
 public:
  Corridor(const AllowedSet& allowed, const std::vector<Vec3>& preferred)
      : allowed_(allowed), preferred_(preferred), smoother_(allowed) {}

  CorridorResult run();

 private:
  bool find_chain(const Resolution& resolution);
  void widen(const std::vector<char>& bad, const LatticeChain::Chain& chain, const Resolution& resolution, int round,
             LatticeChain& lattice) const;
  [[nodiscard]] Coefficients coefficients_of(const std::vector<Rotaries>& nodes, int stride) const;

  const AllowedSet& allowed_;
  const std::vector<Vec3>& preferred_;
  CorridorSmoother smoother_;
  Coefficients coefficients_;
  CorridorResult result_;
};

/// Opens the layers round what touches; where they are open already, the nodes that the chain used there are given up.
void Corridor::widen(const std::vector<char>& bad, const LatticeChain::Chain& chain, const Resolution& resolution,
                     int round, LatticeChain& lattice) const {
  const int layers = static_cast<int>(chain.nodes.size());
  const int beside = std::max(1, open_beside / resolution.stride);
  std::vector<char> wanted(chain.nodes.size(), 0), used(wanted);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    if (bad[i] == 0) continue;
    const int first = smoother_.weights()[i].first / resolution.stride;
    const int last =
        std::min((smoother_.weights()[i].first + 3 + resolution.stride - 1) / resolution.stride, layers - 1);
    for (int j = std::max(first - beside, 0); j <= std::min(last + beside, layers - 1); ++j) {
      if (!lattice.is_open(j)) wanted[static_cast<std::size_t>(j)] = 1;
    }
    for (int j = first; j <= last; ++j) {
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

/// Every stride-th coefficient is a node of the chain, those between lie on lines.
Coefficients Corridor::coefficients_of(const std::vector<Rotaries>& nodes, int stride) const {
  Coefficients c;
  for (std::size_t k = 0; k < 2; ++k) {
    for (int j = 0; j < smoother_.grid().coefficients(); ++j) {
      const auto before = static_cast<std::size_t>(j / stride), after = std::min(before + 1, nodes.size() - 1);
      const double t = static_cast<double>(j % stride) / stride;
      c[k].push_back((1.0 - t) * nodes[before][k] + t * nodes[after][k]);
    }
  }
  return c;
}

bool Corridor::find_chain(const Resolution& resolution) {
  const RotaryLattice lattice(allowed_.chart(), resolution.step);
  std::vector<int> points;
  const int last = smoother_.grid().coefficients() - 1;
  for (int j = 0; j < last + resolution.stride; j += resolution.stride)
    points.push_back(smoother_.points()[static_cast<std::size_t>(std::min(j, last))]);
  LatticeChain layers(allowed_, lattice, points, preferred_);
  for (int round = 0; round < chain_rounds_max; ++round) {
    ++result_.iterations;
    const LatticeChain::Chain chain = layers.cheapest();
    if (chain.stuck >= 0) {
      result_.stuck = points[static_cast<std::size_t>(chain.stuck)];
      return false;
    }
    coefficients_ = coefficients_of(layers.unwrapped(chain), resolution.stride);
    const std::vector<char> bad = smoother_.touching(coefficients_);
    if (!any(bad)) {
      result_.layers = static_cast<int>(points.size());
      for (int j = 0; j < result_.layers; ++j) result_.layers_opened += layers.is_open(j) ? 1 : 0;
      result_.stuck = -1;
      return true;
    }
    widen(bad, chain, resolution, round, layers);
  }
  return false;
}

CorridorResult Corridor::run() {
  bool found = false;
  for (std::size_t k = 0; !found && k < resolutions.size(); ++k) {
    if (k == 1) result_.empty = stations_without_orientation(allowed_, preferred_);
    if (!result_.empty.empty()) return result_;
    found = find_chain(resolutions[k]);
  }
  if (!found) return result_;
  for (int round = 0; round < recentrings; ++round) {
    // The curve before stays when the bounds did not settle: it is allowed.
    auto smoother = smoother_.smoothed(coefficients_, {}, tightenings_max);
    if (smoother) coefficients_ = std::move(*smoother);
  }
  result_.iterations += smoother_.iterations();
  result_.solve_s = smoother_.solve_s();
  result_.at = smoother_.stations_of(coefficients_);
  return result_;
}

bool is_straight(const AxisMotionPeaks& peaks) { return peaks.acceleration_max < straight_rad_mm2; }

std::array<std::optional<PeakLimits>, 2> limits_of(const RotaryPeaks& peaks) {
  std::array<std::optional<PeakLimits>, 2> limits;
  for (std::size_t k = 0; k < 2; ++k) {
    limits[k] = PeakLimits{
        {limit_share * peaks[k].velocity_max, limit_share * peaks[k].acceleration_max, limit_share * peaks[k].jerk_max},
        peak_price};
  }
  return limits;
}

std::array<double, 6> six(const RotaryPeaks& peaks) {
  return {peaks[0].velocity_max, peaks[0].acceleration_max, peaks[0].jerk_max,
          peaks[1].velocity_max, peaks[1].acceleration_max, peaks[1].jerk_max};
}

bool falls_on(const RotaryPeaks& before, const RotaryPeaks& after) {
  const std::array<double, 6> a = six(before), b = six(after);
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (b[k] < (1.0 - worthwhile_share) * a[k]) return true;
  }
  return false;
}

bool holds(const std::vector<Rotaries>& at, const std::vector<HeldStation>& held) {
  return std::all_of(held.begin(), held.end(), [&](const HeldStation& one) {
    const Rotaries& here = at[static_cast<std::size_t>(one.station)];
    return (!one.rotary[0] || std::abs(here[0] - one.value[0]) < held_rad) &&
           (!one.rotary[1] || std::abs(here[1] - one.value[1]) < held_rad);
  });
}

}  // namespace

std::optional<std::vector<Rotaries>> standing_still(const AllowedSet& allowed, const std::vector<Rotaries>& at) {
  const auto stations = allowed.stations();
  Rotaries mean{};
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double share = 0.5 * (stations[i + 1].s_mm - stations[i].s_mm) / stations.back().s_mm;
    for (std::size_t k = 0; k < 2; ++k) mean[k] += share * (at[i][k] + at[i + 1][k]);
  }
  std::vector<Rotaries> still(at.size(), mean);
  if (any(check_path(allowed, still, true)) || any(check_path(allowed, still, false))) return std::nullopt;
  return still;
}

RotaryPeaks peaks_per_mm(const AllowedSet& allowed, const std::vector<Rotaries>& at) {
  std::vector<double> s, values;
  for (const Station& station : allowed.stations()) s.push_back(station.s_mm);
  RotaryPeaks peaks;
  for (std::size_t k = 0; k < 2; ++k) {
    values.clear();
    for (const Rotaries& r : at) values.push_back(r[k]);
    peaks[k] = motion_peaks(s, values, 1.0);
  }
  return peaks;
}

bool no_peak_above(const RotaryPeaks& a, const RotaryPeaks& b) {
  const std::array<double, 6> x = six(a), y = six(b);
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (x[k] > y[k] * (1.0 + same_share) + same_rad) return false;
  }
  return true;
}

CorridorResult lower_peaks(const AllowedSet& allowed, const std::vector<Rotaries>& at,
                           const std::vector<HeldStation>& held) {
  CorridorResult result;
  result.at = at;
  if (auto still = held.empty() ? standing_still(allowed, at) : std::nullopt) {
    result.at = std::move(*still);
    return result;
  }
  const RotaryPeaks limits = peaks_per_mm(allowed, at);
  if (is_straight(limits[0]) || is_straight(limits[1])) return result;
  CorridorSmoother smoother(allowed);
  std::optional<Coefficients> curve = smoother.following(at);
  RotaryPeaks before = limits;
  for (int round = 0; curve && round < lowerings_max; ++round) {
    curve = smoother.smoothed(*curve, {limits_of(limits), held}, lowering_tightenings_max);
    if (!curve) break;
    std::vector<Rotaries> lowered = smoother.stations_of(*curve);
    const RotaryPeaks peaks = peaks_per_mm(allowed, lowered);
    if (!no_peak_above(peaks, limits) || !holds(lowered, held)) break;
    result.at = std::move(lowered);
    if (!falls_on(before, peaks)) break;
    before = peaks;
  }
  result.iterations = smoother.iterations();
  result.solve_s = smoother.solve_s();
  return result;
}

CorridorResult run_corridor(const AllowedSet& allowed, const std::vector<Vec3>& preferred) {
  return Corridor(allowed, preferred).run();
}

}  // namespace volute::planner
