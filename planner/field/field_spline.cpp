#include "planner/field/field_spline.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::planner {

namespace {

constexpr int degree = 3;

/// Values at the data sites times control points = data; one row a site.
Eigen::MatrixXd collocation(const std::vector<double>& knots, int points, int intervals, bool closed) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(points, points);
  for (int i = 0; i < points; ++i) {
    const CubicBasis basis = cubic_basis(knots, static_cast<double>(i) / intervals);
    for (int k = 0; k <= degree; ++k)
      matrix(i, closed ? (basis.first + k) % points : basis.first + k) += basis.values[k];
  }
  return matrix;
}

/// Control points of many curves at once: columns are curves.
Eigen::MatrixXd interpolate(const std::vector<double>& knots, int intervals, bool closed, const Eigen::MatrixXd& data) {
  return collocation(knots, static_cast<int>(data.rows()), intervals, closed).partialPivLu().solve(data);
}

}  // namespace

std::vector<double> open_knots(int intervals, KnotRule rule) {
  VOLUTE_CHECK(intervals >= degree, intervals);
  std::vector<double> knots(degree + 1, 0.0);
  for (int j = 1; j <= intervals - degree; ++j)
    knots.push_back(rule == KnotRule::eq3 ? static_cast<double>(j) / (intervals - degree + 1)
                                          : (j + 0.5 * (degree - 1)) / intervals);
  knots.insert(knots.end(), degree + 1, 1.0);
  return knots;
}

std::vector<double> closed_knots(int intervals) {
  std::vector<double> knots;
  for (int j = -degree; j <= intervals + degree; ++j) knots.push_back(static_cast<double>(j) / intervals);
  return knots;
}

CubicBasis cubic_basis(const std::vector<double>& knots, double t) {
  const auto last_span = static_cast<int>(knots.size()) - degree - 2;
  const auto above = std::upper_bound(knots.begin() + degree, knots.begin() + last_span + 1, t);
  const int span = std::clamp(static_cast<int>(above - knots.begin()) - 1, degree, last_span);
  CubicBasis basis{span - degree, {1.0, 0.0, 0.0, 0.0}};
  for (int d = 1; d <= degree; ++d) {
    double carried = 0.0;
    for (int k = 0; k < d; ++k) {
      const double right = knots[static_cast<std::size_t>(span + k + 1)],
                   left = knots[static_cast<std::size_t>(span + k + 1 - d)];
      const double share = basis.values[k] / (right - left);
      basis.values[k] = carried + (right - t) * share;
      carried = (t - left) * share;
    }
    basis.values[d] = carried;
  }
  return basis;
}

FieldSpline::FieldSpline(const std::function<Vec3(const Vec2&)>& sample, const FieldSplineOptions& options)
    : options_(options),
      u_knots_(open_knots(options.u_intervals, options.knots)),
      v_knots_(options.v_closed ? closed_knots(options.v_intervals) : open_knots(options.v_intervals, options.knots)) {
  const int rows = options.u_intervals + 1;
  const int columns = options.v_closed ? options.v_intervals : options.v_intervals + 1;
  VOLUTE_CHECK(columns > degree, columns);
  Eigen::MatrixXd data(rows, 3 * columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      data.block<1, 3>(i, 3 * j) =
          sample({static_cast<double>(i) / options.u_intervals, static_cast<double>(j) / options.v_intervals});
  const Eigen::MatrixXd along_u = interpolate(u_knots_, options.u_intervals, false, data);
  Eigen::MatrixXd turned(columns, 3 * rows);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) turned.block<1, 3>(j, 3 * i) = along_u.block<1, 3>(i, 3 * j);
  const Eigen::MatrixXd along_v = interpolate(v_knots_, options.v_intervals, options.v_closed, turned);
  control_.assign(static_cast<std::size_t>(rows), std::vector<Vec3>(static_cast<std::size_t>(columns)));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      control_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = along_v.block<1, 3>(j, 3 * i);
}

Vec3 FieldSpline::value(const Vec2& uv) const {
  const double v = options_.v_closed ? uv.y() - std::floor(uv.y()) : std::clamp(uv.y(), 0.0, 1.0);
  const CubicBasis in_u = cubic_basis(u_knots_, std::clamp(uv.x(), 0.0, 1.0));
  const CubicBasis in_v = cubic_basis(v_knots_, v);
  const std::size_t columns = control_.front().size();
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      sum += in_u.values[i] * in_v.values[j] *
             control_[static_cast<std::size_t>(in_u.first + i)][static_cast<std::size_t>(in_v.first + j) % columns];
  return sum;
}

}  // namespace volute::planner
