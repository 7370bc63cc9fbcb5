#include "sim/controller/speed_profile.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::sim {

namespace {

/// Why the axes accelerate or brake at their limit: on the way to or from `reason`.
Limit while_changing(Limit reason, const PathCell& cell, int axis) {
  if (reason == Limit::corner || reason == Limit::block_time || reason == Limit::look_ahead) return reason;
  if (axis >= 0 && cell.limits->jerk_bound[static_cast<std::size_t>(axis)]) return Limit::axis_jerk;
  return Limit::axis_acceleration;
}

}  // namespace

void SpeedProfile::append(const PathCell& cell) {
  Node& node = window_.put();
  node.cell = cell;
  const bool before = last_sq_max_ <= cell.speed_sq_max;
  node.start_sq_max = before ? last_sq_max_ : cell.speed_sq_max;
  node.start_limit = before ? last_limit_ : cell.limit;
  node.start_axis = before ? last_axis_ : cell.limit_axis;
  last_sq_max_ = cell.speed_sq_max;
  last_limit_ = cell.limit;
  last_axis_ = cell.limit_axis;
  if (!cell.hold && !cell.straight) node.bend = BendLimits(cell);
}

void SpeedProfile::add_block(const std::vector<PathCell>& cells, std::vector<TimedCell>& ready) {
  for (const PathCell& cell : cells) append(cell);
  cells_of_block_.put() = cells.size();
  new_cells_ += cells.size();
  if (cells_of_block_.size() <= static_cast<std::size_t>(look_ahead_blocks_)) return;
  sweep_back(window_.size() - new_cells_);
  new_cells_ = 0;
  for (int left = std::max(1, look_ahead_blocks_ / 4); left > 0; --left) release(ready);
}

void SpeedProfile::finish(std::vector<TimedCell>& ready) {
  sweep_back(window_.size() - new_cells_);
  new_cells_ = 0;
  while (!cells_of_block_.empty()) release(ready);
  last_sq_max_ = 0.0;
  last_limit_ = Limit::stop;
}

// Older cells stay as they are from where the answer no longer changes.
void SpeedProfile::sweep_back(std::size_t first_new) {
  double end_sq = 0.0;
  Limit reason = Limit::look_ahead;
  int reason_axis = -1;
  for (std::size_t i = window_.size(); i-- > 0;) {
    Node& node = window_[i];
    const PathCell& cell = node.cell;
    BendLimits::Answer answer{node.start_sq_max, -1};
    bool own = true;  // the start's own limit decides, not the way to rest
    if (cell.hold) {
      answer.sq = 0.0;
      node.reason = Limit::stop;
      node.reason_axis = -1;
    } else if (cell.straight) {
      const double reach = end_sq + 2.0 * cell.length * cell.acceleration_max;
      own = reach >= node.start_sq_max;
      if (!own) answer.sq = reach;
    } else {
      answer = node.bend.greatest_start(end_sq, node.start_sq_max);
      own = answer.axis < 0;
      if (!own && end_sq > answer.sq) {  // not the end but the bend itself is what holds the start down
        reason = cell.corner ? Limit::corner : Limit::axis_acceleration;
        reason_axis = answer.axis;
      }
    }
    if (!cell.hold) {
      node.reason = reason = own ? node.start_limit : reason;
      node.reason_axis = reason_axis = own ? node.start_axis : reason_axis;
    } else {
      reason = node.reason;
      reason_axis = node.reason_axis;
    }
    const bool unchanged = i < first_new && answer.sq == node.sq;
    node.sq = end_sq = answer.sq;
    if (unchanged) return;
  }
}

void SpeedProfile::release(std::vector<TimedCell>& ready) {
  for (std::size_t left = cells_of_block_.front(); left > 0; --left) {
    Node& node = window_.front();
    const bool last = window_.size() == 1;
    const double end_sq = last ? 0.0 : window_[1].sq;
    const Limit reason = last ? Limit::stop : window_[1].reason;
    const int reason_axis = last ? -1 : window_[1].reason_axis;
    TimedCell& timed = ready.emplace_back();
    timed.cell = node.cell;
    if (node.cell.hold)
      sq_now_ = 0.0, leaving_ = Limit::stop, leaving_axis_ = -1;
    else if (node.cell.straight)
      time_straight(node.cell, end_sq, reason, reason_axis, timed);
    else
      time_bend(node, end_sq, reason, reason_axis, timed);
    window_.drop_front();
  }
  cells_of_block_.drop_front();
}

void SpeedProfile::add_phase(TimedCell& timed, double from, double to, double from_sq, double to_sq, Limit limit,
                             int axis) const {
  if (to - from <= 1e-15 * timed.cell.length) return;
  VOLUTE_CHECK(from_sq + to_sq > 0.0, from, to, timed.cell.length, timed.cell.speed_sq_max);
  timed.phases[static_cast<std::size_t>(timed.phase_count++)] = {from,  to,  std::sqrt(from_sq), std::sqrt(to_sq),
                                                                 limit, axis};
}

void SpeedProfile::time_straight(const PathCell& cell, double end_sq, Limit end_reason, int end_axis,
                                 TimedCell& timed) {
  const double a2 = 2.0 * cell.acceleration_max;
  const double reachable = std::min(end_sq, sq_now_ + a2 * cell.length);
  const double peak = std::min(cell.speed_sq_max, 0.5 * (sq_now_ + reachable + a2 * cell.length));
  const double top = std::max({peak, sq_now_, reachable});
  const double rise = std::min(cell.length, (top - sq_now_) / a2),
               fall = std::min(cell.length - rise, (top - reachable) / a2);
  const int axis = cell.acceleration_axis;
  add_phase(timed, 0.0, rise, sq_now_, top, while_changing(leaving_, cell, axis), axis);
  if (cell.length - rise - fall > 1e-12 * cell.length) {
    const bool own = top >= cell.speed_sq_max;
    leaving_ = own ? cell.limit : end_reason;
    leaving_axis_ = own ? cell.limit_axis : end_axis;
    add_phase(timed, rise, cell.length - fall, top, top, leaving_, leaving_axis_);
  }
  if (fall > 0.0 || reachable >= end_sq) leaving_ = end_reason, leaving_axis_ = end_axis;
  add_phase(timed, cell.length - fall, cell.length, top, reachable, while_changing(end_reason, cell, axis), axis);
  sq_now_ = reachable;
}

void SpeedProfile::time_bend(const Node& node, double end_sq, Limit end_reason, int end_axis, TimedCell& timed) {
  const PathCell& cell = node.cell;
  const BendLimits::Answer answer = node.bend.greatest_end(sq_now_, end_sq);
  Limit limit = end_reason;
  int axis = end_axis;
  if (answer.axis >= 0) {  // speeding up as the axes allow
    limit = cell.corner ? Limit::corner : while_changing(leaving_, cell, answer.axis);
    axis = answer.axis;
  } else {
    if (answer.sq < sq_now_ * (1.0 - 1e-9)) limit = while_changing(end_reason, cell, end_axis);
    leaving_ = end_reason;
    leaving_axis_ = end_axis;
  }
  add_phase(timed, 0.0, cell.length, sq_now_, answer.sq, limit, axis);
  sq_now_ = answer.sq;
}

}  // namespace volute::sim
