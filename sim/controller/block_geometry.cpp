#include "sim/controller/block_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"

namespace volute::sim {

using geometry::bad_input;
using geometry::Result;

namespace {

constexpr double no_motion = 1e-9;  ///< mm or rad: below the last digit of any program
constexpr double same_rotaries_rad = 1e-8;
/// Corner tolerance of exact path mode: the resolution of the controls this stands for.
constexpr double exact_path_tolerance_mm = 0.001;
constexpr double exact_path_tolerance_rad = 1e-5;
/// Shares of the corner tolerance: the polygon of a curved motion, the parabola at a corner, the average that follows.
constexpr double chord_share = 0.1, corner_share = 0.45, lag_share = 0.45;
static_assert(chord_share + corner_share + lag_share <= 1.0 + 1e-15);

double rotation_between(const AxisVector& a, const AxisVector& b) { return (a.tail<2>() - b.tail<2>()).norm(); }

std::string pose_text(const Vec3& v) {
  return geometry::short_text(v.x()) + ' ' + geometry::short_text(v.y()) + ' ' + geometry::short_text(v.z());
}

double corner_tolerance(const kinematics::Control& control, const MotionBlock& block) {
  if (block.path_mode == PathMode::exact_path) return exact_path_tolerance_mm;
  if (block.path_tolerance_mm > 0.0) return block.path_tolerance_mm;
  return control.corner_mode == kinematics::CornerMode::parabolic_blend ? no_limit : control.corner_tolerance_mm;
}

double corner_tolerance_rad(const kinematics::Control& control, const MotionBlock& block) {
  if (block.path_mode == PathMode::exact_path) return exact_path_tolerance_rad;
  if (block.rotary_tolerance_rad > 0.0) return block.rotary_tolerance_rad;
  return control.corner_mode == kinematics::CornerMode::parabolic_blend ? no_limit : control.corner_tolerance_rad;
}

/// How long the block takes at its greatest speed.
double least_time_of(const BlockPath& path) {
  double time_s = 0.0;
  for (const PathPoint& point : path.points) time_s += point.length / point.speed_max;
  return time_s;
}

}  // namespace

BlockGeometry::BlockGeometry(const kinematics::Machine& machine, const kinematics::Control& control,
                             const kinematics::Setup& setup, double tool_length_mm, const AxisVector& start)
    : machine_(machine),
      control_(control),
      solver_(machine, setup, tool_length_mm),
      zero_with_tool_(kinematics::program_zero(machine, setup, tool_length_mm)),
      zero_without_tool_(kinematics::program_zero(machine, setup, 0.0)),
      chord_tolerance_mm_(chord_share *
                          (control.corner_tolerance_mm > 0.0 ? control.corner_tolerance_mm : exact_path_tolerance_mm)),
      q_(start),
      state_(solver_.state(start)) {}

// A word gives a position, or a distance from where the axis stands; a coordinate the text does not know stays where it
// is.
Result<BlockGeometry::Target> BlockGeometry::target_of(const MotionBlock& block) const {
  Target target{q_, state_.tip_P_mm};
  const AxisVector& zero = zero_of(block);
  const bool tip = block.tcp && !block.machine_coordinates;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!block.xyz_programmed[k] && (block.machine_coordinates || !block.xyz_known[k])) continue;
    const double word = block.xyz_mm[i];
    if (tip)
      target.tip_P_mm[i] = block.xyz_relative[k] ? state_.tip_P_mm[i] + word : word;
    else
      target.q[i] = block.xyz_relative[k] ? q_[i] + word : word + (block.machine_coordinates ? 0.0 : zero[i]);
  }
  for (int i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (block.axis_vector || (!block.rotary_programmed[k] && (block.machine_coordinates || !block.rotary_known[k])))
      continue;
    const double word = block.rotary_rad[k];
    double position = block.rotary_relative[k] ? q_[3 + i] + word : word;
    if (block.rotary_shortest && !block.rotary_relative[k]) {
      double way = std::remainder(position - q_[3 + i], 2.0 * std::numbers::pi);
      if (way <= -std::numbers::pi + no_motion) way += 2.0 * std::numbers::pi;  // half a turn goes the positive way
      position = q_[3 + i] + way;
    }
    target.q[3 + i] = position;
  }
  if (!block.axis_vector) {
    turn_by_vector(block, target);
    return target;
  }
  const auto rotaries = solver_.rotaries_along(*block.axis_vector, q_);
  if (!rotaries)
    return bad_input("pose-unreachable", "line " + std::to_string(block.line) + ": no position of the rotaries of " +
                                             machine_.name + " points the tool along " + pose_text(*block.axis_vector) +
                                             "; tilt less or turn the part");
  target.q[3] = (*rotaries)[0];
  target.q[4] = (*rotaries)[1];
  target.axis_P = block.axis_vector->normalized();
  target.by_vector = block.tcp && block.orientation_interpolation.value_or(control_.orientation_interpolation) ==
                                      kinematics::OrientationInterpolation::great_circle;
  return target;
}

// A program may ask for the great circle between rotary words too (ORIVECT, PATHCTRL VECTOR). It is followed where it
// ends at the very positions that are programmed; another branch or turn is only reached by turning the axes.
void BlockGeometry::turn_by_vector(const MotionBlock& block, Target& target) const {
  if (!block.tcp || block.machine_coordinates ||
      block.orientation_interpolation != kinematics::OrientationInterpolation::great_circle)
    return;
  const Vec3 axis_P = solver_.state(target.q).axis_P;
  const auto rotaries = solver_.rotaries_along(axis_P, q_);
  if (!rotaries || std::hypot((*rotaries)[0] - target.q[3], (*rotaries)[1] - target.q[4]) > same_rotaries_rad) return;
  target.axis_P = axis_P;
  target.by_vector = true;
}

Result<void> BlockGeometry::go_to(const MotionBlock& block, const Target& target) {
  AxisVector q = target.q;
  if (block.tcp && !block.machine_coordinates) {
    q.head<3>() = q_.head<3>();
    const auto solved = solver_.with_tip(target.tip_P_mm, q);
    if (!solved)
      return bad_input("pose-unreachable", "line " + std::to_string(block.line) + ": the linear axes of " +
                                               machine_.name + " cannot bring the tip to " +
                                               pose_text(target.tip_P_mm) + "; check the machine's directions");
    q = *solved;
  }
  q_ = q;
  state_ = solver_.state(q);
  return {};
}

Result<BlockPath> BlockGeometry::path_of(const MotionBlock& block, BlockInfo& info) {
  BlockPath path;
  info_ = &info;
  info.line = block.line;
  if (block.kind == MotionKind::dwell || block.kind == MotionKind::stop) {
    path.stop_before = path.stop_after = true;
    path.dwell_s = block.kind == MotionKind::dwell ? block.dwell_s : 0.0;
    return path;
  }
  const bool rapid = block.kind == MotionKind::rapid;
  info.rapid = rapid;
  info.cutting = !rapid && block.spindle_on;
  const auto target = target_of(block);
  if (!target) return tl::unexpected(target.error());
  info.feed_average = !rapid || turns_about_the_tip(block, *target);
  path.stop_before = was_rapid_ && (*was_rapid_ != rapid || *was_feed_average_ != info.feed_average);
  was_rapid_ = rapid;
  was_feed_average_ = info.feed_average;
  const AxisVector from_q = q_;
  const Vec3 from_tip = state_.tip_P_mm;
  Result<void> done;
  if (block.kind == MotionKind::arc)
    done = add_arc(block, *target, path);
  else if (block.tcp && !block.machine_coordinates)
    done = target->by_vector ? add_vector(block, *target, path) : add_tcp(block, *target, path);
  else
    add_straight(block, *target, path);
  if (!done) return tl::unexpected(done.error());
  set_tolerances(block, path);
  set_speed(block, from_q, from_tip, info, path);
  if (rapid && !path.points.empty()) path.rapid = rapid_line(block, *target, from_q, from_tip, least_time_of(path));
  path.stop_after =
      block.path_mode == PathMode::exact_stop || (control_.corner_mode == kinematics::CornerMode::exact_stop && !rapid);
  return path;
}

// The long average of rapids would hold a tip on its line only while the rotaries creep: with an arm of 400 mm and
// 0.01 mm at 0.08 rad/s. The feed's average lets them turn ten times as fast, at a tenth of the acceleration; from
// about this turn on it is the quicker.
bool BlockGeometry::turns_about_the_tip(const MotionBlock& block, const Target& target) const {
  constexpr double turn_rad = 0.025;
  if (!block.tcp || block.machine_coordinates) return false;
  return target.by_vector || rotation_between(target.q, q_) > turn_rad;
}

void BlockGeometry::add_axis_point(const AxisVector& q, BlockPath& path) {
  const double rotation = rotation_between(q, q_);
  const double travel_mm = (q - q_).head<3>().norm();
  const Vec3 from_tip = state_.tip_P_mm;
  state_ = solver_.state(q);
  info_->tip_length_mm += (state_.tip_P_mm - from_tip).norm();
  q_ = q;
  if (travel_mm < no_motion && rotation < no_motion) return;
  PathPoint point;
  point.q = q;
  point.tip_rates = state_.tip_rates;
  point.length = std::max(travel_mm, rotation_weight_mm_per_rad * rotation);
  path.points.push_back(point);
}

void BlockGeometry::add_straight(const MotionBlock&, const Target& target, BlockPath& path) {
  add_axis_point(target.q, path);
}

Result<void> BlockGeometry::add_tcp_point(const MotionBlock& block, const Vec3& tip_P_mm, const AxisVector& rotaries_q,
                                          BlockPath& path) {
  PathPoint point;
  const auto q = solver_.with_tip(tip_P_mm, rotaries_q, &point.tip_rates);
  if (!q)
    return bad_input("pose-unreachable", "line " + std::to_string(block.line) + ": the linear axes of " +
                                             machine_.name + " cannot bring the tip to " + pose_text(tip_P_mm) +
                                             "; check the machine's directions");
  const double rotation = rotation_between(*q, q_);
  const double tip_mm = (tip_P_mm - state_.tip_P_mm).norm();
  q_ = *q;
  state_.tip_P_mm = tip_P_mm;
  state_.tip_rates = point.tip_rates;
  info_->tip_length_mm += tip_mm;
  if (tip_mm < no_motion && rotation < no_motion) return {};
  point.q = q_;
  point.tcp = true;
  point.length = std::max(tip_mm, rotation_weight_mm_per_rad * rotation);
  path.points.push_back(point);
  return {};
}

// The bow of the linear axes over their chord falls with the square of the number of pieces. It is at most the arm
// between tip and rotary lines times the rotation squared over 8; where that is too much it is looked at in the middle.
int BlockGeometry::tcp_pieces(const AxisVector& to_rotaries_q, const Vec3& tip_P_mm) const {
  constexpr double turn_of_a_piece_rad = 0.25;  // up to here the middle tells the greatest bow
  const double rotation = rotation_between(to_rotaries_q, q_);
  const double arm_mm =
      std::max(state_.tip_rates.col(3).norm(), state_.tip_rates.col(4).norm()) + (tip_P_mm - state_.tip_P_mm).norm();
  double bow_mm = 0.125 * arm_mm * rotation * rotation;
  if (bow_mm > chord_tolerance_mm_ && rotation < turn_of_a_piece_rad) {
    const AxisVector middle_q = 0.5 * (q_ + to_rotaries_q);
    const auto end = solver_.with_tip(tip_P_mm, to_rotaries_q);
    const auto middle = solver_.with_tip(0.5 * (state_.tip_P_mm + tip_P_mm), middle_q);
    if (end && middle) bow_mm = (*middle - 0.5 * (q_ + *end)).head<3>().norm();
  }
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(bow_mm / chord_tolerance_mm_))));
}

Result<void> BlockGeometry::add_tcp_piece(const MotionBlock& block, const Vec3& tip_P_mm,
                                          const std::array<double, 2>& rotaries, BlockPath& path) {
  const AxisVector from = q_;
  const Vec3 from_tip = state_.tip_P_mm;
  const double turn[2] = {rotaries[0] - from[3], rotaries[1] - from[4]};
  AxisVector end = from;
  end[3] = rotaries[0];
  end[4] = rotaries[1];
  const int pieces = tcp_pieces(end, tip_P_mm);
  AxisVector q = from;
  for (int i = 1; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    q.head<3>() = q_.head<3>();
    q[3] = i == pieces ? rotaries[0] : from[3] + share * turn[0];
    q[4] = i == pieces ? rotaries[1] : from[4] + share * turn[1];
    const Vec3 tip = i == pieces ? tip_P_mm : Vec3(from_tip + share * (tip_P_mm - from_tip));
    if (auto done = add_tcp_point(block, tip, q, path); !done) return done;
  }
  return {};
}

Result<void> BlockGeometry::add_tcp(const MotionBlock& block, const Target& target, BlockPath& path) {
  return add_tcp_piece(block, target.tip_P_mm, {target.q[3], target.q[4]}, path);
}

// The vector turns evenly on the great circle. Points are put where the rotaries have turned by `turn_max_rad`, which
// near the pole is many.
Result<void> BlockGeometry::add_vector(const MotionBlock& block, const Target& target, BlockPath& path) {
  constexpr double turn_max_rad = 0.02, least_share = 1.0 / 4096.0;
  const Vec3 from_axis = solver_.state(q_).axis_P, from_tip = state_.tip_P_mm;
  const double angle = std::atan2(from_axis.cross(target.axis_P).norm(), from_axis.dot(target.axis_P));
  if (angle < no_motion) return add_tcp_piece(block, target.tip_P_mm, {target.q[3], target.q[4]}, path);
  double share = 0.0, step = 1.0;
  while (share < 1.0) {
    const double next = std::min(1.0, share + step);
    const Vec3 axis = on_circle(from_axis, target.axis_P, next);
    const auto rotaries = solver_.rotaries_along(axis, q_);
    if (!rotaries)
      return bad_input("pose-unreachable", "line " + std::to_string(block.line) + ": the tool axis passes " +
                                               pose_text(axis) + ", where the rotaries of " + machine_.name +
                                               " cannot point; use more blocks or another setup");
    const double turn = std::hypot((*rotaries)[0] - q_[3], (*rotaries)[1] - q_[4]);
    if (turn > turn_max_rad && next - share > least_share) {
      step = 0.5 * (next - share);
      continue;
    }
    if (auto done = add_tcp_piece(block, from_tip + next * (target.tip_P_mm - from_tip), *rotaries, path); !done)
      return done;
    share = next;
    if (turn < 0.4 * turn_max_rad) step *= 2.0;
  }
  return {};
}

// Corners of the polygon around the arc, so that the rounding of the corners comes back to the arc itself; the ends
// stand on it.
Result<void> BlockGeometry::add_arc(const MotionBlock& block, const Target& target, BlockPath& path) {
  const bool tip = block.tcp && !block.machine_coordinates;
  const AxisVector& zero = zero_of(block);
  const AxisVector from = q_;
  const Vec3 start = tip ? state_.tip_P_mm : Vec3(from.head<3>() - zero.head<3>());
  const Vec3 end = tip ? target.tip_P_mm : Vec3(target.q.head<3>() - zero.head<3>());
  const Vec3 normal = block.plane_normal.normalized();
  const Vec3 spoke = start - block.centre_mm, flat = spoke - spoke.dot(normal) * normal;
  const Vec3 end_spoke = end - block.centre_mm, end_flat = end_spoke - end_spoke.dot(normal) * normal;
  const double rise = (end - start).dot(normal);
  const double sweep = std::abs(block.sweep_rad);
  // Bulge of the rounded polygon beyond the arc is fourth order; the chord bound keeps it far below the tolerance.
  const double step = std::min(0.2, std::sqrt(8.0 * 4.0 * chord_tolerance_mm_ / std::max(flat.norm(), 1e-6)));
  const int corners = std::max(1, static_cast<int>(std::ceil(sweep / step)));
  const double outward = 1.0 / std::cos(0.5 * sweep / corners);
  for (int i = 1; i <= corners + 1; ++i) {
    const double share = i > corners ? 1.0 : (i - 0.5) / corners;
    const Vec3 arm = Eigen::AngleAxisd(share * block.sweep_rad, normal) * flat;
    const double radius = flat.norm() + share * (end_flat.norm() - flat.norm());
    const Vec3 at =
        i > corners
            ? end
            : Vec3(block.centre_mm + (spoke.dot(normal) + share * rise) * normal + arm.normalized() * radius * outward);
    const std::array<double, 2> rotaries{from[3] + share * (target.q[3] - from[3]),
                                         from[4] + share * (target.q[4] - from[4])};
    if (tip) {
      if (auto done = add_tcp_piece(block, at, rotaries, path); !done) return done;
      continue;
    }
    AxisVector q;
    q << at + zero.head<3>(), rotaries[0], rotaries[1];
    add_axis_point(i > corners ? target.q : q, path);
  }
  return {};
}

/// The length that F measures: mm, or rad when only rotaries move.
double BlockGeometry::feed_measure(const MotionBlock& block, const AxisVector& from_q, const BlockPath& path,
                                   const BlockInfo& info) const {
  const bool tip = block.tcp && !block.machine_coordinates;
  double linear = 0.0, rotation = 0.0;
  AxisVector last = from_q;
  for (const PathPoint& point : path.points) {
    linear += (point.q - last).head<3>().norm();
    rotation += rotation_between(point.q, last);
    last = point.q;
  }
  if (tip) linear = info.tip_length_mm;
  if (block.rotary_only || linear < no_motion) return rotation;
  const double weight = control_.mixed_feed_mm_per_rad;
  if (!tip && control_.mixed_feed == kinematics::MixedFeed::all_axes_weighted)
    return std::hypot(linear, weight * rotation);
  return linear;
}

void BlockGeometry::set_speed(const MotionBlock& block, const AxisVector& from_q, const Vec3&, BlockInfo& info,
                              BlockPath& path) const {
  const double measure = feed_measure(block, from_q, path, info);
  double length = 0.0;
  for (const PathPoint& point : path.points) length += point.length;
  double least_time_s = 0.0;
  Limit limit = Limit::programmed_feed;
  if (info.rapid) {
    limit = Limit::rapid;
    if (machine_.rapid_mm_s > 0.0 && !block.rotary_only) least_time_s = measure / machine_.rapid_mm_s;
  } else if (block.feed > 0.0) {
    double speed = block.feed;
    if (block.feed_mode == FeedMode::per_revolution) speed *= block.spindle_rad_s / (2.0 * std::numbers::pi);
    if (block.feed_mode == FeedMode::inverse_time) speed *= measure;
    if (speed > 0.0) least_time_s = measure / speed;
    info.programmed_time_s = least_time_s;
  }
  if (least_time_s < control_.least_block_time_s) {
    least_time_s = control_.least_block_time_s;
    limit = Limit::block_time;
  }
  for (PathPoint& point : path.points) {
    point.block = &info;
    point.speed_limit = limit;
    if (least_time_s > 0.0) point.speed_max = length / least_time_s;
  }
}

// Points inside a block are soft: the polygon was made fine enough for any rounding. The block's end is a corner of the
// program.
void BlockGeometry::set_tolerances(const MotionBlock& block, BlockPath& path) const {
  const double tolerance_mm = corner_tolerance(control_, block), tolerance_rad = corner_tolerance_rad(control_, block);
  for (PathPoint& point : path.points) {
    point.lag_tolerance_mm = lag_share * tolerance_mm;
    point.lag_tolerance_rad = lag_share * tolerance_rad;
  }
  if (path.points.empty()) return;
  path.points.back().corner_tolerance_mm = corner_share * tolerance_mm;
  path.points.back().corner_tolerance_rad = corner_share * tolerance_rad;
}

}  // namespace volute::sim
