#include "sim/controller/bend_limits.hpp"

#include <algorithm>
#include <cmath>

namespace volute::sim {

namespace {
constexpr int axes = kinematics::axis_count;
}

// u = (x1 - x0) / (2 length). At the start the axis accelerates by curvature x0 + rate u, at the end by curvature x1 +
// end rate u.
BendLimits::BendLimits(const PathCell& cell) {
  const double half = 0.5 / cell.length;
  for (int i = 0; i < axes; ++i) {
    const double scale = 1.0 / cell.limits->acceleration[static_cast<std::size_t>(i)];
    const double bend = cell.curvature[i] * scale;
    const double start_rate = cell.rate[i] * half * scale;
    const double end_rate = (cell.rate[i] + cell.length * cell.curvature[i]) * half * scale;
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(i + axes);
    from_weight_[a] = bend - start_rate;
    to_weight_[a] = start_rate;
    from_weight_[b] = -end_rate;
    to_weight_[b] = bend + end_rate;
  }
}

/// The lowest of the upper bounds on x0 at this x1, as a line in x1.
BendLimits::Line BendLimits::bound_at(double end_sq) const {
  Line lowest{no_limit, 0.0, -1};
  double least = no_limit;
  for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j) {
    const double weight = from_weight_[j];
    if (weight == 0.0) continue;
    const Line line{1.0 / std::abs(weight), -to_weight_[j] / weight, static_cast<int>(j) % axes};
    const double value = line.at_zero + line.slope * end_sq;
    if (value < least || (value == least && line.slope < lowest.slope)) {
      least = value;
      lowest = line;
    }
  }
  return lowest;
}

BendLimits::Bounds BendLimits::bounds_at(double end_sq) const {
  Bounds bounds{bound_at(end_sq), {-no_limit, 0.0, -1}};
  double greatest = -no_limit;
  for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j) {
    const double weight = from_weight_[j];
    if (weight == 0.0) continue;
    const Line line{-1.0 / std::abs(weight), -to_weight_[j] / weight, static_cast<int>(j) % axes};
    const double value = line.at_zero + line.slope * end_sq;
    if (value <= greatest) continue;
    greatest = value;
    bounds.lower = line;
  }
  return bounds;
}

// Between the lowest upper and the highest lower bound on x0 there is room up to some x1; the room is concave in x1, so
// Newton's steps from beyond come down to its end without passing it.
double BendLimits::greatest_feasible_end(double end_sq_max) const {
  double end_sq = end_sq_max;
  for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j)
    if (from_weight_[j] == 0.0 && std::abs(to_weight_[j]) * end_sq > 1.0) end_sq = 1.0 / std::abs(to_weight_[j]);
  for (int step = 0; step < 2 * count; ++step) {
    const Bounds bounds = bounds_at(end_sq);
    if (bounds.upper.axis < 0) break;
    const double room =
        bounds.upper.at_zero - bounds.lower.at_zero + (bounds.upper.slope - bounds.lower.slope) * end_sq;
    if (room >= 0.0) break;
    end_sq = (bounds.upper.at_zero - bounds.lower.at_zero) / (bounds.lower.slope - bounds.upper.slope) * (1.0 - 1e-15);
  }
  return end_sq;
}

// The bound is concave in x1: if it still rises at the greatest x1, that is the best; else two lines, one rising and
// one falling, are brought together until they meet on the bound.
BendLimits::Answer BendLimits::greatest_start(double end_sq_max, double start_sq_max) const {
  const double end_max = greatest_feasible_end(end_sq_max);
  const Line right = bound_at(end_max);
  if (right.axis < 0) return {start_sq_max, -1};
  double best = right.at_zero + right.slope * end_max;
  Line falling = right;
  // A rising line that still caps below start_sq_max at the greatest end speed: the end speed decides, not this cell.
  if (right.slope >= 0.0) return best < start_sq_max ? Answer{best, right.axis} : Answer{start_sq_max, -1};
  Line rising = bound_at(0.0);
  if (rising.slope <= 0.0)
    return rising.at_zero < start_sq_max ? Answer{rising.at_zero, rising.axis} : Answer{start_sq_max, -1};
  for (int turn = 0; turn < 2 * count; ++turn) {
    const double meet = (falling.at_zero - rising.at_zero) / (rising.slope - falling.slope);
    const double level = rising.at_zero + rising.slope * meet;
    const Line lowest = bound_at(meet);
    const double bound = lowest.at_zero + lowest.slope * meet;
    best = bound;
    if (bound >= level * (1.0 - 1e-14)) break;
    if (lowest.slope > 0.0)
      rising = lowest;
    else
      falling = lowest;
  }
  return best < start_sq_max ? Answer{best, falling.axis} : Answer{start_sq_max, -1};
}

BendLimits::Answer BendLimits::greatest_end(double start_sq, double end_sq_max) const {
  Answer answer{end_sq_max, -1};
  for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j) {
    const double weight = to_weight_[j];
    if (weight == 0.0) continue;
    const double bound =
        weight > 0.0 ? (1.0 - from_weight_[j] * start_sq) / weight : (-1.0 - from_weight_[j] * start_sq) / weight;
    if (bound < answer.sq) answer = {std::max(0.0, bound), static_cast<int>(j) % axes};
  }
  return answer;
}

}  // namespace volute::sim
