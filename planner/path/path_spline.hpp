// A cubic B-spline through a chain of points that carries several values along ([Sun2016] eq. 18).
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace volute::planner {

/// Least-squares cubic B-spline on non-uniform knots, as many columns as the data has, up to `columns_max`.
class PathSpline {
 public:
  static constexpr int columns_max = 8;
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, columns_max>;  ///< without the heap

  /// `parameter` rises strictly; one row of `values` each; `weight` > 0 each; `knots` rises strictly from the first to
  /// the last parameter. Third differences of the control points are kept small with weight `fairness`, so that spans
  /// without data follow their neighbours. The ends are met exactly (up to 1e-9 of the data's size).
  PathSpline(std::span<const double> parameter, const Eigen::MatrixXd& values, std::span<const double> weight,
             std::vector<double> knots, double fairness);

  [[nodiscard]] Row value(double parameter) const;
  [[nodiscard]] Row derivative(double parameter) const;
  [[nodiscard]] double first() const { return knots_[3]; }
  [[nodiscard]] double last() const { return knots_[knots_.size() - 4]; }

 private:
  std::vector<double> knots_;  ///< clamped: four at each end
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, Eigen::Dynamic, columns_max> control_;
};

}  // namespace volute::planner
