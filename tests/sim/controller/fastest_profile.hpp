// The fastest speed profile along a path as a convex program: an oracle that shares no idea with the planner's two
// sweeps.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "sim/controller/path_cells.hpp"

namespace volute::sim::test {

/// Unknowns x_k = (ds/dt)^2 at the knots of a grid, x = 0 at both ends. Minimizes the time sum 2 d / (sqrt x_k + sqrt
/// x_(k+1)) under |curvature x + rate (x_(k+1) - x_k) / 2 d| <= a at both ends of every interval and x <= x_max, by
/// logarithmic barriers and Newton steps on a tridiagonal system.
class FastestProfile {
 public:
  FastestProfile(const std::vector<PathCell>& cells, int per_bend, int per_straight) {
    for (const PathCell& cell : cells) {
      const int count = cell.straight ? per_straight : per_bend;
      for (int i = 0; i < count; ++i) add_interval(cell, i, count);
    }
    cap_.back() = 0.0;
    x_.assign(cap_.size(), 0.0);
    for (std::size_t k = 1; k + 1 < x_.size(); ++k) x_[k] = 1e-4;
  }

  double solve() {
    double weight = 1.0;
    const double relations = static_cast<double>(rows_.size() * 2 + cap_.size());
    for (;; weight *= 8.0) {
      for (int step = 0; step < 200; ++step)
        if (newton(weight) < 1e-9) break;
      if (relations / weight < 2e-4 * time()) return time();
    }
  }

 private:
  struct Row {
    std::size_t k;    ///< between knots k and k + 1
    double from, to;  ///< |from x_k + to x_(k+1)| <= 1
  };

  void add_interval(const PathCell& cell, int i, int count) {
    const double d = cell.length / count, s = d * i;
    if (cap_.empty()) cap_.push_back(0.0);
    cap_.back() = cap_.size() == 1 ? 0.0 : std::min(cap_.back(), cell.speed_sq_max);
    const std::size_t k = length_.size();
    length_.push_back(d);
    cap_.push_back(cell.speed_sq_max);
    for (int axis = 0; axis < kinematics::axis_count; ++axis) {
      const double a = cell.limits->acceleration[static_cast<std::size_t>(axis)];
      const double bend = cell.curvature[axis] / a;
      const double rate0 = (cell.rate[axis] + s * cell.curvature[axis]) / (2.0 * d * a);
      const double rate1 = (cell.rate[axis] + (s + d) * cell.curvature[axis]) / (2.0 * d * a);
      rows_.push_back({k, bend - rate0, rate0});
      if (bend != 0.0) rows_.push_back({k, -rate1, bend + rate1});
    }
  }

  [[nodiscard]] double time() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < length_.size(); ++k)
      sum += 2.0 * length_[k] / (std::sqrt(x_[k]) + std::sqrt(x_[k + 1]));
    return sum;
  }

  [[nodiscard]] double merit(double weight, const std::vector<double>& x) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < length_.size(); ++k)
      sum += weight * 2.0 * length_[k] / (std::sqrt(x[k]) + std::sqrt(x[k + 1]));
    for (std::size_t k = 1; k + 1 < x.size(); ++k) {
      if (x[k] <= 0.0 || x[k] >= cap_[k]) return INFINITY;
      if (std::isfinite(cap_[k])) sum -= std::log(1.0 - x[k] / cap_[k]);
    }
    for (const Row& row : rows_) {
      const double value = row.from * x[row.k] + row.to * x[row.k + 1];
      if (std::abs(value) >= 1.0) return INFINITY;
      sum -= std::log(1.0 - value * value);
    }
    return sum;
  }

  void add_time_terms(double weight) {
    for (std::size_t k = 0; k < length_.size(); ++k) {
      const double d = weight * length_[k], p = std::sqrt(x_[k]), q = std::sqrt(x_[k + 1]), r = p + q;
      const auto one = [&](std::size_t at, double own) {
        if (own <= 0.0) return;
        gradient_[at] -= d / (own * r * r);
        diagonal_[at] += d / (2.0 * own) * (1.0 / (own * own * r * r) + 2.0 / (own * r * r * r));
      };
      one(k, p);
      one(k + 1, q);
      if (p > 0.0 && q > 0.0) beside_[k] += d / (p * q * r * r * r);
    }
  }

  void add_barrier_terms() {
    for (std::size_t k = 1; k + 1 < x_.size(); ++k) {
      if (!std::isfinite(cap_[k])) continue;
      const double room = cap_[k] - x_[k];
      gradient_[k] += 1.0 / room;
      diagonal_[k] += 1.0 / (room * room);
    }
    for (const Row& row : rows_) {
      const double value = row.from * x_[row.k] + row.to * x_[row.k + 1], room = 1.0 - value * value;
      const double slope = 2.0 * value / room, bend = 2.0 / room + slope * slope;
      gradient_[row.k] += slope * row.from;
      gradient_[row.k + 1] += slope * row.to;
      diagonal_[row.k] += bend * row.from * row.from;
      diagonal_[row.k + 1] += bend * row.to * row.to;
      beside_[row.k] += bend * row.from * row.to;
    }
  }

  /// One damped Newton step; returns half the squared decrement.
  double newton(double weight) {
    const std::size_t n = x_.size();
    gradient_.assign(n, 0.0);
    diagonal_.assign(n, 0.0);
    beside_.assign(n, 0.0);
    add_time_terms(weight);
    add_barrier_terms();
    std::vector<double> step(n, 0.0), pivot(n, 0.0), right(n, 0.0);
    for (std::size_t k = 1; k + 1 < n; ++k) {
      const double factor = k > 1 ? beside_[k - 1] / pivot[k - 1] : 0.0;
      pivot[k] = diagonal_[k] - (k > 1 ? factor * beside_[k - 1] : 0.0);
      right[k] = -gradient_[k] - (k > 1 ? factor * right[k - 1] : 0.0);
    }
    for (std::size_t k = n - 2; k >= 1; --k)
      step[k] = (right[k] - (k + 2 < n ? beside_[k] * step[k + 1] : 0.0)) / pivot[k];
    double slope = 0.0;
    for (std::size_t k = 1; k + 1 < n; ++k) slope += gradient_[k] * step[k];
    const double now = merit(weight, x_);
    for (double share = 1.0; share > 1e-12; share *= 0.5) {
      std::vector<double> trial = x_;
      for (std::size_t k = 1; k + 1 < n; ++k) trial[k] += share * step[k];
      if (merit(weight, trial) > now + 0.1 * share * slope) continue;
      x_ = trial;
      break;
    }
    return -0.5 * slope;
  }

  std::vector<double> length_, cap_, x_, gradient_, diagonal_, beside_;
  std::vector<Row> rows_;
};

/// The least time (s) from rest to rest, to 0.02 %.
inline double fastest_time(const std::vector<PathCell>& cells, int per_bend, int per_straight) {
  return FastestProfile(cells, per_bend, per_straight).solve();
}

}  // namespace volute::sim::test
