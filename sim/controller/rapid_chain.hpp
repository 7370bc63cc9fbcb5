// Rapids one after another: held back until the last is known, then planned from rest to rest or as one averaged path,
// whichever is quicker.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "sim/controller/block_geometry.hpp"
#include "sim/controller/path_cells.hpp"
#include "sim/controller/rest_move.hpp"

namespace volute::sim {

/// A block and its path, as the rounder takes it.
struct PlannedBlock {
  BlockPath path;
  BlockInfo* block = nullptr;
};

/// Gives the block to the rounder, with the stops before and after it.
void append(const PlannedBlock& planned, CornerRounder& rounder, std::vector<PathCell>& cells);

/// Chooses for rapids that begin and end at rest. Where jerk is limited by the plan and not by a filter of the control
/// file, each may be a RestMove, with the whole acceleration of every axis and a tip that stays on its line.
class RapidPlanner {
 public:
  /// All of them must outlive the planner.
  RapidPlanner(const kinematics::Machine& machine, const kinematics::Control& control, const BlockGeometry& geometry,
               const MotionLimits& feed, const MotionLimits& rapid)
      : machine_(machine), control_(control), geometry_(geometry), feed_(feed), rapid_(rapid) {}

  /// Whether this control plans such rapids at all.
  [[nodiscard]] bool plans() const;
  /// One move a block, in order. Empty: the averaged path over all of them is no slower, or a block has no smooth
  /// curve. Requires: every block a `rapid`, all with the same average; the axes rest before the first.
  [[nodiscard]] std::vector<RestMove> moves(std::span<const PlannedBlock> blocks) const;
  /// How long the samples of a move last.
  [[nodiscard]] static double sampled_time_s(const RestMove& move, double period_s);

 private:
  [[nodiscard]] std::optional<AxisCurve> curve(const RapidLine& line) const;
  [[nodiscard]] std::optional<RestMove> move(const RapidLine& line) const;
  [[nodiscard]] double averaged_time_s(std::span<const PlannedBlock> blocks) const;

  const kinematics::Machine& machine_;
  const kinematics::Control& control_;
  const BlockGeometry& geometry_;
  const MotionLimits &feed_, &rapid_;
};

}  // namespace volute::sim
