// Direct solution of sparse symmetric positive definite systems: CHOLMOD's supernodal L L^T under AMD ordering.
#pragma once

#include <memory>
#include <span>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "geometry/result.hpp"

namespace volute::planner {

using geometry::Result;

/// A factorisation that solves for many right-hand sides. BLAS is held to one thread: the same bytes on any number of
/// threads, and the blocks of a surface's system are too small to gain from more. Properties: 1. |A x - b| is of the
/// order of rounding. 2. refactor() with the same pattern gives what a new factor() gives.
/// 3. Solving columns together equals solving them one by one.
class SparseSolver {
 public:
  /// Requires: matrix square and symmetric, both halves stored, compressed.
  /// Errors (bad_input): matrix-not-positive-definite, naming the size. Errors (system): matrix-too-large (memory).
  static Result<SparseSolver> factor(const Eigen::SparseMatrix<double>& matrix);
  ~SparseSolver();
  SparseSolver(SparseSolver&&) noexcept;
  SparseSolver& operator=(SparseSolver&&) noexcept;

  /// New numbers in the same pattern: keeps the symbolic analysis. Requires: the pattern of factor(). Errors as
  /// factor().
  Result<void> refactor(const Eigen::SparseMatrix<double>& matrix);

  /// Not for two threads at once on one object. Requires: right_side.size() rows of the matrix.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;
  /// One column a right-hand side.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right_sides) const;

 private:
  struct Factor;
  explicit SparseSolver(std::unique_ptr<Factor> factor);
  std::unique_ptr<Factor> factor_;
};

/// u with matrix u = right_side (0 if empty) at the free rows and u = values at the fixed ones: Dirichlet conditions.
/// Requires: fixed rows distinct. Errors: as SparseSolver::factor.
Result<Eigen::MatrixXd> solve_with_fixed(const Eigen::SparseMatrix<double>& matrix, std::span<const int> fixed,
                                         const Eigen::MatrixXd& values, const Eigen::MatrixXd& right_side = {});

}  // namespace volute::planner
