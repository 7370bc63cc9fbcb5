#include "sim/controller/rest_move.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace volute::sim {

namespace {

using kinematics::axis_count;
constexpr double no_bound = std::numeric_limits<double>::infinity();
/// The sums of a duration and of positions are rounded; limits keep this much off.
constexpr double rounding_margin = 1.0 - 1e-6;

/// Products of ranges, axis by axis; a speed is never negative.
struct Span {
  double low, high;
};
Span times(const Span& a, const Span& b) {
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}
Span plus(const Span& a, const Span& b) { return {a.low + b.low, a.high + b.high}; }
double size(const Span& a) { return std::max(std::abs(a.low), std::abs(a.high)); }
Span hull(double a, double b) { return {std::min(a, b), std::max(a, b)}; }

/// The greatest share of a limit that is used so far, and by which axis.
struct Peak {
  double ratio = 0.0;
  int axis = -1;
  void raise(double value, double limit, int of_axis) {
    if (!(value > ratio * limit)) return;
    ratio = value / limit;
    axis = of_axis;
  }
};

struct Peaks {
  Peak velocity, acceleration, jerk;
  double speed = 0.0;

  void raise(const Progress& a, const Progress& b, const CurveRange& curve, const RestLimits& limits) {
    const Span speed_span = hull(a.speed, b.speed), rise = hull(a.acceleration, b.acceleration);
    const Span square{speed_span.low * speed_span.low, speed_span.high * speed_span.high};
    const Span cube{square.low * speed_span.low, square.high * speed_span.high};
    const Span mixed = times(speed_span, {3.0 * rise.low, 3.0 * rise.high});
    speed = std::max(speed, speed_span.high);
    for (int i = 0; i < axis_count; ++i) {
      const Span first{curve.first_low[i], curve.first_high[i]}, second{curve.second_low[i], curve.second_high[i]},
          third{curve.third_low[i], curve.third_high[i]};
      velocity.raise(size(times(first, speed_span)), limits.velocity[i], i);
      acceleration.raise(size(plus(times(first, rise), times(second, square))), limits.acceleration[i], i);
      const Span own = times(first, {a.jerk, a.jerk});
      jerk.raise(size(plus(own, plus(times(second, mixed), times(third, cube)))), limits.jerk[i], i);
    }
  }
};

}  // namespace

// A position is rounded to half a unit of its last digit; three differences add up eight of these, and so do the
// polynomials' own sums.
std::optional<RestLimits> RestLimits::of(const kinematics::Machine& machine, double servo_period_s,
                                         const AxisVector& positions_most) {
  RestLimits limits;
  for (int i = 0; i < axis_count; ++i) {
    const kinematics::Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * positions_most[i];
    const double dt = servo_period_s;
    limits.velocity[i] = axis.velocity_max * rounding_margin - rounding / dt;
    limits.acceleration[i] = axis.acceleration_max * rounding_margin - rounding / (dt * dt);
    limits.jerk[i] = axis.jerk_max * rounding_margin - rounding / (dt * dt * dt);
    if (limits.velocity[i] <= 0.0 || limits.acceleration[i] <= 0.0 || limits.jerk[i] <= 0.0) return std::nullopt;
  }
  return limits;
}

RestMove::RestMove(AxisCurve curve, const RestLimits& limits, double least_time_s, double tip_length_mm)
    : curve_(std::move(curve)), law_(1.0, 0.0), tip_length_mm_(tip_length_mm) {
  constexpr int stretches_of_a_phase = 24;
  search_shape(limits, least_time_s);
  const Duration least = duration(law_, limits, least_time_s, stretches_of_a_phase, false);
  duration_s_ = least.time_s;
  limit_ = least.limit;
  limit_axis_ = least.axis;
}

/// The least duration of this shape: over whole stretches, or (an estimate from below) at points.
RestMove::Duration RestMove::duration(const SCurve& law, const RestLimits& limits, double least_time_s, int stretches,
                                      bool points) const {
  Peaks peaks;
  for (int phase = 0; phase < SCurve::phases; ++phase) {
    const double begin = law.begin(phase), length = law.begin(phase + 1) - begin;
    if (length <= 0.0) continue;
    Progress last = law.at(phase, begin);
    for (int k = 1; k <= stretches; ++k) {
      const Progress next = law.at(phase, begin + length * k / stretches);
      const double way = std::clamp(next.way, 0.0, 1.0);
      const double from = points ? way : std::clamp(last.way, 0.0, way);
      peaks.raise(points ? next : last, next, curve_.range(from, way), limits);
      last = next;
    }
  }
  Duration least{least_time_s * peaks.speed};
  const auto lengthen = [&](double time_s, Limit limit, int axis) {
    if (time_s > least.time_s) least = {time_s, limit, axis};
  };
  lengthen(peaks.velocity.ratio, Limit::axis_velocity, peaks.velocity.axis);
  lengthen(std::sqrt(peaks.acceleration.ratio), Limit::axis_acceleration, peaks.acceleration.axis);
  lengthen(std::cbrt(peaks.jerk.ratio), Limit::axis_jerk, peaks.jerk.axis);
  return least;
}

// From the shape of a straight curve downhill, in steps that are halved where none of the four ways leads down.
void RestMove::search_shape(const RestLimits& limits, double least_time_s) {
  constexpr int points_of_a_phase = 3, halvings = 4;
  const CurveRange all = curve_.range(0.0, 1.0);
  double speed = least_time_s > 0.0 ? 1.0 / least_time_s : no_bound, acceleration = no_bound, jerk = no_bound;
  for (int i = 0; i < axis_count; ++i) {
    const double most = std::max(std::abs(all.first_low[i]), std::abs(all.first_high[i]));
    if (most <= 0.0) continue;
    speed = std::min(speed, limits.velocity[i] / most);
    acceleration = std::min(acceleration, limits.acceleration[i] / most);
    jerk = std::min(jerk, limits.jerk[i] / most);
  }
  SCurveShape best = quickest_shape(speed, acceleration, jerk);
  if (all.second_low.isZero(0.0) && all.second_high.isZero(0.0)) {
    law_ = SCurve(best.jerk_share, best.even_share);
    return;
  }
  const auto time_of = [&](const SCurveShape& shape) {
    return duration(SCurve(shape.jerk_share, shape.even_share), limits, least_time_s, points_of_a_phase, true).time_s;
  };
  double least = time_of(best);
  double step = 0.1;
  for (int halving = 0; halving < halvings;) {
    const SCurveShape now = best;
    for (const auto& [jerk_step, even_step] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
      const SCurveShape shape{std::clamp(now.jerk_share + jerk_step, 0.01, 1.0),
                              std::clamp(now.even_share + even_step, 0.0, 1.0)};
      const double time = time_of(shape);
      if (time >= least * (1.0 - 1e-6)) continue;
      least = time;
      best = shape;
    }
    if (best.jerk_share == now.jerk_share && best.even_share == now.even_share) {
      step *= 0.5;
      ++halving;
    }
  }
  law_ = SCurve(best.jerk_share, best.even_share);
}

}  // namespace volute::sim
