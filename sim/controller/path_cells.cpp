#include "sim/controller/path_cells.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::sim {

namespace {

using kinematics::axis_count;
/// A turn of dq/ds below this (per unit of s) is rounding of the program's last digits.
constexpr double no_turn = 1e-12;
/// A bend of the tip's path (or, without TCP, of the linear axes) from here on is called a corner in reports.
constexpr double corner_sine = 0.0872;  // 5 degrees

void lower_limit(PathCell& cell, double speed_sq, Limit limit, int axis) {
  if (!(speed_sq < cell.speed_sq_max)) return;
  cell.speed_sq_max = speed_sq;
  cell.limit = limit;
  cell.limit_axis = axis;
}

/// What the tolerance sees of a change of dq/ds: the tip under TCP, else the linear axes.
Vec3 contour_part(const PathPoint& at, const AxisVector& v) {
  return at.tcp ? Vec3(at.tip_rates * v) : Vec3(v.head<3>());
}

void limit_velocity(PathCell& cell) {
  const AxisVector end_rate = cell.rate + cell.length * cell.curvature;
  for (int i = 0; i < axis_count; ++i) {
    const double rate = std::max(std::abs(cell.rate[i]), std::abs(end_rate[i]));
    if (rate <= 0.0) continue;
    const double speed = cell.limits->velocity[static_cast<std::size_t>(i)] / rate;
    lower_limit(cell, speed * speed, Limit::axis_velocity, i);
  }
}

void limit_acceleration(PathCell& cell) {
  cell.acceleration_max = no_limit;
  for (int i = 0; i < axis_count; ++i) {
    const double rate = std::abs(cell.rate[i]);
    if (rate <= 0.0) continue;
    const double acceleration = cell.limits->acceleration[static_cast<std::size_t>(i)] / rate;
    if (acceleration >= cell.acceleration_max) continue;
    cell.acceleration_max = acceleration;
    cell.acceleration_axis = i;
  }
}

/// The speed's change is even within a cell, so a wide turn of the axes (weighed by what they can do) needs several.
int cells_of_turn(const AxisVector& in, const AxisVector& out, int halves, const MotionLimits& limits) {
  constexpr double turn_of_a_cell = 0.07;
  const int cells_most = 32 / halves;
  double turn = 0.0, size = 0.0;
  for (int i = 0; i < axis_count; ++i) {
    const double a = limits.acceleration[static_cast<std::size_t>(i)];
    turn = std::max(turn, std::abs(out[i] - in[i]) / a);
    size = std::max({size, std::abs(in[i]) / a, std::abs(out[i]) / a});
  }
  return std::clamp(static_cast<int>(std::ceil(turn / (halves * turn_of_a_cell * size))), 1, cells_most);
}

}  // namespace

PathCell CornerRounder::cell_of(const Piece& piece) const {
  PathCell cell;
  cell.limits = &limits_of(piece.end);
  cell.speed_sq_max = piece.end.speed_max * piece.end.speed_max;
  cell.limit = piece.end.speed_limit;
  cell.block = piece.end.block;
  cell.tip_rates = piece.end.tip_rates;
  cell.tip_rate = (piece.end.tip_rates * piece.rate).norm();
  return cell;
}

void CornerRounder::straight(const Piece& piece, double from, double to, std::vector<PathCell>& cells) const {
  if (to - from <= 1e-12 * piece.end.length) return;
  PathCell& cell = cells.emplace_back(cell_of(piece));
  cell.length = to - from;
  cell.start = piece.start + from * piece.rate;
  cell.rate = piece.rate;
  limit_velocity(cell);
  limit_acceleration(cell);
}

// The average over the filter lags an acceleration by a * lag_per_acceleration; only what stands across the path is an
// error.
void CornerRounder::limit_bend(PathCell& cell, const PathPoint& at) const {
  const double lag_s2 = cell.limits->lag_per_acceleration_s2;
  if (lag_s2 <= 0.0) return;
  const Limit limit = cell.corner ? Limit::corner : Limit::axis_jerk;
  Vec3 bend = contour_part(at, cell.curvature);
  const Vec3 along = contour_part(at, cell.rate + cell.curvature * cell.length);
  if (along.squaredNorm() > 1e-12) bend -= bend.dot(along) / along.squaredNorm() * along;
  if (std::isfinite(at.lag_tolerance_mm) && bend.norm() > 0.0)
    lower_limit(cell, at.lag_tolerance_mm / (lag_s2 * bend.norm()), limit, -1);
  const double turn = cell.curvature.tail<2>().norm();
  if (std::isfinite(at.lag_tolerance_rad) && turn > 0.0) {
    int axis = 0;
    cell.curvature.tail<2>().cwiseAbs().maxCoeff(&axis);
    lower_limit(cell, at.lag_tolerance_rad / (lag_s2 * turn), limit, 3 + axis);
  }
}

void CornerRounder::corner(Piece& in, Piece& out, std::vector<PathCell>& cells) const {
  const AxisVector turn = out.rate - in.rate;
  double reach = std::min(0.5 * in.end.length, 0.5 * out.end.length);
  if (turn.cwiseAbs().maxCoeff() <= no_turn) reach = 0.0;
  const Vec3 bend = contour_part(in.end, turn);
  const Vec3 before = contour_part(in.end, in.rate), after = contour_part(in.end, out.rate);
  const Vec3 along = before + after;
  Vec3 across = bend;
  if (along.norm() > 1e-3 * (before.norm() + after.norm())) across -= bend.dot(along) / along.squaredNorm() * along;
  const double stray = across.norm(), stray_rad = turn.tail<2>().norm();
  if (stray * reach > 4.0 * in.end.corner_tolerance_mm) reach = 4.0 * in.end.corner_tolerance_mm / stray;
  if (stray_rad * reach > 4.0 * in.end.corner_tolerance_rad) reach = 4.0 * in.end.corner_tolerance_rad / stray_rad;
  straight(in, in.used, in.end.length - reach, cells);
  out.used = reach;
  if (reach <= 0.0) return;
  const bool sharp = std::isfinite(in.end.corner_tolerance_mm) &&
                     before.cross(after).norm() > corner_sine * before.norm() * after.norm();
  round(in, out, reach, sharp, cells);
}

// In as many cells as the turn asks for: each half by itself where the block, and with it the feed, changes.
void CornerRounder::round(const Piece& in, const Piece& out, double reach, bool sharp,
                          std::vector<PathCell>& cells) const {
  const int halves = in.end.block == out.end.block ? 1 : 2;
  const double share = 2.0 * reach / halves;
  const AxisVector curvature = (out.rate - in.rate) / (2.0 * reach);
  const AxisVector start = in.end.q - reach * in.rate;
  for (int half = 0; half < halves; ++half) {
    const Piece& piece = half == 0 ? in : out;
    const MotionLimits& limits = limits_of(piece.end);
    const int parts = cells_of_turn(in.rate, out.rate, halves, limits);
    for (int part = 0; part < parts; ++part) {
      PathCell& cell = cells.emplace_back(cell_of(piece));
      const double s = half * share + part * share / parts;
      cell.speed_sq_max =
          halves == 1 ? std::min(cell.speed_sq_max, out.end.speed_max * out.end.speed_max) : cell.speed_sq_max;
      cell.tip_rates = in.end.tip_rates;
      cell.length = share / parts;
      cell.straight = false;
      cell.corner = sharp;
      cell.curvature = curvature;
      cell.start = start + s * in.rate + (0.5 * s * s) * curvature;
      cell.rate = in.rate + s * curvature;
      limit_velocity(cell);
      limit_bend(cell, in.end);
    }
  }
}

void CornerRounder::add(const PathPoint& point, std::vector<PathCell>& cells) {
  VOLUTE_CHECK(point.length > 0.0 && point.block != nullptr, point.length);
  Piece piece{point, at_, (point.q - at_) / point.length};
  at_ = point.q;
  if (pending_) corner(*pending_, piece, cells);
  pending_ = piece;
}

void CornerRounder::finish(std::vector<PathCell>& cells) {
  if (pending_) straight(*pending_, pending_->used, pending_->end.length, cells);
  pending_.reset();
}

void CornerRounder::hold(double dwell_s, BlockInfo* block, std::vector<PathCell>& cells) {
  finish(cells);
  PathCell cell;
  cell.hold = true;
  cell.dwell_s = dwell_s;
  cell.start = at_;
  cell.limits = &feed_;
  cell.block = block;
  cell.speed_sq_max = 0.0;
  cell.limit = Limit::stop;
  cells.push_back(cell);
}

void CornerRounder::move(const RestMove& move, const AxisVector& end, BlockInfo* block, std::vector<PathCell>& cells) {
  hold(0.0, block, cells);
  cells.back().move = &move;
  at_ = end;
}

}  // namespace volute::sim
