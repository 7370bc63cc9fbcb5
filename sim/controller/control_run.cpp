// The way of one block: text -> BlockGeometry (points in axis space) -> CornerRounder (cells) -> SpeedProfile (speeds)
// -> CycleSampler (samples at the interpolation cycle, averaged and followed by the servos) -> RunStatistics.
#include "sim/controller/control_run.hpp"

#include <deque>

#include "geometry/check.hpp"
#include "sim/controller/block_geometry.hpp"
#include "sim/controller/cycle_sampler.hpp"
#include "sim/controller/linuxcnc/linuxcnc_run.hpp"
#include "sim/controller/path_cells.hpp"
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
        profile_(std::max(1, setup.control->look_ahead_blocks)),
        statistics_(*setup.machine, setup.control->servo_period_s,
                    setup.control->acceleration_profile == kinematics::AccelerationProfile::s_curve),
        sampler_(*setup.machine, *setup.control, start_, sink, statistics_) {}

  Result<void> add(const MotionBlock& block) {
    BlockInfo& info = blocks_.emplace_back();
    const auto path = geometry_.path_of(block, info);
    if (!path) return tl::unexpected(path.error());
    cells_.clear();
    if (path->stop_before) rounder_.hold(path->dwell_s, &info, cells_);
    for (const PathPoint& point : path->points) rounder_.add(point, cells_);
    if (path->stop_after && !path->points.empty()) rounder_.hold(0.0, &info, cells_);
    plan();
    return {};
  }

  RunReport finish() {
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
  void plan() {
    profile_.add_block(cells_, ready_);
    play();
  }
  void play() {
    for (const TimedCell& timed : ready_) {
      if (timed.cell.block) retire_before(*timed.cell.block);
      sampler_.add(timed);
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
  SpeedProfile profile_;
  RunStatistics statistics_;
  CycleSampler sampler_;
  std::deque<BlockInfo> blocks_;  ///< whose samples are not all out; never moved while they stay
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
