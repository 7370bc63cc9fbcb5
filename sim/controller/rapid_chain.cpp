#include "sim/controller/rapid_chain.hpp"

#include <algorithm>
#include <cmath>

#include "sim/controller/speed_profile.hpp"

namespace volute::sim {

void append(const PlannedBlock& planned, CornerRounder& rounder, std::vector<PathCell>& cells) {
  const BlockPath& path = planned.path;
  if (path.stop_before) rounder.hold(path.dwell_s, planned.block, cells);
  for (const PathPoint& point : path.points) rounder.add(point, cells);
  if (path.stop_after && !path.points.empty()) rounder.hold(0.0, planned.block, cells);
}

bool RapidPlanner::plans() const {
  return control_.acceleration_profile == kinematics::AccelerationProfile::s_curve && control_.filter_time_s <= 0.0;
}

double RapidPlanner::sampled_time_s(const RestMove& move, double period_s) {
  return (std::floor(move.duration_s() / period_s) + 2 * settling_cycles) * period_s;
}

std::optional<AxisCurve> RapidPlanner::curve(const RapidLine& line) const {
  constexpr double turn_of_a_cell_rad = 0.15;
  constexpr int cells_least = 2, cells_most = 512;
  const double turn_rad = (line.to_q - line.from_q).tail<2>().cwiseAbs().maxCoeff();
  if (!line.tcp || (turn_rad == 0.0 && !line.circle_P)) return AxisCurve::line(line.from_q, line.to_q);
  const double cells = std::ceil(turn_rad / turn_of_a_cell_rad);
  if (cells > cells_most) return std::nullopt;
  AxisVector near_q = line.from_q;
  const auto axes = [&](double share) {
    const auto q = geometry_.axes_on(line, share, share <= 0.0 ? line.from_q : near_q);
    if (q) near_q = *q;
    return q;
  };
  return AxisCurve::through(axes, std::max(cells_least, static_cast<int>(cells)), cells_most);
}

std::optional<RestMove> RapidPlanner::move(const RapidLine& line) const {
  auto way = curve(line);
  if (!way) return std::nullopt;
  const auto limits = RestLimits::of(machine_, control_.servo_period_s, way->positions_most());
  if (!limits) return std::nullopt;
  return RestMove(*std::move(way), *limits, line.least_time_s, (line.to_tip_P_mm - line.from_tip_P_mm).norm());
}

double RapidPlanner::averaged_time_s(std::span<const PlannedBlock> blocks) const {
  CornerRounder rounder(feed_, rapid_, blocks.front().path.rapid->from_q);
  SpeedProfile profile(std::max(1, control_.look_ahead_blocks));
  std::vector<PathCell> cells;
  std::vector<TimedCell> timed;
  for (const PlannedBlock& planned : blocks) {
    cells.clear();
    append(planned, rounder, cells);
    profile.add_block(cells, timed);
  }
  cells.clear();
  rounder.finish(cells);
  profile.add_block(cells, timed);
  profile.finish(timed);
  const MotionLimits& limits = blocks.front().block->feed_average ? feed_ : rapid_;
  const double drain_s = limits.filter_samples * control_.servo_period_s;
  double time_s = drain_s;
  for (const TimedCell& cell : timed) {
    if (cell.cell.hold) time_s += drain_s;
    for (int k = 0; k < cell.phase_count; ++k) {
      const Phase& phase = cell.phases[static_cast<std::size_t>(k)];
      time_s += 2.0 * (phase.to - phase.from) / (phase.speed_from + phase.speed_to);
    }
  }
  return time_s;
}

std::vector<RestMove> RapidPlanner::moves(std::span<const PlannedBlock> blocks) const {
  std::vector<RestMove> moves;
  double time_s = 0.0;
  for (const PlannedBlock& planned : blocks) {
    auto one = move(*planned.path.rapid);
    if (!one) return {};
    time_s += sampled_time_s(*one, control_.servo_period_s);
    moves.push_back(*std::move(one));
  }
  return time_s < averaged_time_s(blocks) ? std::move(moves) : std::vector<RestMove>{};
}

}  // namespace volute::sim
