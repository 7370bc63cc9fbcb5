// Matrices of a mesh's vertices of which some share an unknown and others are held.
#pragma once

#include <span>
#include <vector>

#include "planner/surface/operators.hpp"

namespace volute::planner {

/// The 0/1 matrix R with R(v, u) = 1 where vertex v has the unknown u.
class Ties {
 public:
  /// `unknown` per vertex: below 0 where it has none. Requires: each below `count`.
  Ties(std::span<const int> unknown, int count);

  [[nodiscard]] int count() const { return static_cast<int>(start_.size()) - 1; }
  /// Below 0: none.
  [[nodiscard]] int unknown(Eigen::Index vertex) const { return unknown_[static_cast<std::size_t>(vertex)]; }
  /// Vertices of an unknown, ascending.
  [[nodiscard]] std::span<const int> vertices(Eigen::Index unknown) const {
    const auto u = static_cast<std::size_t>(unknown);
    return std::span(vertex_).subspan(start_[u], start_[u + 1] - start_[u]);
  }

 private:
  std::vector<int> unknown_, vertex_;
  std::vector<std::size_t> start_;
};

// Sums are taken in the order of Eigen's products, so that these give the same bytes as R written out.
// Property: 1. Each equals the product with R written out, bit by bit.

/// matrix R. Requires: as many columns as vertices.
SparseMatrix tied_columns(const SparseMatrix& matrix, const Ties& ties);
/// R^T matrix R. Requires: square, as many columns as vertices.
SparseMatrix tied(const SparseMatrix& matrix, const Ties& ties);
/// R^T vector.
Eigen::VectorXd tied(const Eigen::VectorXd& vector, const Ties& ties);
/// first + root^T diag(weight) root. Requires: as many columns in both, a weight a row of root.
SparseMatrix plus_square(const SparseMatrix& first, const SparseMatrix& root, const Eigen::VectorXd& weight);

}  // namespace volute::planner
