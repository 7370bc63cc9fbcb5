#include "sim/controller/linuxcnc/corner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace volute::sim::linuxcnc {

namespace {

enum class Tangency { not_applicable, tangent, kink };

/// Half the angle between the two legs of a corner: a right angle for a straight passage.
double half_corner(const Vec3& in, const Vec3& out) { return 0.5 * std::acos(-std::clamp(in.dot(out), -1.0, 1.0)); }

double triangle_speed(const Segment& segment) {
  // A blend may still take half of a segment whose length is not settled.
  const double length = segment.length_final ? segment.length : 0.5 * segment.length;
  return std::sqrt(segment.acceleration_along() * length);
}

// A change of direction within one cycle at speed v is an acceleration of v / cycle times the change of the unit
// tangent.
Tangency check_tangency(Segment& last, Segment& next, const PlannerLimits& limits) {
  if (last.turns_rotaries() || next.turns_rotaries() || last.end == EndMode::stop) return Tangency::not_applicable;
  const Vec3 in = last.end_tangent(), out = next.start_tangent();
  const double reversal = 2.0 * std::numbers::pi / 180.0;
  if ((in + out).squaredNorm() < reversal * reversal) {
    set_end(last, &next, EndMode::stop);
    return Tangency::not_applicable;
  }
  const double speed = std::min(last.speed_target(), next.speed_target());
  const double sudden = speed / limits.cycle_s + next.acceleration;
  double share = (sudden * (out - in)).cwiseAbs().cwiseQuotient(limits.acceleration).maxCoeff();
  if (last.shape == Shape::arc || next.shape == Shape::arc) share *= 2.0;
  const bool tangent = share < limits.kink_ratio;
  const double loss = tangent ? share : limits.kink_ratio;
  last.kink_speed = tangent ? speed : speed * limits.kink_ratio / share;
  last.kink_loss = std::max(loss, last.kink_loss);
  next.kink_loss_before = std::max(loss, next.kink_loss_before);
  if (tangent) set_end(last, &next, EndMode::tangent);
  return tangent ? Tangency::tangent : Tangency::kink;
}

void forget_kink(Segment& last, Segment& next) {
  last.kink_speed = -1.0;
  last.kink_loss = 0.0;
  next.kink_loss_before = 0.0;
}

enum class Choice { none, parabolic, tangent, arc };

// Speeds through the corner are compared; an overlap halves the acceleration of both segments and so counts half.
Choice choose(Segment& last, Segment& next, const Segment* arc) {
  if (last.end == EndMode::exact || last.end == EndMode::stop) return Choice::none;
  const double parabolic = 0.5 * overlap_speeds(last, next, last.speed_target(), next.speed_target()).together;
  const double tangent = last.kink_speed;
  const double by_arc = arc ? arc->speed_max : 0.0;
  if (parabolic >= tangent && parabolic >= by_arc) {
    forget_kink(last, next);
    set_end(last, &next, EndMode::parabolic);
    return Choice::parabolic;
  }
  if (tangent >= by_arc) {
    set_end(last, &next, EndMode::tangent);
    return Choice::tangent;
  }
  forget_kink(last, next);
  return Choice::arc;
}

}  // namespace

Overlap overlap_speeds(const Segment& before, const Segment& after, double target_before, double target_after) {
  const double a_before = before.acceleration_along(), a_after = after.acceleration_along();
  const double v_before = std::min(triangle_speed(before), target_before),
               v_after = std::min(triangle_speed(after), target_after);
  const double longest_s = std::min(before.length / v_before, after.length / v_after);
  const double overlap_s = std::min(longest_s, std::max(v_before / a_before, v_after / a_after));
  Overlap overlap{std::min(v_before, overlap_s * a_before), std::min(v_after, overlap_s * a_after), 0.0};
  const double theta = half_corner(before.end_pull(), after.start_pull());
  constexpr double least_angle = 1e-3;
  if (before.tolerance > 0.0 && std::cos(theta) > std::cos(0.5 * std::numbers::pi - least_angle)) {
    const double by_tolerance = 2.0 * std::sqrt(a_before * before.tolerance / std::cos(theta));
    overlap.before = std::min(overlap.before, by_tolerance);
    overlap.after = std::min(overlap.after, by_tolerance);
  }
  overlap.together = 0.5 * std::sin(theta) * (overlap.before + overlap.after);
  return overlap;
}

std::optional<Segment> join(Segment& last, Segment& next, const PlannerLimits& limits, bool& consumed) {
  consumed = false;
  if (last.rapid != next.rapid) set_end(last, &next, EndMode::stop);
  if (last.progress > 0.5 * last.length) return std::nullopt;
  if (check_tangency(last, next, limits) != Tangency::kink) return std::nullopt;
  const bool may_round = last.end == EndMode::parabolic && !last.length_final && !next.length_final;
  const auto arc = may_round ? arc_between(last, next, limits) : std::nullopt;
  if (!arc) {
    choose(last, next, nullptr);
    return std::nullopt;
  }
  if (choose(last, next, &arc->segment) != Choice::arc) {
    choose(last, next, nullptr);  // the control compares again, with what the first choice has set
    return std::nullopt;
  }
  const auto cut = [](Segment& segment, const Segment& rest) {
    segment.line = rest.line;
    segment.arc = rest.arc;
    segment.length = rest.length;
  };
  consumed = arc->consumed;
  if (!consumed) cut(last, arc->before);
  cut(next, arc->after);
  set_end(last, &next, EndMode::tangent);
  return arc->segment;
}

}  // namespace volute::sim::linuxcnc
