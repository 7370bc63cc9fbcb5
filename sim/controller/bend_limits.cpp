#include "sim/controller/bend_limits.hpp"

#include <algorithm>
#include <cmath>

namespace volute::sim {

namespace {
using kinematics::axis_count;
/// Where the start (or the end) speed cancels out of a bound, what is left of it is rounding: it is taken as not there.
/// The bounds themselves stand this much under the axes' limits and more (MotionLimits), so that nothing is lost.
constexpr double negligible = 1e-9;

void drop_rounding(double& weight, double other) {
  if (std::abs(weight) < negligible * std::abs(other)) weight = 0.0;
}
}  // namespace

// u = (x1 - x0) / (2 length). At the start the axis accelerates by curvature x0 + rate u, at the end by curvature x1 +
// end rate u.
BendLimits::BendLimits(const PathCell& cell) {
  const double half = 0.5 / cell.length;
  for (int i = 0; i < axis_count; ++i) {
    const double scale = 1.0 / cell.limits->acceleration[static_cast<std::size_t>(i)];
    const double bend = cell.curvature[i] * scale;
    const double start_rate = cell.rate[i] * half * scale;
    const double end_rate = (cell.rate[i] + cell.length * cell.curvature[i]) * half * scale;
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(i + axis_count);
    from_weight_[a] = bend - start_rate;
    to_weight_[a] = start_rate;
    from_weight_[b] = -end_rate;
    to_weight_[b] = bend + end_rate;
  }
  for (std::size_t j = 0; j < from_weight_.size(); ++j) {
    drop_rounding(from_weight_[j], to_weight_[j]);
    drop_rounding(to_weight_[j], from_weight_[j]);
  }
}

void BendLimits::make_lines() {
  if (lines_made_) return;
  lines_made_ = true;
  for (std::size_t j = 0; j < from_weight_.size(); ++j) {
    const double weight = from_weight_[j];
    if (weight != 0.0) {
      at_zero_[j] = 1.0 / std::abs(weight);
      slope_[j] = -to_weight_[j] / weight;
      continue;
    }
    at_zero_[j] = no_limit;
    slope_[j] = 0.0;
    if (to_weight_[j] != 0.0) end_sq_max_ = std::min(end_sq_max_, 1.0 / std::abs(to_weight_[j]));
  }
}

bool BendLimits::hold(double start_sq, double end_sq) const {
  for (std::size_t j = 0; j < count; ++j)
    if (!(std::abs(from_weight_[j] * start_sq + to_weight_[j] * end_sq) <= 1.0)) return false;
  return true;
}

/// The lowest of the upper bounds on x0 at this x1; of two that meet there the one that falls.
BendLimits::Line BendLimits::lowest_upper(double end_sq) const {
  std::size_t best = 0;
  double least = at_zero_[0] + slope_[0] * end_sq;
  for (std::size_t j = 1; j < at_zero_.size(); ++j) {
    const double value = at_zero_[j] + slope_[j] * end_sq;
    if (value > least || (value == least && slope_[j] >= slope_[best])) continue;
    least = value;
    best = j;
  }
  if (!std::isfinite(least)) return {no_limit, 0.0, -1};
  return {at_zero_[best], slope_[best], axis_of(best)};
}

BendLimits::Line BendLimits::highest_lower(double end_sq) const {
  std::size_t best = 0;
  double greatest = -at_zero_[0] + slope_[0] * end_sq;
  for (std::size_t j = 1; j < at_zero_.size(); ++j) {
    const double value = -at_zero_[j] + slope_[j] * end_sq;
    if (value <= greatest) continue;
    greatest = value;
    best = j;
  }
  return {-at_zero_[best], slope_[best], axis_of(best)};
}

// Between the lowest upper and the highest lower bound on x0 there is room up to some x1; the room is concave in x1, so
// Newton's steps from beyond come down to its end without passing it.
double BendLimits::greatest_feasible_end(double end_sq_max) const {
  double end_sq = std::min(end_sq_max, end_sq_max_);
  for (std::size_t step = 0; step < 2 * count; ++step) {
    const Line upper = lowest_upper(end_sq), lower = highest_lower(end_sq);
    if (upper.axis < 0 || upper.at(end_sq) >= lower.at(end_sq)) break;
    end_sq = (upper.at_zero - lower.at_zero) / (lower.slope - upper.slope) * (1.0 - 1e-15);
  }
  return end_sq;
}

// The bound is concave in x1: if it still rises at the greatest x1, that is the best; else two lines, one rising and
// one falling, are brought together until they meet on the bound.
BendLimits::Answer BendLimits::greatest_start(double end_sq_max, double start_sq_max) {
  // At an even feed the limit of the start itself decides.
  if (hold(start_sq_max, end_sq_max) || hold(start_sq_max, std::min(start_sq_max, end_sq_max)))
    return {start_sq_max, -1};
  make_lines();
  const double end_max = greatest_feasible_end(end_sq_max);
  const auto answer = [&](double sq, int axis) {
    return sq < start_sq_max ? Answer{sq, axis} : Answer{start_sq_max, -1};
  };
  Line falling = lowest_upper(end_max);
  if (falling.axis < 0 || falling.slope >= 0.0) return answer(falling.at(end_max), falling.axis);
  Line rising = lowest_upper(0.0);
  if (rising.slope <= 0.0) return answer(rising.at_zero, rising.axis);
  double best = falling.at(end_max);
  for (std::size_t turn = 0; turn < 2 * count; ++turn) {
    const double meet = (falling.at_zero - rising.at_zero) / (rising.slope - falling.slope);
    const Line lowest = lowest_upper(meet);
    best = lowest.at(meet);
    if (best >= rising.at(meet) * (1.0 - 1e-14)) break;
    (lowest.slope > 0.0 ? rising : falling) = lowest;
  }
  return answer(best, falling.axis);
}

BendLimits::Answer BendLimits::greatest_end(double start_sq, double end_sq_max) const {
  Answer answer{end_sq_max, -1};
  if (hold(start_sq, end_sq_max)) return answer;
  for (std::size_t j = 0; j < to_weight_.size(); ++j) {
    const double weight = to_weight_[j];
    if (weight == 0.0) continue;
    const double one = weight > 0.0 ? 1.0 + negligible : -1.0 - negligible;
    const double bound = (one - from_weight_[j] * start_sq) / weight;
    if (bound < answer.sq) answer = {std::max(0.0, bound), axis_of(j)};
  }
  return answer;
}

}  // namespace volute::sim
