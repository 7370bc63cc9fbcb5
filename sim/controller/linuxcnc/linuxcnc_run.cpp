#include "sim/controller/linuxcnc/linuxcnc_run.hpp"

#include <cmath>
#include <deque>
#include <numbers>

#include "sim/controller/block_geometry.hpp"
#include "sim/controller/linuxcnc/planner.hpp"
#include "sim/controller/run_loop.hpp"
#include "sim/controller/run_statistics.hpp"
#include "sim/controller/sample_writer.hpp"

namespace volute::sim::linuxcnc {

namespace {

constexpr int axes = kinematics::axis_count;

AxisBounds bounds_of(const kinematics::Machine& machine) {
  AxisBounds bounds;
  for (std::size_t i = 0; i < bounds.velocity.size(); ++i) {
    const double unit = machine.axes[i].kind == kinematics::AxisKind::rotary ? deg_per_rad : 1.0;
    bounds.velocity[i] = machine.axes[i].velocity_max * unit;
    bounds.acceleration[i] = machine.axes[i].acceleration_max * unit;
  }
  return bounds;
}

PlannerLimits limits_of(const kinematics::Machine& machine, const kinematics::Control& control) {
  PlannerLimits limits;
  for (int i = 0; i < 3; ++i) {
    limits.velocity[i] = machine.axes[static_cast<std::size_t>(i)].velocity_max;
    limits.acceleration[i] = machine.axes[static_cast<std::size_t>(i)].acceleration_max;
  }
  limits.cycle_s = control.servo_period_s;
  limits.look_ahead = control.look_ahead_blocks;
  return limits;
}

struct Cause {
  Limit limit = Limit::axis_acceleration;
  int axis = -1;
};

/// What holds a segment at its speed.
Cause cause_of(const Segment& segment, double cycle_s) {
  constexpr double near = 1.0 - 1e-9;
  if (segment.rapid) return {Limit::rapid, -1};
  if (segment.speed >= segment.speed_requested * near) return {Limit::programmed_feed, -1};
  if (segment.speed >= segment.length / (1.021 * cycle_s) * near) return {Limit::block_time, -1};
  if (segment.shape == Shape::blend) return {Limit::corner, -1};
  int axis = -1;
  if (!segment.rotary.none) segment.rotary.direction.cwiseAbs().maxCoeff(&axis), axis += 3;
  if (segment.speed >= segment.speed_max * near) return {Limit::axis_velocity, axis};
  if (segment.overlapping || segment.parabolic_before || segment.end == EndMode::parabolic)
    return {Limit::corner, axis};
  return {Limit::axis_acceleration, axis};
}

class Run {
 public:
  Run(const ControlSetup& setup, const SampleSink& sink)
      : control_(*setup.control),
        start_(start_position(setup)),
        geometry_(*setup.machine, *setup.control, setup.setup, setup.tool_length_mm, start_),
        planner_(limits_of(*setup.machine, *setup.control), {}),
        canon_(bounds_of(*setup.machine), {}),
        machine_(*setup.machine),
        statistics_(*setup.machine, setup.control->servo_period_s, false),
        writer_(*setup.machine, *setup.control, start_, sink, statistics_) {
    stand_in_frame(false);
    older_[0] = older_[1] = older_[2] = start_;
    writer_.push(start_, {});
  }

  Result<void> add(const MotionBlock& block) {
    BlockInfo& info = blocks_.emplace_back();
    info.line = block.line;
    info.ordinal = count_++;
    if (block.kind == MotionKind::dwell || block.kind == MotionKind::stop) {
      rest();
      dwell(block, info);
      return {};
    }
    const bool tip = block.tcp && !block.machine_coordinates;
    if (tip != tip_frame_) {
      rest();
      stand_in_frame(tip);
    }
    const auto target = geometry_.target_of(block);
    if (!target) return tl::unexpected(target.error());
    describe(block, *target, info);
    const Position end = tip ? Position{target->tip_P_mm, target->q.tail<2>() * deg_per_rad}
                             : Position{target->q.head<3>(), target->q.tail<2>() * deg_per_rad};
    Vec3 centre = block.centre_mm;
    if (!tip && !block.machine_coordinates) centre += geometry_.zero_of(block).head<3>();
    if (auto done = geometry_.go_to(block, *target); !done) return done;
    canon_.add(block, end, centre, &info, [this](const Move& move) { queue(move); });
    return {};
  }

  RunReport finish() {
    rest();
    for (const BlockInfo& block : blocks_) statistics_.end_block(block);
    writer_.finish();
    return statistics_.report();
  }

 private:
  void queue(const Move& move) {
    while (planner_.full()) cycle();
    planner_.add(move);
  }

  /// Lengths and times that the report compares with.
  void describe(const MotionBlock& block, const BlockGeometry::Target& target, BlockInfo& info) {
    info.rapid = block.kind == MotionKind::rapid;
    info.cutting = !info.rapid && block.spindle_on;
    const bool tip = block.tcp && !block.machine_coordinates;
    const Vec3 tip_end = tip ? target.tip_P_mm : geometry_.solver().state(target.q).tip_P_mm;
    info.tip_length_mm = (tip_end - geometry_.tip()).norm();
    double measure = tip ? info.tip_length_mm : (target.q - geometry_.position()).head<3>().norm();
    if (block.kind == MotionKind::arc) {
      const Vec3 offset = tip ? Vec3(Vec3::Zero()) : Vec3(geometry_.zero_of(block).head<3>());
      const Vec3 from = tip ? geometry_.tip() : Vec3(geometry_.position().head<3>() - offset);
      const Vec3 to = tip ? target.tip_P_mm : Vec3(target.q.head<3>() - offset);
      const double rise = (to - from).dot(block.plane_normal);
      Vec3 spoke = from - block.centre_mm;
      spoke -= spoke.dot(block.plane_normal) * block.plane_normal;
      info.tip_length_mm = measure = std::hypot(spoke.norm() * block.sweep_rad, rise);
    }
    if (block.rotary_only || measure < 1e-9) measure = (target.q - geometry_.position()).tail<2>().norm();
    double speed = block.feed;
    if (block.feed_mode == FeedMode::per_revolution) speed *= block.spindle_rad_s / (2.0 * std::numbers::pi);
    if (block.feed_mode == FeedMode::inverse_time) speed *= measure;
    if (!info.rapid && speed > 0.0) info.programmed_time_s = measure / speed;
  }

  void stand_in_frame(bool tip) {
    tip_frame_ = tip;
    Position at;
    at.xyz = tip ? geometry_.tip() : Vec3(geometry_.position().head<3>());
    at.rotary_deg = geometry_.position().tail<2>() * deg_per_rad;
    planner_.stand_at(at);
    canon_.stand_at(at);
  }

  /// Where the planner's position puts the axes.
  AxisVector axes_now() {
    const Position& now = planner_.position();
    AxisVector q;
    q << now.xyz, now.rotary_deg / deg_per_rad;
    if (!tip_frame_) return q;
    q.head<3>() = older_[2].head<3>();
    return geometry_.solver().with_tip(now.xyz, q).value_or(older_[2]);
  }

  void cycle() {
    const Planner::Step step = planner_.cycle();
    const Segment& segment = *step.segment;
    BlockInfo& block = *segment.block;
    const Cause cause = cause_of(segment, control_.servo_period_s);
    statistics_.add_time(block, cause.limit, cause.axis, control_.servo_period_s);
    SampleMark mark{block.line, step.speed, cause.limit, cause.axis, block.rapid, block.cutting};
    if (segment.only_rotary()) mark.tip_speed_mm_s = 0.0;
    interpolate(axes_now(), mark);
    retire_before(planner_.idle() ? block.ordinal : planner_.oldest().block->ordinal);
  }

  void interpolate(const AxisVector& planned, const SampleMark& mark) {
    writer_.push((older_[0] + 4.0 * older_[1] + older_[2]) / 6.0, mark);
    older_[0] = older_[1];
    older_[1] = older_[2];
    older_[2] = planned;
  }

  /// The queue runs empty and the joints come to rest.
  void rest() {
    canon_.flush([this](const Move& move) { queue(move); });
    if (planner_.idle() && older_[0] == older_[2]) return;
    while (!planner_.idle()) cycle();
    const SampleMark mark{blocks_.empty() ? 0 : blocks_.front().line, 0.0, Limit::stop, -1, false, false};
    for (int i = 0; i < 3; ++i) interpolate(older_[2], mark);
    statistics_.add_stop(3.0 * control_.servo_period_s);
  }

  void dwell(const MotionBlock& block, const BlockInfo& info) {
    if (block.kind != MotionKind::dwell) return;
    const auto cycles = static_cast<std::int64_t>(std::llround(block.dwell_s / control_.servo_period_s));
    const SampleMark mark{info.line, 0.0, Limit::dwell, -1, false, false};
    for (std::int64_t i = 0; i < cycles; ++i) interpolate(older_[2], mark);
    statistics_.add_dwell(static_cast<double>(cycles) * control_.servo_period_s);
  }

  void retire_before(std::int64_t ordinal) {
    while (blocks_.front().ordinal < ordinal) {
      statistics_.end_block(blocks_.front());
      blocks_.pop_front();
    }
  }

  const kinematics::Control& control_;
  AxisVector start_;
  BlockGeometry geometry_;
  Planner planner_;
  Canon canon_;
  const kinematics::Machine& machine_;
  RunStatistics statistics_;
  SampleWriter writer_;
  std::deque<BlockInfo> blocks_;
  std::int64_t count_ = 0;
  bool tip_frame_ = false;
  AxisVector older_[3];  ///< the last planned positions of the axes, newest last
};

}  // namespace

Result<RunReport> run_motions(const MotionSource& next, const ControlSetup& setup, const SampleSink& sink,
                              const std::function<void(std::int64_t line)>& progress) {
  return run_all(Run(setup, sink), next, progress);
}

}  // namespace volute::sim::linuxcnc
