// The way of one block: text -> BlockGeometry (points in axis space) -> CornerRounder (cells) -> SpeedProfile (speeds)
// -> CycleSampler (samples at the interpolation cycle, averaged and followed by the servos) -> RunStatistics.
#include "sim/controller/control_run.hpp"

#include <deque>

#include "geometry/check.hpp"
#include "sim/controller/block_geometry.hpp"
#include "sim/controller/cycle_sampler.hpp"
#include "sim/controller/linuxcnc/linuxcnc_run.hpp"
#include "sim/controller/path_cells.hpp"
#include "sim/controller/rapid_chain.hpp"
#include "sim/controller/run_loop.hpp"
#include "sim/controller/run_statistics.hpp"
#include "sim/controller/speed_profile.hpp"

namespace volute::sim {

namespace {

class ControlRun {
 public:
  ControlRun(const ControlSetup& setup, const SampleSink& sink)
      : start_(start_position(setup)),
        geometry_(*setup.machine, *setup.control, setup.setup, setup.tool_length_mm, start_),
        feed_limits_(motion_limits(*setup.machine, *setup.control, setup.control->corner_tolerance_mm)),
        rapid_limits_(motion_limits(*setup.machine, *setup.control, no_limit)),
        rounder_(feed_limits_, rapid_limits_, start_),
        rapids_(*setup.machine, *setup.control, geometry_, feed_limits_, rapid_limits_),
        look_ahead_blocks_(static_cast<std::size_t>(std::max(1, setup.control->look_ahead_blocks))),
        profile_(std::max(1, setup.control->look_ahead_blocks)),
        statistics_(*setup.machine, setup.control->servo_period_s,
                    setup.control->acceleration_profile == kinematics::AccelerationProfile::s_curve),
        sampler_(*setup.machine, *setup.control, start_, sink, statistics_) {}

  Result<void> add(const MotionBlock& block) {
    BlockInfo& info = blocks_.emplace_back();
    auto path = geometry_.path_of(block, info);
    if (!path) return tl::unexpected(path.error());
    take({*std::move(path), &info});
    return {};
  }

  RunReport finish() {
    end_chain();
    cells_.clear();
    rounder_.finish(cells_);
    plan();
    profile_.finish(ready_);
    play();
    for (const BlockInfo& block : blocks_) statistics_.end_block(block);
    sampler_.finish();
    return statistics_.report();
  }

 private:
  // Rapids are held back while their chain may still be planned from rest to rest, but no further than the control
  // looks ahead.
  void take(PlannedBlock planned) {
    const bool rapid = planned.path.rapid.has_value() && rapids_.plans();
    if (!rapid || planned.path.stop_before) end_chain();
    const bool begins = rapid && chain_.empty() && (at_rest_ || planned.path.stop_before);
    at_rest_ = planned.path.stop_after;
    if (!begins && chain_.empty()) return follow(planned);
    chain_.push_back(std::move(planned));
    if (chain_.size() <= look_ahead_blocks_) return;
    for (const PlannedBlock& block : chain_) follow(block);
    chain_.clear();
  }
  void end_chain() {
    if (chain_.empty()) return;
    std::vector<RestMove> moves = rapids_.moves(chain_);
    for (std::size_t k = 0; k < chain_.size(); ++k)
      if (moves.empty())
        follow(chain_[k]);
      else
        follow(chain_[k], moves_.emplace_back(std::move(moves[k])));
    chain_.clear();
  }
  void follow(const PlannedBlock& planned) {
    cells_.clear();
    append(planned, rounder_, cells_);
    plan();
  }
  void follow(const PlannedBlock& planned, const RestMove& move) {
    cells_.clear();
    if (planned.path.stop_before) rounder_.hold(0.0, planned.block, cells_);
    rounder_.move(move, planned.path.rapid->to_q, planned.block, cells_);
    plan();
  }
  void plan() {
    profile_.add_block(cells_, ready_);
    play();
  }
  void play() {
    for (const TimedCell& timed : ready_) {
      if (timed.cell.block) retire_before(*timed.cell.block);
      sampler_.add(timed);
      if (timed.cell.move) moves_.pop_front();
    }
    ready_.clear();
  }
  void retire_before(const BlockInfo& block) {
    while (&blocks_.front() != &block) {
      statistics_.end_block(blocks_.front());
      blocks_.pop_front();
    }
  }

  AxisVector start_;
  BlockGeometry geometry_;
  MotionLimits feed_limits_, rapid_limits_;
  CornerRounder rounder_;
  RapidPlanner rapids_;
  std::size_t look_ahead_blocks_;
  SpeedProfile profile_;
  RunStatistics statistics_;
  CycleSampler sampler_;
  std::deque<BlockInfo> blocks_;     ///< whose samples are not all out; never moved while they stay
  std::vector<PlannedBlock> chain_;  ///< rapids, from rest on
  std::deque<RestMove> moves_;       ///< not played yet, in order
  bool at_rest_ = true;              ///< where the next block begins
  std::vector<PathCell> cells_;
  std::vector<TimedCell> ready_;
};

}  // namespace

Result<RunReport> run_motions(const MotionSource& next, const ControlSetup& setup, const SampleSink& sink,
                              const std::function<void(std::int64_t line)>& progress) {
  VOLUTE_CHECK(setup.machine && setup.control);
  if (setup.control->linuxcnc_planner) return linuxcnc::run_motions(next, setup, sink, progress);
  return run_all(ControlRun(setup, sink), next, progress);
}

}  // namespace volute::sim
