#include "planner/orientation/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <tbb/parallel_for.h>

namespace volute::planner {

using geometry::Angle;

namespace {

constexpr double full_turn_rad = 2.0 * std::numbers::pi;
constexpr Angle reach_a_layer = Angle::degrees(15.0);
// Per mm and rad^2: a lean of 0.3 rad away from the preferred axis over 100 mm weighs as much as turning by 0.3 rad
// within 100 mm.
constexpr double preference = 1e-4;
// Per mm: some millimetres at the edge of what is free outweigh one step of the lattice.
constexpr double edge_cost_per_mm = 1e-2;

int steps_for(double step_rad) {
  return static_cast<int>(std::max(1.0, std::ceil(reach_a_layer.radians() / step_rad - 1e-9)));
}

}  // namespace

RotaryLattice::RotaryLattice(const RotaryChart& chart, Angle step) {
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(k);
    cyclic_[i] = chart.is_endless(k);
    const double least = cyclic_[i] ? 0.0 : *chart.axis(k).travel_min;
    const double most = cyclic_[i] ? full_turn_rad : *chart.axis(k).travel_max;
    const int cells = std::max(4, static_cast<int>(std::ceil((most - least) / step.radians())));
    counts_[i] = cyclic_[i] ? cells : cells + 1;
    first_[i] = least;
    steps_[i] = (most - least) / cells;
  }
  for (int node = 0; node < nodes(); ++node) axes_.push_back(chart.axis_P(at(node)));
}

Rotaries RotaryLattice::at(int node) const {
  return {first_[0] + steps_[0] * (node / counts_[1]), first_[1] + steps_[1] * (node % counts_[1])};
}

int RotaryLattice::neighbour(int node, int da, int dc) const {
  std::array<int, 2> place = {node / counts_[1] + da, node % counts_[1] + dc};
  for (std::size_t k = 0; k < 2; ++k) {
    if (cyclic_[k]) place[k] = (place[k] + counts_[k]) % counts_[k];
    if (place[k] < 0 || place[k] >= counts_[k]) return -1;
  }
  return place[0] * counts_[1] + place[1];
}

LatticeChain::LatticeChain(const AllowedSet& allowed, const RotaryLattice& lattice, std::vector<int> layer_points,
                           const std::vector<Vec3>& preferred)
    : allowed_(allowed),
      lattice_(lattice),
      points_(std::move(layer_points)),
      preferred_(preferred),
      nodes_(points_.size()),
      at_edge_(points_.size()),
      open_(points_.size(), 0) {
  const int most_a = steps_for(lattice.step_rad(0)), most_c = steps_for(lattice.step_rad(1));
  for (int da = -most_a; da <= most_a; ++da) {
    for (int dc = -most_c; dc <= most_c; ++dc) {
      const double a = da * lattice.step_rad(0), c = dc * lattice.step_rad(1);
      steps_.push_back({a * a + c * c, {}});
      for (int node = 0; node < lattice.nodes(); ++node) steps_.back().from.push_back(lattice.neighbour(node, da, dc));
    }
  }
  tbb::parallel_for(std::size_t{0}, points_.size(), [&](std::size_t layer) {
    for (int node = 0; node < lattice_.nodes(); ++node) {
      if (allowed_.is_well_within_limits(points_[layer], lattice_.axis_P(node))) nodes_[layer].push_back(node);
    }
    if (!nodes_[layer].empty()) return;
    for (int node = 0; node < lattice_.nodes(); ++node) {
      if (allowed_.process_limit(points_[layer], lattice_.axis_P(node)) == Blocked::no) nodes_[layer].push_back(node);
    }
  });
}

void LatticeChain::open(const std::vector<int>& layers) {
  tbb::parallel_for(std::size_t{0}, layers.size(), [&](std::size_t k) {
    const auto layer = static_cast<std::size_t>(layers[k]);
    if (open_[layer] != 0) return;
    open_[layer] = 1;
    const std::vector<int> before = nodes_[layer];
    std::erase_if(nodes_[layer],
                  [&](int node) { return allowed_.blocked(points_[layer], lattice_.at(node)) != Blocked::no; });
    mark_edges(layer, before);
  });
}

void LatticeChain::mark_edges(std::size_t layer, const std::vector<int>& before) {
  std::vector<char> free(static_cast<std::size_t>(lattice_.nodes()), 1);
  for (const int node : before) free[static_cast<std::size_t>(node)] = 0;
  for (const int node : nodes_[layer]) free[static_cast<std::size_t>(node)] = 1;
  at_edge_[layer].clear();
  for (const int node : nodes_[layer]) {
    char edge = 0;
    for (int da = -1; da <= 1; ++da) {
      for (int dc = -1; dc <= 1; ++dc) {
        const int beside = lattice_.neighbour(node, da, dc);
        if (beside >= 0 && free[static_cast<std::size_t>(beside)] == 0) edge = 1;
      }
    }
    at_edge_[layer].push_back(edge);
  }
}

void LatticeChain::forbid(int layer, int node, bool with_neighbours) {
  const auto l = static_cast<std::size_t>(layer);
  std::vector<int> given_up = {node};
  if (with_neighbours) {
    for (const auto& [da, dc] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      given_up.push_back(lattice_.neighbour(node, da, dc));
    }
  }
  std::vector<int> nodes;
  std::vector<char> edges;
  for (std::size_t n = 0; n < nodes_[l].size(); ++n) {
    if (std::find(given_up.begin(), given_up.end(), nodes_[l][n]) != given_up.end()) continue;
    nodes.push_back(nodes_[l][n]);
    if (open_[l] != 0) edges.push_back(at_edge_[l][n]);
  }
  nodes_[l] = std::move(nodes);
  at_edge_[l] = std::move(edges);
}

LatticeChain::Chain LatticeChain::cheapest() const {
  const double none = std::numeric_limits<double>::infinity();
  std::vector<std::vector<int>> before(points_.size());
  std::vector<double> cost(static_cast<std::size_t>(lattice_.nodes()), none), next(cost);
  const auto station = [&](std::size_t layer) -> const Station& {
    return allowed_.stations()[static_cast<std::size_t>(points_[layer])];
  };
  Chain chain;
  for (std::size_t layer = 0; layer < points_.size(); ++layer) {
    std::fill(next.begin(), next.end(), none);
    before[layer].assign(nodes_[layer].size(), -1);
    const double length = layer == 0 ? 1.0 : std::max(station(layer).s_mm - station(layer - 1).s_mm, 0.1);
    bool any = false;
    for (std::size_t n = 0; n < nodes_[layer].size(); ++n) {
      const int node = nodes_[layer][n];
      double least = layer == 0 ? 0.0 : none;
      for (std::size_t k = 0; layer > 0 && k < steps_.size(); ++k) {
        const int from = steps_[k].from[static_cast<std::size_t>(node)];
        if (from < 0) continue;
        const double way = cost[static_cast<std::size_t>(from)] + steps_[k].motion_sq / length;
        if (way < least) least = way, before[layer][n] = from;
      }
      if (least == none) continue;
      if (!at_edge_[layer].empty() && at_edge_[layer][n] != 0) least += edge_cost_per_mm * length;
      any = true;
      next[static_cast<std::size_t>(node)] =
          least + preference * length *
                      (lattice_.axis_P(node) - preferred_[static_cast<std::size_t>(points_[layer])]).squaredNorm();
    }
    if (!any) {
      chain.stuck = static_cast<int>(layer);
      return chain;
    }
    cost.swap(next);
  }
  auto node = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  chain.nodes.resize(points_.size());
  for (std::size_t layer = points_.size(); layer-- > 0;) {
    chain.nodes[layer] = node;
    const auto place = std::lower_bound(nodes_[layer].begin(), nodes_[layer].end(), node) - nodes_[layer].begin();
    node = before[layer][static_cast<std::size_t>(place)];
  }
  return chain;
}

std::vector<Rotaries> LatticeChain::unwrapped(const Chain& chain) const {
  std::vector<Rotaries> at;
  for (const int node : chain.nodes) {
    Rotaries here = lattice_.at(node);
    for (std::size_t k = 0; k < 2 && !at.empty(); ++k) {
      if (lattice_.is_cyclic(static_cast<int>(k)))
        here[k] += full_turn_rad * std::round((at.back()[k] - here[k]) / full_turn_rad);
    }
    at.push_back(here);
  }
  return at;
}

}  // namespace volute::planner
