#include "sim/controller/linuxcnc/canon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace volute::sim::linuxcnc {

namespace {

constexpr double half_turn = std::numbers::pi;
constexpr std::size_t chained_most = 100;

EndMode end_mode(PathMode mode) {
  if (mode == PathMode::exact_stop) return EndMode::stop;
  return mode == PathMode::exact_path ? EndMode::exact : EndMode::parabolic;
}

std::array<double, 5> travels(const Position& from, const Position& to) {
  const Vec3 xyz = (to.xyz - from.xyz).cwiseAbs();
  const geometry::Vec2 rotary = (to.rotary_deg - from.rotary_deg).cwiseAbs();
  std::array<double, 5> travel{xyz.x(), xyz.y(), xyz.z(), rotary.x(), rotary.y()};
  for (double& t : travel)
    if (t < fuzz) t = 0.0;
  return travel;
}

double distance_to_line(const Vec3& from, const Vec3& to, const Vec3& point) {
  const Vec3 way = to - from;
  const double share = std::clamp(way.dot(point - from) / way.squaredNorm(), 0.0, 1.0);
  return (point - (from + share * way)).norm();
}

}  // namespace

/// How far the tool goes, and how long the slowest axis needs with `most` of velocity (or acceleration: then the square
/// of a time).
Canon::Reach Canon::slowest(const Position& end, const std::array<double, 5>& most) const {
  const auto travel = travels(at_, end);
  Reach reach;
  for (std::size_t i = 0; i < travel.size(); ++i) reach.time_s = std::max(reach.time_s, travel[i] / most[i]);
  const double linear = std::hypot(travel[0], travel[1], travel[2]);
  reach.distance = linear > 0.0 ? linear : std::hypot(travel[3], travel[4]);
  return reach;
}

void Canon::set_modes(const MotionBlock& block, const Sink& sink) {
  const EndMode mode = end_mode(block.path_mode);
  const double tolerance = mode == EndMode::parabolic ? std::max(0.0, block.path_tolerance_mm) : 0.0;
  if (mode != mode_ || tolerance != tolerance_) flush(sink);
  mode_ = mode;
  tolerance_ = tolerance;
  naive_tolerance_ = block.naive_cam_tolerance_mm >= 0.0 ? block.naive_cam_tolerance_mm : tolerance;
  const double spindle = block.spindle_on ? block.spindle_rad_s * (block.spindle_reversed ? -1.0 : 1.0) : 0.0;
  if (spindle != spindle_ && spindle != 0.0) spindle_changed_ = true;
  spindle_ = spindle;
}

// Inverse time becomes a feed before the planner sees it, never less than 0.1 a minute.
void Canon::set_feed(const MotionBlock& block, const Position& end, const Sink& sink) {
  double linear = block.feed, rotary = block.feed * (block.rotary_only ? deg_per_rad : 1.0);
  if (block.feed_mode == FeedMode::per_revolution)
    linear = rotary = block.feed * block.spindle_rad_s / (2.0 * half_turn);
  if (block.feed_mode == FeedMode::inverse_time) {
    const Position& from = seen();
    double length = (end.xyz - from.xyz).norm();
    if (block.kind == MotionKind::arc) {
      const double rise = (end.xyz - from.xyz).dot(block.plane_normal);
      Vec3 spoke = from.xyz - block.centre_mm;
      spoke -= spoke.dot(block.plane_normal) * block.plane_normal;
      length = std::hypot(rise, spoke.norm() * block.sweep_rad);
    } else if ((end.xyz - from.xyz).cwiseAbs().maxCoeff() <= 1e-7) {
      length = (end.rotary_deg - from.rotary_deg).norm();
    }
    linear = rotary = std::max(0.1 / 60.0, length * block.feed);
  }
  if (linear != linear_feed_ || rotary != rotary_feed_) flush(sink);
  linear_feed_ = linear;
  rotary_feed_ = rotary;
}

void Canon::send(Move move, const Sink& sink) {
  if (move.speed <= 0.0 || move.acceleration <= 0.0) return;
  move.end_mode = mode_;
  move.tolerance = tolerance_;
  if (!move.rapid && spindle_changed_) {
    move.waits_for_spindle = true;
    spindle_changed_ = false;
  }
  sink(move);
}

void Canon::flush(const Sink& sink) {
  if (chain_.empty()) return;
  const Chained last = chain_.back();
  chain_.clear();
  const Reach reach = slowest(last.end, bounds_.velocity), square = slowest(last.end, bounds_.acceleration);
  Move move;
  move.end = last.end;
  move.block = last.block;
  if (reach.time_s > 0.0) {
    const auto travel = travels(at_, last.end);
    const bool linear = travel[0] + travel[1] + travel[2] > 0.0;
    move.speed_max = reach.distance / reach.time_s;
    move.speed = std::min(move.speed_max, linear ? linear_feed_ : rotary_feed_);
    move.acceleration = square.distance / square.time_s;
    send(move, sink);
  }
  at_ = last.end;
}

bool Canon::joins(const Position& end) const {
  if (mode_ != EndMode::parabolic || naive_tolerance_ == 0.0 || chain_.size() > chained_most) return false;
  if (end.rotary_deg != chain_.back().end.rotary_deg || end.xyz == at_.xyz) return false;
  return std::all_of(chain_.begin(), chain_.end(), [&](const Chained& point) {
    return distance_to_line(at_.xyz, end.xyz, point.end.xyz) <= naive_tolerance_;
  });
}

void Canon::see_line(const Position& end, BlockInfo* info, const Sink& sink) {
  const bool turns = end.rotary_deg != at_.rotary_deg;
  if (!chain_.empty() && !joins(end)) flush(sink);
  chain_.push_back({end, info});
  if (turns) flush(sink);
}

void Canon::add(const MotionBlock& block, const Position& end, const Vec3& centre, BlockInfo* info, const Sink& sink) {
  set_modes(block, sink);
  if (block.kind == MotionKind::rapid) {
    flush(sink);
    const Reach reach = slowest(end, bounds_.velocity), square = slowest(end, bounds_.acceleration);
    Move move;
    move.end = end;
    move.block = info;
    move.rapid = true;
    if (reach.time_s > 0.0) {
      move.speed = move.speed_max = reach.distance / reach.time_s;
      move.acceleration = square.distance / square.time_s;
      send(move, sink);
    }
    at_ = end;
    return;
  }
  set_feed(block, end, sink);
  if (block.kind == MotionKind::arc)
    add_arc(block, end, centre, info, sink);
  else
    see_line(end, info, sink);
}

// A flat arc within the naive-CAM tolerance of two chords is taken as these.
void Canon::add_arc(const MotionBlock& block, const Position& end, const Vec3& centre, BlockInfo* info,
                    const Sink& sink) {
  const Position from = seen();
  Vec3 spoke = from.xyz - centre;
  const double rise = (end.xyz - from.xyz).dot(block.plane_normal);
  spoke -= spoke.dot(block.plane_normal) * block.plane_normal;
  const bool flat_plane = std::abs(block.plane_normal.z()) > 0.999999;
  const double sweep = std::remainder(std::abs(block.sweep_rad), 2.0 * half_turn) <= 0.0
                           ? std::fmod(std::abs(block.sweep_rad), 2.0 * half_turn)
                           : std::abs(block.sweep_rad);
  const double included = std::abs(block.sweep_rad) > 2.0 * half_turn ? sweep : std::abs(block.sweep_rad);
  if (flat_plane && mode_ == EndMode::parabolic && spoke.norm() * (1.0 - std::cos(0.5 * included)) < naive_tolerance_) {
    Position middle;
    middle.xyz = centre + Eigen::AngleAxisd(0.5 * block.sweep_rad, block.plane_normal) * spoke;
    middle.xyz += ((from.xyz - centre).dot(block.plane_normal) + 0.5 * rise) * block.plane_normal;
    middle.rotary_deg = 0.5 * (at_.rotary_deg + end.rotary_deg);
    see_line(middle, info, sink);
    see_line(end, info, sink);
    return;
  }
  flush(sink);
  send_arc(block, end, centre, info, sink);
}

// In the plane an arc may move in any direction, so the slower axis counts; across the arc 0.866 of its acceleration is
// used.
void Canon::send_arc(const MotionBlock& block, const Position& end, const Vec3& centre, BlockInfo* info,
                     const Sink& sink) {
  const Vec3 n = block.plane_normal.normalized();
  const auto flat = [&](const Vec3& v) { return Vec3(v - v.dot(n) * n).norm(); };
  double speed_axes = no_limit, acceleration_axes = no_limit;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(n[i]) > 0.5) continue;
    speed_axes = std::min(speed_axes, bounds_.velocity[static_cast<std::size_t>(i)]);
    acceleration_axes = std::min(acceleration_axes, bounds_.acceleration[static_cast<std::size_t>(i)]);
  }
  const double start_radius = flat(at_.xyz - centre), end_radius = flat(end.xyz - centre);
  const double angle = std::abs(block.sweep_rad), spiral = end_radius - start_radius,
               least_radius = std::min(start_radius, end_radius);
  const double radius = std::hypot(spiral / angle, least_radius);
  const double speed_plane = std::min(speed_axes, std::sqrt(acceleration_axes * std::sqrt(3.0) / 2.0 * radius));
  const double flat_length = std::hypot(least_radius * angle, spiral),
               length = std::hypot(flat_length, (end.xyz - at_.xyz).dot(n));
  Move move;
  move.shape = Shape::arc;
  move.end = end;
  move.centre = centre;
  move.block = info;
  move.speed_max = length / std::max(slowest(end, bounds_.velocity).time_s, flat_length / speed_plane);
  move.acceleration = length / std::max(slowest(end, bounds_.acceleration).time_s, flat_length / acceleration_axes);
  move.speed = std::min(linear_feed_, move.speed_max);
  move.normal = n;
  const int whole = std::max(0, static_cast<int>(std::ceil(angle / (2.0 * half_turn) - 1e-9)) - 1);
  move.turns = block.sweep_rad > 0.0 ? whole : -1 - whole;
  send(move, sink);
  at_ = end;
}

}  // namespace volute::sim::linuxcnc
