#include "planner/path/path_spline.hpp"

#include <algorithm>
#include <array>

#include "geometry/check.hpp"

namespace volute::planner {

namespace {

constexpr Eigen::Index band = 4;  ///< half width of the normal matrix, diagonal included

/// The knot span that holds x: knots[s] <= x < knots[s + 1], the last span closed.
std::size_t span_of(const std::vector<double>& knots, double x) {
  const auto last = knots.end() - 4;
  const auto above = std::upper_bound(knots.begin() + 3, last, x);
  return static_cast<std::size_t>((above == last ? last - 1 : above - 1) - knots.begin());
}

/// The basis functions of a degree that do not vanish on span s, at x (Cox, de Boor); the first is N_{s - Degree}.
template <std::size_t Degree>
std::array<double, Degree + 1> basis(const std::vector<double>& knots, std::size_t s, double x) {
  std::array<double, Degree + 1> n{1.0}, left{}, right{};
  for (std::size_t j = 1; j <= Degree; ++j) {
    left[j] = x - knots[s + 1 - j];
    right[j] = knots[s + j] - x;
    double saved = 0.0;
    for (std::size_t r = 0; r < j; ++r) {
      const double share = n[r] / (right[r + 1] + left[j - r]);
      n[r] = saved + right[r + 1] * share;
      saved = left[j - r] * share;
    }
    n[j] = saved;
  }
  return n;
}

/// A symmetric positive definite band matrix, lower half by diagonals, and its solution in place (L D L^T).
struct BandSystem {
  using Rows =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, Eigen::Dynamic, PathSpline::columns_max>;
  Eigen::Matrix<double, Eigen::Dynamic, band, Eigen::RowMajor> lower;  ///< lower(i, d) = A(i, i - d)
  Rows right;

  BandSystem(Eigen::Index rows, Eigen::Index columns)
      : lower(Eigen::MatrixXd::Zero(rows, band)), right(Rows::Zero(rows, columns)) {}

  template <std::size_t N>
  void add_square(std::size_t first, const std::array<double, N>& row, double weight) {
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        lower(static_cast<Eigen::Index>(first + i), static_cast<Eigen::Index>(i - j)) += weight * row[i] * row[j];
  }

  Rows solve() {
    const Eigen::Index n = lower.rows();
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index d = std::min(i, band - 1); d >= 0; --d) {
        const Eigen::Index j = i - d;
        double sum = lower(i, d);
        for (Eigen::Index e = d + 1; e < band && i - e >= 0; ++e)
          sum -= lower(i, e) * lower(j, e - d) * lower(i - e, 0);
        lower(i, d) = d == 0 ? sum : sum / lower(j, 0);
      }
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index d = 1; d < band && i - d >= 0; ++d) right.row(i) -= lower(i, d) * right.row(i - d);
    for (Eigen::Index i = 0; i < n; ++i) right.row(i) /= lower(i, 0);
    for (Eigen::Index i = n; i-- > 0;)
      for (Eigen::Index d = 1; d < band && i + d < n; ++d) right.row(i) -= lower(i + d, d) * right.row(i + d);
    return right;
  }
};

}  // namespace

PathSpline::PathSpline(std::span<const double> parameter, const Eigen::MatrixXd& values, std::span<const double> weight,
                       std::vector<double> knots, double fairness) {
  VOLUTE_CHECK(parameter.size() >= 2 && values.rows() == static_cast<Eigen::Index>(parameter.size()), parameter.size());
  VOLUTE_CHECK(values.cols() <= columns_max, values.cols());
  VOLUTE_CHECK(knots.size() >= 2 && weight.size() == parameter.size(), knots.size(), weight.size());
  knots_.assign(3, knots.front());
  knots_.insert(knots_.end(), knots.begin(), knots.end());
  knots_.insert(knots_.end(), 3, knots.back());
  BandSystem system(static_cast<Eigen::Index>(knots_.size() - 4), values.cols());
  double weight_sum = 0.0;
  for (double w : weight) weight_sum += w;
  for (std::size_t i = 0; i < parameter.size(); ++i) {
    const std::size_t s = span_of(knots_, parameter[i]);
    const auto n = basis<3>(knots_, s, parameter[i]);
    const bool end = i == 0 || i + 1 == parameter.size();
    const double w = end ? 1e6 * weight_sum / static_cast<double>(parameter.size()) : weight[i];
    system.add_square(s - 3, n, w);
    for (std::size_t k = 0; k < 4; ++k)
      system.right.row(static_cast<Eigen::Index>(s - 3 + k)) += w * n[k] * values.row(static_cast<Eigen::Index>(i));
  }
  const std::array<double, 4> third{-1.0, 3.0, -3.0, 1.0};
  const auto controls = static_cast<std::size_t>(system.lower.rows());
  const double fair = fairness * weight_sum / static_cast<double>(controls);
  for (std::size_t i = 0; i + 4 <= controls; ++i) system.add_square(i, third, fair);
  control_ = system.solve();
}

PathSpline::Row PathSpline::value(double parameter) const {
  const std::size_t s = span_of(knots_, parameter);
  const auto n = basis<3>(knots_, s, parameter);
  Row sum = Row::Zero(control_.cols());
  for (std::size_t k = 0; k < 4; ++k) sum += n[k] * control_.row(static_cast<Eigen::Index>(s - 3 + k));
  return sum;
}

PathSpline::Row PathSpline::derivative(double parameter) const {
  const std::size_t s = span_of(knots_, parameter);
  const auto n = basis<2>(knots_, s, parameter);  // the derivative is the quadratic B-spline of the differences
  Row sum = Row::Zero(control_.cols());
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = s - 3 + k;
    const Row step = control_.row(static_cast<Eigen::Index>(i + 1)) - control_.row(static_cast<Eigen::Index>(i));
    sum += n[k] * 3.0 / (knots_[i + 4] - knots_[i + 1]) * step;
  }
  return sum;
}

}  // namespace volute::planner
