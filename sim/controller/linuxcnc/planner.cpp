#include "sim/controller/linuxcnc/planner.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::sim::linuxcnc {

namespace {

/// Only a tangent end is passed at speed, and no faster than either side is asked to go.
double final_speed(const Segment& segment, const Segment* next) {
  if (segment.end != EndMode::tangent) return 0.0;
  return std::min({segment.speed_final, segment.speed_target(), next ? next->speed_target() : 0.0});
}

struct Change {
  double acceleration = 0.0;
  double speed_wanted = 0.0;  ///< that would just reach the end
};

/// The speed after one more cycle from which the segment can still be ended: v with (v - vf) (v + vf) / 2a + (v +
/// v_now) T / 2 = what is left.
Change trapezoidal_change(const Segment& segment, const Segment* next) {
  const double a = segment.acceleration_along(), half = 0.5 * a * segment.cycle_s, vf = final_speed(segment, next);
  const double inside = vf * vf + a * (2.0 * segment.to_go() - segment.speed * segment.cycle_s) + half * half;
  double wanted = -half;
  if (inside > half * half) wanted += std::sqrt(inside);
  const double target = segment.speed_target();
  const double bounded = std::clamp(wanted, -target, target);
  const double change = (bounded - segment.speed) / std::max(segment.cycle_s, time_epsilon);
  return {std::clamp(change, -a, a), wanted};
}

/// One acceleration over the rest of a short tangent segment. False: it ends too slowly for that.
bool ramp_change(const Segment& segment, const Segment* next, Change& change) {
  const double vf = final_speed(segment, next);
  if (vf < speed_epsilon) return false;
  const double mean = 0.5 * (segment.speed + vf);
  const double left_s = mean > speed_epsilon ? std::max(segment.to_go() / mean, 1e-16) : 1e-16;
  const double a = segment.acceleration_along();
  change = {std::clamp((vf - segment.speed) / left_s, -a, a), vf};
  return true;
}

void move_on(Segment& segment, const Change& change) {
  double next_speed = segment.speed + change.acceleration * segment.cycle_s;
  if (next_speed < 0.0) {
    next_speed = 0.0;
    if (segment.to_go() < segment.speed * segment.cycle_s) segment.progress = segment.length;
  } else {
    const double step = 0.5 * (next_speed + segment.speed) * segment.cycle_s;
    segment.progress = std::clamp(segment.progress + step, 0.0, segment.length);
  }
  segment.speed = next_speed;
  segment.braking_to_end = std::abs(change.speed_wanted - next_speed) < speed_epsilon && change.acceleration < 0.0;
}

void split(Segment& segment, double after_s, double speed) {
  segment.splitting = true;
  segment.cycle_s = after_s;
  segment.speed_at_split = speed;
}

}  // namespace

void Planner::add(const Move& move) {
  Segment segment;
  segment.shape = move.shape;
  segment.rotary = Straight<geometry::Vec2>(goal_.rotary_deg, move.end.rotary_deg);
  if (move.shape == Shape::arc) {
    segment.arc = Arc::through(goal_.xyz, move.end.xyz, move.centre, move.normal, move.turns);
    segment.length = segment.arc.length();
  } else {
    segment.line = Straight<Vec3>(goal_.xyz, move.end.xyz);
    segment.length = !segment.line.none ? segment.line.length : segment.rotary.none ? 0.0 : segment.rotary.length;
  }
  if (segment.length < position_epsilon) return;
  segment.nominal_length = segment.length;
  segment.speed_requested = move.speed;
  segment.speed_max = move.speed_max;
  segment.acceleration = move.acceleration;
  segment.end = move.end_mode;
  segment.tolerance = move.tolerance;
  segment.rapid = move.rapid;
  segment.waits_for_spindle = move.waits_for_spindle;
  segment.block = move.block;
  segment.cycle_s = limits_.cycle_s;
  segment.cap_speed_by_length();
  if (!queue_.empty()) {
    Segment& last = queue_.back();
    bool consumed = false;
    const auto arc = join(last, segment, limits_, consumed);
    last.fix_length();
    if (segment.waits_for_spindle && !consumed) set_end(last, &segment, EndMode::stop);
    if (consumed) queue_.pop_back();
    if (arc) queue_.push_back(*arc);
  }
  // The first of an empty queue is taken up at once, before anything is known about what follows.
  segment.active = queue_.empty();
  queue_.push_back(segment);
  goal_ = queue_.back().end_position();
  plan_ahead();
}

// The newest segment may still lose half of its length, so the one before may enter it no faster than it could stop
// within that half.
void Planner::plan_pair(Segment& before, Segment& after) const {
  if (!after.length_final) {
    double entry = std::min(std::sqrt(after.acceleration_along() * after.length), after.speed_target());
    entry = std::min(before.speed_max, entry);
    before.speed_final = before.kink_speed >= 0.0 ? std::min(entry, before.kink_speed) : entry;
    after.speed_final = 0.0;
    return;
  }
  double entry = std::sqrt(after.speed_final * after.speed_final + 2.0 * after.acceleration_along() * after.length);
  double most = std::min(after.speed_max, before.speed_max);
  if (before.kink_speed >= 0.0) most = std::min(most, before.kink_speed);
  if (entry >= most) {
    entry = most;
    before.at_peak = true;
  }
  before.speed_final = entry;
  constexpr double least_cycles = 1.02;
  after.speed_max = std::min(after.speed_max, after.length / (limits_.cycle_s * least_cycles));
}

void Planner::plan_ahead() {
  constexpr int peaks_most = 4;
  int peaks = 0;
  bool met_stop = false;
  const auto size = static_cast<std::int64_t>(queue_.size());
  for (std::int64_t back = 1; back < limits_.look_ahead + 2; ++back) {
    const std::int64_t at = size - back;
    if (at < 1) return;
    Segment& after = queue_[static_cast<std::size_t>(at)];
    Segment& before = queue_[static_cast<std::size_t>(at - 1)];
    if (before.end != EndMode::tangent) {
      if (met_stop) return;
      met_stop = true;
      continue;
    }
    if (before.progress / before.length >= 0.25 || before.splitting || before.overlapping) return;
    if (after.waits_for_spindle) after.speed_final = 0.0;
    plan_pair(before, after);
    if (after.at_peak && ++peaks > peaks_most) return;
  }
}

void Planner::activate(Segment& segment) const {
  if (segment.active) return;
  const double mean_twice = segment.speed + std::min(segment.speed_final, segment.speed_target());
  segment.ramped = 2.0 * segment.to_go() / mean_twice < limits_.ramp_s && !segment.rapid &&
                   segment.end == EndMode::tangent && segment.to_go() != 0.0;
  segment.active = true;
  segment.overlapping = false;
  segment.braking_to_end = false;
}

void Planner::advance(Segment& segment, const Segment* next) {
  const Position before = segment.position();
  Change change;
  if (!(segment.ramped && segment.end == EndMode::tangent && ramp_change(segment, next, change)))
    change = trapezoidal_change(segment, next);
  move_on(segment, change);
  check_end(segment, next);
  const Position after = segment.position();
  now_.xyz += after.xyz - before.xyz;
  now_.rotary_deg += after.rotary_deg - before.rotary_deg;
}

// Less than a cycle from its end a segment hands the rest of the cycle to the next one.
void Planner::check_end(Segment& segment, const Segment* next) const {
  segment.cycle_s = limits_.cycle_s;
  const double left = segment.to_go();
  const bool stops = segment.end == EndMode::stop || segment.end == EndMode::exact;
  if (left <= position_epsilon) {
    segment.progress = segment.length;
    split(segment, 0.0, segment.speed);
    if (stops) segment.done = true;
    return;
  }
  if (stops) return;
  double end_speed = final_speed(segment, next);
  const double mean = 0.5 * (segment.speed + end_speed);
  double left_s = 0.5 * time_epsilon;
  if (mean > speed_epsilon)
    left_s = std::max(left_s, left / mean);
  else if (left > mean * limits_.cycle_s && left > position_epsilon)
    return;
  const double a_most = segment.acceleration_along(), a_wanted = (end_speed - segment.speed) / left_s;
  if (std::abs(a_wanted) > a_most) {
    const double a = std::copysign(a_most, a_wanted);
    const double inside = (segment.speed / a) * (segment.speed / a) + 2.0 / a * left;
    if (inside < 0.0) return;
    left_s = -segment.speed / a;
    if (inside >= time_epsilon * time_epsilon) left_s += a > 0.0 ? std::sqrt(inside) : -std::sqrt(inside);
    end_speed = segment.speed + left_s * a;
  }
  if (left_s < time_epsilon) {
    segment.progress = segment.length;
    split(segment, 0.0, end_speed);
  } else if (left_s < limits_.cycle_s) {
    split(segment, left_s, end_speed);
  }
}

Planner::Step Planner::split_cycle(Segment& segment, Segment* next) {
  const Position before = segment.position();
  segment.progress = segment.length;
  const Position after = segment.position();
  now_.xyz += after.xyz - before.xyz;
  now_.rotary_deg += after.rotary_deg - before.rotary_deg;
  segment.done = true;
  if (!next) return {&segment, segment.speed};
  if (segment.end == EndMode::tangent) {
    next->cycle_s = limits_.cycle_s - segment.cycle_s;
    next->speed = segment.speed_at_split;
  }
  const double in_next_s = next->cycle_s;
  advance(*next, queue_.size() > 2 ? &queue_[2] : nullptr);
  const bool mostly_here = segment.cycle_s > in_next_s && segment.end == EndMode::tangent;
  return {mostly_here ? &segment : next, next->speed};
}

Planner::Step Planner::regular_cycle(Segment& segment, Segment* next) {
  segment.cycle_s = limits_.cycle_s;
  advance(segment, next);
  if (!next || segment.end != EndMode::parabolic) return {&segment, segment.speed};
  const Overlap overlap = overlap_speeds(segment, *next, segment.speed_target(), next->speed_target());
  segment.blend_speed = overlap.before;
  next->blend_speed = overlap.after;
  segment.overlapping = segment.overlapping || (segment.braking_to_end && segment.speed < segment.blend_speed);
  if (!segment.overlapping) return {&segment, segment.speed};
  advance(*next, nullptr);
  return {segment.speed > next->speed ? &segment : next, segment.speed + next->speed};
}

Planner::Step Planner::cycle() {
  VOLUTE_CHECK(!queue_.empty());
  Segment& segment = queue_.front();
  Segment* next = queue_.size() > 1 ? &queue_[1] : nullptr;
  activate(segment);
  Step step{&segment, 0.0};
  if (!segment.done) step = segment.splitting ? split_cycle(segment, next) : regular_cycle(segment, next);
  if (!segment.done) return step;
  if (step.segment == &segment) {
    finished_ = segment;
    step.segment = &finished_;
  }
  queue_.pop_front();
  return step;
}

}  // namespace volute::sim::linuxcnc
