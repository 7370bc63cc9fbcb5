#include "planner/orientation/pin_loop.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include <tbb/parallel_for.h>

#include "planner/orientation/branch.hpp"
#include "planner/orientation/smooth_curve.hpp"

namespace volute::planner {

using geometry::Angle;

namespace {

constexpr Angle pin_margin = Angle::degrees(2.0);

// Rotaries this near stand for the same pose: a millionth of a millimetre at the end of the assembly.
constexpr double same_rad = 1e-8;

bool stands_with_motion(const AllowedSet& allowed, const std::vector<Rotaries>& at, int i) {
  const auto k = static_cast<std::size_t>(i);
  if (allowed.blocked(i, at[k]) != Blocked::no) return false;
  if (k + 1 == at.size() || allowed.limit(i + 1, at[k + 1]) != Blocked::no) return true;
  return allowed.motion_is_free(i, at[k], at[k + 1]);
}

struct PinState {
  Vec3 axis_P = Vec3::UnitZ();
  bool fixed = false;
  bool hold_free_axis = false;  ///< at the pole: the free rotary is pinned too, since leaving it free did not hold
  int escalations = 0;
};

class PinLoop {
 public:
  PinLoop(const AllowedSet& allowed, const std::vector<Vec3>& reference, const std::vector<char>& reference_blocked,
          const OrientationOptions& options)
      : allowed_(allowed),
        reference_(reference),
        reference_blocked_(reference_blocked),
        options_(options),
        check_(allowed) {
    for (const Station& station : allowed.stations()) s_.push_back(station.s_mm);
  }

  void pin(int index) {
    const auto i = static_cast<std::size_t>(index);
    if (pins_.count(index) != 0) return;
    PinState state;
    state.axis_P = reference_[i];
    if (reference_blocked_[i] != 0) {
      if (const auto axis = allowed_.nearest(index, reference_[i], pin_margin)) state.axis_P = *axis;
    }
    pins_[index] = state;
  }
  void pin_fixed(const FixedPin& pin) { pins_[pin.index] = {pin.axis_P, true, false, 0}; }

  PinLoopResult run();

 private:
  [[nodiscard]] std::vector<PlacedAxis> placed() const;
  [[nodiscard]] std::vector<double> solve_axis(const BranchChoice& choice, std::size_t k, double& solve_s) const;
  void add_pins(const std::vector<char>& bad);
  void escalate(int index);

  const AllowedSet& allowed_;
  const std::vector<Vec3>& reference_;
  const std::vector<char>& reference_blocked_;
  const OrientationOptions& options_;
  PathCheck check_;
  std::vector<double> s_;
  std::map<int, PinState> pins_;
};

std::vector<PlacedAxis> PinLoop::placed() const {
  std::vector<PlacedAxis> axes;
  for (const auto& [index, state] : pins_)
    axes.push_back({state.axis_P, s_[static_cast<std::size_t>(index)], state.hold_free_axis});
  return axes;
}

std::vector<double> PinLoop::solve_axis(const BranchChoice& choice, std::size_t k, double& solve_s) const {
  std::vector<Pin> pins;
  std::size_t place = 0;
  for (const auto& [index, state] : pins_) {
    if (choice.at[place][k]) pins.push_back({index, *choice.at[place][k]});
    ++place;
  }
  // Free everywhere, at the pole: it stays where the piece before left it.
  const auto& before = allowed_.chart().before();
  if (pins.empty()) return std::vector<double>(s_.size(), before ? before->at[k] : 0.0);
  const auto start = std::chrono::steady_clock::now();
  std::vector<double> phi = options_.smoothing == Smoothing::velocity ? least_velocity(s_, pins, options_.weights)
                                                                      : least_acceleration(s_, pins, options_.weights);
  solve_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return phi;
}

/// A pin that does not hold: first its free axis is held too, then it moves further from what it touches.
void PinLoop::escalate(int index) {
  PinState& state = pins_[index];
  if (state.fixed) return;
  state.hold_free_axis = true;
  ++state.escalations;
  if (const auto axis = allowed_.nearest(index, state.axis_P, state.escalations * pin_margin)) state.axis_P = *axis;
}

/// One new pin in the middle of each run that touches; in a run full of pins they move.
void PinLoop::add_pins(const std::vector<char>& bad) {
  for (const BlockedArea& area : blocked_areas(bad)) {
    const int middle = (area.first + area.last) / 2;
    int best = -1;
    for (int i = area.first; i <= area.last; ++i) {
      if (pins_.count(i) == 0 && (best < 0 || std::abs(i - middle) < std::abs(best - middle))) best = i;
    }
    if (best >= 0) {
      pin(best);
    } else {
      for (int i = area.first; i <= area.last; ++i) escalate(i);
      if (area.last + 1 < static_cast<int>(bad.size())) pin(area.last + 1);
    }
  }
}

PinLoopResult PinLoop::run() {
  PinLoopResult result;
  result.at.resize(s_.size());
  while (result.iterations < options_.iterations_max) {
    ++result.iterations;
    const BranchChoice choice = choose_branches(allowed_.chart(), placed());
    if (choice.unreachable >= 0) break;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<double> phi = solve_axis(choice, k, result.solve_s);
      for (std::size_t i = 0; i < phi.size(); ++i) result.at[i][k] = phi[i];
    }
    const std::vector<char> bad = check_.touching(result.at);
    result.free = std::find(bad.begin(), bad.end(), 1) == bad.end();
    if (result.free) break;
    add_pins(bad);
  }
  for (const auto& [index, state] : pins_) result.pins.push_back(index);
  return result;
}

}  // namespace

std::vector<char> check_path(const AllowedSet& allowed, const std::vector<Rotaries>& at, bool limits_only) {
  const int n = static_cast<int>(at.size());
  std::vector<char> bad(at.size(), 0);
  tbb::parallel_for(0, n, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const bool stands = limits_only ? allowed.limit(i, at[k]) == Blocked::no : stands_with_motion(allowed, at, i);
    bad[k] = stands ? 0 : 1;
  });
  return bad;
}

std::vector<char> PathCheck::touching(const std::vector<Rotaries>& at) {
  std::vector<char> bad = check_path(allowed_, at, true);
  if (std::find(bad.begin(), bad.end(), 1) != bad.end()) return bad;
  const int n = static_cast<int>(at.size());
  const auto same = [&](std::size_t i) {
    return std::abs(at[i][0] - last_[i][0]) + std::abs(at[i][1] - last_[i][1]) < same_rad;
  };
  tbb::parallel_for(0, n, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const bool known = !last_.empty() && same(k) && (i + 1 == n || same(k + 1));
    bad[k] = known ? last_bad_[k] : (stands_with_motion(allowed_, at, i) ? 0 : 1);
  });
  last_ = at;
  last_bad_ = bad;
  return bad;
}

std::vector<BlockedArea> blocked_areas(const std::vector<char>& blocked) {
  std::vector<BlockedArea> areas;
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    if (blocked[i] == 0) continue;
    if (i == 0 || blocked[i - 1] == 0) areas.push_back({static_cast<int>(i), static_cast<int>(i)});
    areas.back().last = static_cast<int>(i);
  }
  return areas;
}

std::vector<int> critical_points(int points, const std::vector<BlockedArea>& areas) {
  std::vector<int> critical = {0, points - 1};
  for (const BlockedArea& area : areas) {
    critical.push_back(std::max(area.first - 1, 0));
    critical.push_back((area.first + area.last) / 2);
    critical.push_back(std::min(area.last + 1, points - 1));
  }
  std::sort(critical.begin(), critical.end());
  critical.erase(std::unique(critical.begin(), critical.end()), critical.end());
  return critical;
}

PinLoopResult run_pin_loop(const AllowedSet& allowed, const std::vector<Vec3>& reference,
                           const std::vector<char>& reference_blocked, const std::vector<int>& critical,
                           const std::vector<FixedPin>& fixed, const OrientationOptions& options) {
  PinLoop loop(allowed, reference, reference_blocked, options);
  for (const int index : critical) loop.pin(index);
  for (const FixedPin& pin : fixed) loop.pin_fixed(pin);
  return loop.run();
}

}  // namespace volute::planner
