// The polygon with its corners rounded: the path whose speed is planned.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "sim/controller/axis_limits.hpp"
#include "sim/controller/path_point.hpp"

namespace volute::sim {

class RestMove;

/// A stretch of path on which q is quadratic in s: q(s) = start + rate s + curvature s^2 / 2, 0 <= s <= length.
struct PathCell {
  double length = 0.0;
  AxisVector start = AxisVector::Zero(), rate = AxisVector::Zero(), curvature = AxisVector::Zero();
  bool straight = true;            ///< curvature is zero
  bool corner = false;             ///< rounds a corner of the program, not a bend that a block makes by itself
  double speed_sq_max = no_limit;  ///< of ds/dt, from feed, velocity and tolerance limits
  Limit limit = Limit::programmed_feed;
  int limit_axis = -1;
  double acceleration_max = 0.0;  ///< straight cells: of d2s/dt2
  int acceleration_axis = -1;
  double tip_rate = 0.0;  ///< tip length per s
  bool hold = false;      ///< not a motion: the axes come to rest, the filter empties, and `dwell_s` passes
  double dwell_s = 0.0;
  const RestMove* move = nullptr;  ///< of a hold: before it the axes make this move, instead of the rest
  const MotionLimits* limits = nullptr;
  TipRates tip_rates = TipRates::Zero();
  BlockInfo* block = nullptr;
};

/// Rounds each corner by a parabola with equal lengths l on both sides: from the polygon it strays l |turn| / 4, where
/// turn is the change of dq/ds. l is half of the shorter neighbour or what the corner's tolerance allows.
/// Property 1: q is continuous with dq/ds everywhere but at holds. 2. The path leaves the corner by at most its
/// tolerances (first order in the rotation within the corner). 3. The filter's lag stays within the lag tolerances at
/// the planned speed.
class CornerRounder {
 public:
  /// The limits must outlive the cells, which point to them.
  CornerRounder(const MotionLimits& feed, const MotionLimits& rapid, const AxisVector& start)
      : feed_(feed), rapid_(rapid), at_(start) {}

  /// Appends the cells that `point` completes.
  void add(const PathPoint& point, std::vector<PathCell>& cells);
  /// Completes the path so far and lets the axes rest.
  void hold(double dwell_s, BlockInfo* block, std::vector<PathCell>& cells);
  /// The axes rest, and make a move of their own to `end`, where they rest again.
  void move(const RestMove& move, const AxisVector& end, BlockInfo* block, std::vector<PathCell>& cells);
  /// Completes the path so far; the axes rest at its end.
  void finish(std::vector<PathCell>& cells);

 private:
  struct Piece {
    PathPoint end;
    AxisVector start, rate;
    double used = 0.0;  ///< of its length, by the corner before it
  };
  void corner(Piece& in, Piece& out, std::vector<PathCell>& cells) const;
  void round(const Piece& in, const Piece& out, double reach, bool sharp, std::vector<PathCell>& cells) const;
  void straight(const Piece& piece, double from, double to, std::vector<PathCell>& cells) const;
  [[nodiscard]] PathCell cell_of(const Piece& piece) const;
  void limit_bend(PathCell& cell, const PathPoint& at) const;
  const MotionLimits& limits_of(const PathPoint& point) const { return point.block->feed_average ? feed_ : rapid_; }

  const MotionLimits &feed_, &rapid_;
  AxisVector at_;
  std::optional<Piece> pending_;
};

}  // namespace volute::sim
