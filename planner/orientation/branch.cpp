#include "planner/orientation/branch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace volute::planner {

namespace {

constexpr double full_turn_rad = 2.0 * std::numbers::pi;
constexpr double least_step_mm = 1e-3;

struct State {
  std::array<double, 2> value{};
  std::array<bool, 2> known{};    ///< of this axis itself
  std::array<bool, 2> carried{};  ///< known here or anywhere before
  double cost = 0.0;
  int before = -1;
};

double nearest_turn(double value, double to) {
  return value + full_turn_rad * std::round((to - value) / full_turn_rad);
}

/// Every way to stand for the axis, endless rotaries in their first turn.
std::vector<State> candidates(const RotaryChart& chart, const PlacedAxis& axis) {
  std::vector<State> states;
  for (const RotaryChoice& choice : chart.choices(axis.axis_P)) {
    const int free_axis = axis.pin_free_axis ? -1 : choice.free_axis;
    const std::vector<double> first = free_axis == 0 ? std::vector<double>{0.0} : chart.turns(0, choice.at[0]);
    const std::vector<double> second = free_axis == 1 ? std::vector<double>{0.0} : chart.turns(1, choice.at[1]);
    for (const double a : first) {
      for (const double b : second)
        states.push_back({{a, b}, {free_axis != 0, free_axis != 1}, {free_axis != 0, free_axis != 1}, 0.0, -1});
    }
  }
  return states;
}

/// `to` as it stands after `from`: endless rotaries in the near turn, free ones where they were; with the cost of the
/// way.
State after(const RotaryChart& chart, const State& from, State to, double step_mm) {
  to.cost = from.cost;
  for (std::size_t k = 0; k < 2; ++k) {
    if (!from.carried[k]) continue;
    if (!to.known[k]) {
      to.value[k] = from.value[k];
      to.carried[k] = true;
      continue;
    }
    if (chart.is_endless(static_cast<int>(k))) to.value[k] = nearest_turn(to.value[k], from.value[k]);
    const double change = to.value[k] - from.value[k];
    to.cost += change * change / std::max(step_mm, least_step_mm);
  }
  return to;
}

}  // namespace

BranchChoice choose_branches(const RotaryChart& chart, std::span<const PlacedAxis> axes) {
  BranchChoice result;
  std::vector<std::vector<State>> rows;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    std::vector<State> row = candidates(chart, axes[i]);
    if (row.empty()) {
      result.unreachable = static_cast<int>(i);
      return result;
    }
    for (State& state : row) {
      if (i == 0 && chart.before()) {
        const State before{chart.before()->at, {true, true}, {true, true}, 0.0, -1};
        state = after(chart, before, state, chart.before()->way_mm);
        continue;
      }
      if (i == 0) {
        // Of equal ways the one nearest to the zero pose starts.
        state.cost = 1e-9 * (state.value[0] * state.value[0] + state.value[1] * state.value[1]);
        continue;
      }
      State best;
      best.cost = std::numeric_limits<double>::infinity();
      for (std::size_t b = 0; b < rows[i - 1].size(); ++b) {
        State way = after(chart, rows[i - 1][b], state, axes[i].s_mm - axes[i - 1].s_mm);
        way.before = static_cast<int>(b);
        if (way.cost < best.cost) best = way;
      }
      state = best;
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return result;
  const auto last = std::min_element(rows.back().begin(), rows.back().end(),
                                     [](const State& a, const State& b) { return a.cost < b.cost; });
  auto place = static_cast<int>(last - rows.back().begin());
  result.at.resize(axes.size());
  for (std::size_t i = axes.size(); i-- > 0;) {
    const State& state = rows[i][static_cast<std::size_t>(place)];
    for (std::size_t k = 0; k < 2; ++k) {
      if (state.known[k]) result.at[i][k] = state.value[k];
      if (i > 0 && state.known[k]) {
        const State& before = rows[i - 1][static_cast<std::size_t>(state.before)];
        if (before.carried[k])
          result.jump_max_rad = std::max(result.jump_max_rad, std::abs(state.value[k] - before.value[k]));
      }
    }
    place = state.before;
  }
  return result;
}

std::vector<Rotaries> filled(const BranchChoice& choice, std::span<const PlacedAxis> axes) {
  std::vector<Rotaries> full(choice.at.size());
  for (std::size_t k = 0; k < 2; ++k) {
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < full.size(); ++i) {
      if (!choice.at[i][k]) continue;
      full[i][k] = *choice.at[i][k];
      const std::size_t from = last ? *last : 0;
      for (std::size_t j = last ? from + 1 : 0; j < i; ++j) {
        const double length = axes[i].s_mm - axes[from].s_mm;
        const double t = last && length > 0.0 ? (axes[j].s_mm - axes[from].s_mm) / length : 1.0;
        full[j][k] = last ? full[from][k] + t * (full[i][k] - full[from][k]) : full[i][k];
      }
      last = i;
    }
    if (last) {
      for (std::size_t j = *last + 1; j < full.size(); ++j) full[j][k] = full[*last][k];
    }
  }
  return full;
}

}  // namespace volute::planner
