// A chain of allowed orientations along the whole path: the cheapest way through a lattice of both rotaries.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "planner/orientation/allowed_set.hpp"

namespace volute::planner {

/// The grid of both rotaries: within travel, or round the turn where there is no end.
class RotaryLattice {
 public:
  RotaryLattice(const RotaryChart& chart, geometry::Angle step);
  [[nodiscard]] int nodes() const { return counts_[0] * counts_[1]; }
  [[nodiscard]] Rotaries at(int node) const;
  [[nodiscard]] const Vec3& axis_P(int node) const { return axes_[static_cast<std::size_t>(node)]; }
  /// The node da and dc steps on, or -1 past the travel.
  [[nodiscard]] int neighbour(int node, int da, int dc) const;
  [[nodiscard]] double step_rad(int k) const { return steps_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] bool is_cyclic(int k) const { return cyclic_[static_cast<std::size_t>(k)]; }

 private:
  std::array<int, 2> counts_{};
  std::array<double, 2> first_{}, steps_{};
  std::array<bool, 2> cyclic_{};
  std::vector<Vec3> axes_;
};

/// Layers of the lattice at given points of the path, and what is known of their nodes.
/// Process limits are looked at from the start; interference only in layers that are asked for (open()), since it costs
/// a thousand times more.
class LatticeChain {
 public:
  /// `layer_points`: path point of each layer. `preferred`: axis a point would like. Arguments outlive it.
  LatticeChain(const AllowedSet& allowed, const RotaryLattice& lattice, std::vector<int> layer_points,
               const std::vector<Vec3>& preferred);

  /// Looks at interference of every node of the layers.
  void open(const std::vector<int>& layers);
  [[nodiscard]] bool is_open(int layer) const { return open_[static_cast<std::size_t>(layer)] != 0; }
  /// This node of this layer is not used again; `with_neighbours`: nor the four beside it.
  void forbid(int layer, int node, bool with_neighbours);
  [[nodiscard]] const std::vector<int>& allowed_nodes(int layer) const {
    return nodes_[static_cast<std::size_t>(layer)];
  }

  /// One node a layer: least sum of (change)^2 / (arc length) + preference * (angle to the preferred axis)^2 * (arc
  /// length), by dynamic programming; steps of at most 15 degrees a layer. `stuck`: the first layer that cannot be
  /// reached, -1 when there is a chain.
  struct Chain {
    std::vector<int> nodes;
    int stuck = -1;
  };
  [[nodiscard]] Chain cheapest() const;
  /// The chain's rotaries, unwrapped.
  [[nodiscard]] std::vector<Rotaries> unwrapped(const Chain& chain) const;

 private:
  const AllowedSet& allowed_;
  const RotaryLattice& lattice_;
  std::vector<int> points_;
  const std::vector<Vec3>& preferred_;
  std::vector<std::vector<int>> nodes_;
  std::vector<std::vector<char>> at_edge_;  ///< of open layers: a neighbour of the node touches
  void mark_edges(std::size_t layer, const std::vector<int>& before);
  std::vector<char> open_;
  struct Step {
    double motion_sq;
    std::vector<int> from;
  };  ///< from[node]: where a step ends that comes from there, or -1
  std::vector<Step> steps_;
};

}  // namespace volute::planner
