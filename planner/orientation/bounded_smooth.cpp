#include "planner/orientation/bounded_smooth.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "planner/orientation/banded.hpp"

// Notation. c: coefficients; y = S c: what a family of rows bounds, c itself or its differences over their limits;
// low <= y <= high, with -t and t for differences; s: slacks (kept apart from y, so that a start need not be inside);
// missing: bound - y - s; z: multipliers; w = z / s; mu: barrier parameter.
// Newton on P c + q + sum S^T (z_high - z_low) = 0, price - sum (z_high + z_low) + z_top = 0, s z = target.
namespace volute::planner {

namespace {

constexpr int band = 3;
constexpr int newton_steps_max = 60;
constexpr double complementarity_share = 1e-9, residual_share = 1e-8;
constexpr double boundary_share = 0.995;
constexpr double least_slack_share = 0.05;
constexpr double first_scale = 0.95;
// Where the start has no energy at all.
constexpr double least_unit = 1e-12;

using Band = BandMatrix<band>;
using Values = std::vector<double>;

struct Stencil {
  std::size_t width = 1;
  std::array<double, 4> at{};
};
constexpr std::array<Stencil, 4> differences = {Stencil{1, {1.0}}, Stencil{2, {-1.0, 1.0}},
                                                Stencil{3, {1.0, -2.0, 1.0}}, Stencil{4, {-1.0, 3.0, -3.0, 1.0}}};

/// Adds weight (stencil c)^2 at place i to the matrix of the quadratic form c^T P c.
void add_square(Band& matrix, std::size_t i, const Stencil& stencil, double weight) {
  for (std::size_t a = 0; a < stencil.width; ++a) {
    for (std::size_t b = 0; b <= a; ++b) matrix[i + a][a - b] += weight * stencil.at[a] * stencil.at[b];
  }
}

Values multiplied(const Band& matrix, const Values& x) {
  Values y(x.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    y[i] += matrix[i][0] * x[i];
    for (std::size_t j = 1; j <= band && j <= i; ++j) {
      y[i] += matrix[i][j] * x[i - j];
      y[i - j] += matrix[i][j] * x[i];
    }
  }
  return y;
}

double dot(const Values& a, const Values& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// The quadratic form c^T P c / 2 + q^T c, and the energy of the start without what holds values.
struct Quadratic {
  Band matrix;
  Values linear;
  double energy = 0.0;
};

Quadratic quadratic_of(const SmoothProblem& problem) {
  const std::size_t n = problem.lower.size();
  Quadratic form{Band(n, {0.0, 0.0, 0.0, 0.0}), Values(n, 0.0)};
  const double h = problem.weights.step_mm, l_sq = problem.weights.length_mm * problem.weights.length_mm;
  const std::array<double, 4> weight = {0.0, 1.0 / h, l_sq / (h * h * h), l_sq * l_sq / (h * h * h * h * h)};
  for (std::size_t k = 1; k < 4; ++k) {
    for (std::size_t i = 0; i + k < n; ++i) add_square(form.matrix, i, differences[k], weight[k]);
  }
  const Values start(problem.start.begin(), problem.start.end());
  form.energy = 0.5 * dot(start, multiplied(form.matrix, start));
  for (std::size_t i = 0; i < problem.attraction.weight.size(); ++i) {
    const double pull = problem.attraction.weight[i], away = start[i] - problem.attraction.target[i];
    form.matrix[i][0] += pull;
    form.linear[i] -= pull * problem.attraction.target[i];
    form.energy += 0.5 * pull * away * away;
  }
  for (const HeldValue& held : problem.held) {
    const auto first = static_cast<std::size_t>(held.first);
    add_square(form.matrix, first, {4, held.share}, held.weight);
    for (std::size_t k = 0; k < 4; ++k) form.linear[first + k] -= held.weight * held.value * held.share[k];
  }
  return form;
}

/// One side of a family's rows: slacks, multipliers, what is missing, what their products should become, and a step.
struct Side {
  Values s, z, missing, target, ds, dz;

  void resize(std::size_t rows) {
    for (Values* values : {&s, &z, &missing, &target, &ds, &dz}) values->resize(rows, 0.0);
  }
  /// What the row pushes with, once its slack has taken up what is missing.
  [[nodiscard]] double push(std::size_t i) const { return (target[i] - z[i] * missing[i]) / s[i]; }
  void set_step(std::size_t i, double slack_change) {
    ds[i] = slack_change + missing[i];
    dz[i] = (target[i] - z[i] * ds[i]) / s[i] - z[i];
  }
  void aim(double mu, bool corrected) {
    for (std::size_t i = 0; i < s.size(); ++i) target[i] = mu - (corrected ? ds[i] * dz[i] : 0.0);
  }
  [[nodiscard]] double longest_step() const {
    double length = 1.0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (length * ds[i] < -s[i]) length = -s[i] / ds[i];
      if (length * dz[i] < -z[i]) length = -z[i] / dz[i];
    }
    return length;
  }
  [[nodiscard]] double product_after(double length) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < s.size(); ++i) sum += (s[i] + length * ds[i]) * (z[i] + length * dz[i]);
    return sum;
  }
  void advance(double length) {
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += length * ds[i], z[i] += length * dz[i];
  }
};

/// Rows that bound one kind of difference from both sides.
struct Family {
  Stencil stencil;
  std::span<const double> lower, upper;  ///< of c itself; differences: -t and t
  bool scaled = false;
  double t = 1.0;
  Side low, high, top;  ///< top: the one row t <= 1 of a scaled family
  Values column;        ///< what t does to the equations of c
  double stiffness = 0.0;

  [[nodiscard]] std::size_t rows() const { return low.s.size(); }
  [[nodiscard]] double value(const Values& c, std::size_t i) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < stencil.width; ++k) sum += stencil.at[k] * c[i + k];
    return sum;
  }
  [[nodiscard]] double high_at(std::size_t i) const { return scaled ? t : upper[i]; }
  [[nodiscard]] double low_at(std::size_t i) const { return scaled ? -t : lower[i]; }
  void add_transposed(std::size_t i, double v, Values& to) const {
    for (std::size_t k = 0; k < stencil.width; ++k) to[i + k] += v * stencil.at[k];
  }
  template <class Visit>
  void each_side(Visit visit) {
    visit(low), visit(high);
    if (scaled) visit(top);
  }
};

class InteriorPoint {
 public:
  explicit InteriorPoint(const SmoothProblem& problem)
      : problem_(problem), form_(quadratic_of(problem)), c_(problem.start.begin(), problem.start.end()) {
    const double unit = std::max(form_.energy, least_unit);
    for (auto& row : form_.matrix) {
      for (double& entry : row) entry /= unit;
    }
    for (double& entry : form_.linear) entry /= unit;
    add_families();
    start_slacks();
  }

  Values run() {
    for (int k = 0; k < newton_steps_max; ++k) {
      if (gap(0.0) < complementarity_share && residual_ < residual_share) break;
      if (!step()) break;
    }
    for (std::size_t i = 0; i < c_.size(); ++i) c_[i] = std::clamp(c_[i], problem_.lower[i], problem_.upper[i]);
    return c_;
  }

 private:
  void add_families();
  void start_slacks();
  /// The sum of all complementarity products after a step of this length, in units of the energy of the start.
  [[nodiscard]] double gap(double length);
  void assemble();
  void factor_scales();
  bool find_direction();
  [[nodiscard]] double longest_step();
  bool step();

  const SmoothProblem& problem_;
  Quadratic form_;
  Values c_, d_;
  std::vector<Family> families_;
  Band newton_;
  std::vector<Values> solved_;           ///< columns of the scales through the factors
  Eigen::LDLT<Eigen::MatrixXd> scales_;  ///< their Schur complement
  int products_ = 0;
  double residual_ = 1.0;
};

void InteriorPoint::add_families() {
  Family box;
  box.stencil = differences[0];
  box.lower = problem_.lower, box.upper = problem_.upper;
  families_.push_back(std::move(box));
  double step = 1.0;
  for (std::size_t k = 1; problem_.peaks && k < 4; ++k) {
    step *= problem_.weights.step_mm;
    Family family;
    family.stencil = differences[k];
    for (double& entry : family.stencil.at) entry /= problem_.peaks->most[k - 1] * step;
    family.scaled = true;
    families_.push_back(std::move(family));
  }
}

void InteriorPoint::start_slacks() {
  for (Family& f : families_) {
    const std::size_t rows = c_.size() + 1 - f.stencil.width;
    f.low.resize(rows), f.high.resize(rows);
    products_ += static_cast<int>(2 * rows) + (f.scaled ? 1 : 0);
    if (f.scaled) {
      f.t = first_scale;
      f.top.resize(1);
      f.top.s[0] = 1.0 - f.t;
      f.column.resize(c_.size());
    }
    for (std::size_t i = 0; i < rows; ++i) {
      const double y = f.value(c_, i), least = least_slack_share * (f.high_at(i) - f.low_at(i));
      f.low.s[i] = std::max(y - f.low_at(i), least);
      f.high.s[i] = std::max(f.high_at(i) - y, least);
    }
  }
  for (Family& f : families_) {
    f.each_side([&](Side& side) {
      for (std::size_t i = 0; i < side.s.size(); ++i) side.z[i] = 1.0 / (products_ * side.s[i]);
    });
  }
}

double InteriorPoint::gap(double length) {
  double sum = 0.0;
  for (Family& f : families_) f.each_side([&](const Side& side) { sum += side.product_after(length); });
  return sum;
}

/// The matrix of the Newton equations, factored, and what is missing in every row.
void InteriorPoint::assemble() {
  newton_ = form_.matrix;
  residual_ = 0.0;
  for (Family& f : families_) {
    f.stiffness = 0.0;
    std::fill(f.column.begin(), f.column.end(), 0.0);
    for (std::size_t i = 0; i < f.rows(); ++i) {
      const double y = f.value(c_, i), w_low = f.low.z[i] / f.low.s[i], w_high = f.high.z[i] / f.high.s[i];
      f.low.missing[i] = y - f.low_at(i) - f.low.s[i];
      f.high.missing[i] = f.high_at(i) - y - f.high.s[i];
      residual_ = std::max({residual_, std::abs(f.low.missing[i]), std::abs(f.high.missing[i])});
      add_square(newton_, i, f.stencil, w_low + w_high);
      if (!f.scaled) continue;
      f.stiffness += w_low + w_high;
      f.add_transposed(i, w_low - w_high, f.column);
    }
  }
  factor_banded<band>(newton_);
  factor_scales();
}

void InteriorPoint::factor_scales() {
  const Eigen::Index count = std::ssize(families_) - 1;
  if (count == 0) return;
  Eigen::MatrixXd schur = Eigen::MatrixXd::Zero(count, count);
  solved_.resize(static_cast<std::size_t>(count));
  for (Eigen::Index a = 0; a < count; ++a) {
    const Family& f = families_[static_cast<std::size_t>(a) + 1];
    solved_[static_cast<std::size_t>(a)] = f.column;
    solve_banded<band>(newton_, solved_[static_cast<std::size_t>(a)]);
    schur(a, a) = f.stiffness + f.top.z[0] / f.top.s[0];
  }
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < count; ++b)
      schur(a, b) -= dot(families_[static_cast<std::size_t>(a) + 1].column, solved_[static_cast<std::size_t>(b)]);
  }
  scales_.compute(schur);
}

/// The step towards the targets of the products. False when numbers ran out.
bool InteriorPoint::find_direction() {
  const std::size_t n = c_.size();
  d_ = multiplied(form_.matrix, c_);
  for (std::size_t i = 0; i < n; ++i) d_[i] = -d_[i] - form_.linear[i];
  Eigen::VectorXd right(std::ssize(families_) - 1);
  for (std::size_t k = 0; k < families_.size(); ++k) {
    const Family& f = families_[k];
    double sum = 0.0;
    for (std::size_t i = 0; i < f.rows(); ++i) {
      const double up = f.high.push(i), down = f.low.push(i);
      f.add_transposed(i, down - up, d_);
      sum += up + down;
    }
    if (f.scaled) right[static_cast<Eigen::Index>(k) - 1] = sum - problem_.peaks->price - f.top.push(0);
  }
  solve_banded<band>(newton_, d_);
  Eigen::VectorXd dt;
  if (right.size() > 0) {
    for (std::size_t k = 1; k < families_.size(); ++k)
      right[static_cast<Eigen::Index>(k) - 1] -= dot(families_[k].column, d_);
    dt = scales_.solve(right);
    for (std::size_t a = 0; a < solved_.size(); ++a) {
      for (std::size_t i = 0; i < n; ++i) d_[i] -= dt[static_cast<Eigen::Index>(a)] * solved_[a][i];
    }
  }
  for (std::size_t k = 0; k < families_.size(); ++k) {
    Family& f = families_[k];
    const double widening = f.scaled ? dt[static_cast<Eigen::Index>(k) - 1] : 0.0;
    for (std::size_t i = 0; i < f.rows(); ++i) {
      const double dy = f.value(d_, i);
      f.low.set_step(i, widening + dy);
      f.high.set_step(i, widening - dy);
    }
    if (f.scaled) f.top.set_step(0, -widening);
  }
  return std::all_of(d_.begin(), d_.end(), [](double value) { return std::isfinite(value); });
}

double InteriorPoint::longest_step() {
  double length = 1.0;
  for (Family& f : families_) f.each_side([&](const Side& side) { length = std::min(length, side.longest_step()); });
  return length;
}

/// Mehrotra: the step that aims at 0 says how much centring is needed and what its second order misses.
bool InteriorPoint::step() {
  assemble();
  const auto aim = [&](double mu, bool corrected) {
    for (Family& f : families_) f.each_side([&](Side& side) { side.aim(mu, corrected); });
  };
  aim(0.0, false);
  if (!find_direction()) return false;
  const double before = gap(0.0), share = gap(longest_step()) / before;
  aim(share * share * share * before / products_, true);
  if (!find_direction()) return false;
  const double length = std::min(1.0, boundary_share * longest_step());
  for (Family& f : families_) {
    f.each_side([&](Side& side) { side.advance(length); });
    if (f.scaled) f.t = 1.0 - f.top.s[0];
  }
  for (std::size_t i = 0; i < c_.size(); ++i) c_[i] += length * d_[i];
  return true;
}

}  // namespace

std::vector<double> smoothest_within(const SmoothProblem& problem) {
  const std::size_t n = problem.lower.size();
  VOLUTE_CHECK(n > 3 && problem.upper.size() == n && problem.start.size() == n, n, problem.upper.size(),
               problem.start.size());
  for (std::size_t i = 0; i < n; ++i)
    VOLUTE_CHECK(problem.lower[i] < problem.upper[i], i, problem.lower[i], problem.upper[i]);
  return InteriorPoint(problem).run();
}

}  // namespace volute::planner
