// LinuxCNC 2.9's trajectory planner: a queue of segments and one step a servo cycle.
#pragma once

#include <cstdint>
#include <deque>

#include "sim/controller/linuxcnc/canon.hpp"

namespace volute::sim::linuxcnc {

/// Trapezoidal speeds, no limit on jerk. Blocks with rotary motion only ever overlap with their neighbours, each at
/// half its acceleration; blocks of X Y Z alone are joined by tangents and arcs and planned over the last 50 of the
/// queue. Written from the measured and documented behaviour of version 2.9; held against it in tests.
class Planner {
 public:
  Planner(const PlannerLimits& limits, const Position& start) : limits_(limits), goal_(start), now_(start) {}

  static constexpr std::size_t queue_full = 1780;
  [[nodiscard]] bool full() const { return queue_.size() >= queue_full; }
  [[nodiscard]] bool idle() const { return queue_.empty(); }
  /// Requires: !idle().
  [[nodiscard]] const Segment& oldest() const { return queue_.front(); }
  void add(const Move& move);

  struct Step {
    const Segment* segment = nullptr;  ///< the one that moves faster
    double speed = 0.0;
  };
  /// One servo cycle. Requires: !idle(). The step's segment is valid until the next call.
  Step cycle();
  [[nodiscard]] const Position& position() const { return now_; }
  void stand_at(const Position& position) { goal_ = now_ = position; }

 private:
  void plan_ahead();
  void plan_pair(Segment& before, Segment& after) const;
  void activate(Segment& segment) const;
  void advance(Segment& segment, const Segment* next);
  void check_end(Segment& segment, const Segment* next) const;
  Step split_cycle(Segment& segment, Segment* next);
  Step regular_cycle(Segment& segment, Segment* next);

  PlannerLimits limits_;
  std::deque<Segment> queue_;
  Segment finished_;
  Position goal_, now_;
};

}  // namespace volute::sim::linuxcnc
