// The fastest speed along the path that keeps every axis's acceleration, over as many blocks as the control looks
// ahead.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/controller/bend_limits.hpp"
#include "sim/controller/path_cells.hpp"
#include "sim/controller/ring.hpp"

namespace volute::sim {

/// A stretch of constant d2s/dt2 within one cell: s from `from` to `to`, ds/dt from `speed_from` to `speed_to`.
struct Phase {
  double from = 0.0, to = 0.0, speed_from = 0.0, speed_to = 0.0;
  Limit limit = Limit::programmed_feed;
  int axis = -1;
};

/// A cell with its speeds. At most three phases.
struct TimedCell {
  PathCell cell;
  std::array<Phase, 3> phases;
  int phase_count = 0;
};

/// Within a cell d2s/dt2 is constant (straight cells: three constant stretches), so the axes' acceleration curvature x
/// + rate u is linear in s (x = (ds/dt)^2, u = d2s/dt2) and its bounds at both ends of the cell hold inside it as well.
/// Backward over the window the greatest x from which the path can still be followed to rest at the window's end;
/// forward the greatest x that the cell before allows. Property 1: the axes' acceleration and velocity limits hold
/// everywhere, exactly. 2. x is the greatest of all profiles of this kind (one u a curved cell). 3. More look-ahead is
/// never slower. Source: reachability analysis of time-optimal path parameterization, two sweeps over x.
class SpeedProfile {
 public:
  /// A control that holds n blocks plans them together and lets a quarter of them go at a time, so that every block is
  /// timed with 3 n / 4 to n blocks known behind it. Requires: look_ahead_blocks >= 1.
  explicit SpeedProfile(int look_ahead_blocks) : look_ahead_blocks_(look_ahead_blocks) {}

  /// Adds the cells of one block and moves to `ready` what is now certain.
  void add_block(const std::vector<PathCell>& cells, std::vector<TimedCell>& ready);
  /// The path ends here: the rest is certain.
  void finish(std::vector<TimedCell>& ready);

 private:
  struct Node {
    PathCell cell;
    BendLimits bend;            ///< curved cells
    double start_sq_max = 0.0;  ///< of x at the cell's start: both neighbours' limits
    Limit start_limit = Limit::stop;
    int start_axis = -1;
    double sq = 0.0;  ///< greatest x at the cell's start from which the window's end can be reached
    Limit reason = Limit::look_ahead;
    int reason_axis = -1;
  };
  void append(const PathCell& cell);
  void sweep_back(std::size_t first_new);
  void release(std::vector<TimedCell>& ready);
  void time_straight(const PathCell& cell, double end_sq, Limit end_reason, int end_axis, TimedCell& timed);
  void time_bend(const Node& node, double end_sq, Limit end_reason, int end_axis, TimedCell& timed);
  void add_phase(TimedCell& timed, double from, double to, double from_sq, double to_sq, Limit limit, int axis) const;

  int look_ahead_blocks_;
  Ring<Node> window_;
  Ring<std::size_t> cells_of_block_;
  std::size_t new_cells_ = 0;  ///< at the window's end, not swept yet
  double last_sq_max_ = 0.0;   ///< of the cell before the next one to come
  Limit last_limit_ = Limit::stop;
  int last_axis_ = -1;
  double sq_now_ = 0.0;
  Limit leaving_ = Limit::stop;  ///< what held the speed down where we come from
  int leaving_axis_ = -1;
};

}  // namespace volute::sim
