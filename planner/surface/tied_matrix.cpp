#include "planner/surface/tied_matrix.hpp"

#include "geometry/check.hpp"
#include "planner/surface/sparse_columns.hpp"

namespace volute::planner {

Ties::Ties(std::span<const int> unknown, int count)
    : unknown_(unknown.begin(), unknown.end()), start_(static_cast<std::size_t>(count) + 1, 0) {
  for (const int u : unknown_) {
    VOLUTE_CHECK(u < count, u, count);
    if (u >= 0) ++start_[static_cast<std::size_t>(u) + 1];
  }
  for (std::size_t u = 1; u < start_.size(); ++u) start_[u] += start_[u - 1];
  vertex_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t v = 0; v < unknown_.size(); ++v) {
    if (unknown_[v] >= 0) vertex_[next[static_cast<std::size_t>(unknown_[v])]++] = static_cast<int>(v);
  }
}

SparseMatrix tied_columns(const SparseMatrix& matrix, const Ties& ties) {
  return by_columns(matrix.rows(), ties.count(), [&](Eigen::Index u, ColumnSum& sum) {
    for (const int v : ties.vertices(u)) {
      for (SparseMatrix::InnerIterator it(matrix, v); it; ++it) sum.add(static_cast<int>(it.row()), it.value());
    }
  });
}

SparseMatrix tied(const SparseMatrix& matrix, const Ties& ties) {
  // R^T matrix first, then the columns: sums of sums where unknowns are shared by several vertices.
  const SparseMatrix rows = by_columns(ties.count(), matrix.cols(), [&](Eigen::Index v, ColumnSum& sum) {
    for (SparseMatrix::InnerIterator it(matrix, v); it; ++it) {
      if (const int u = ties.unknown(it.row()); u >= 0) sum.add(u, it.value());
    }
  });
  return tied_columns(rows, ties);
}

Eigen::VectorXd tied(const Eigen::VectorXd& vector, const Ties& ties) {
  Eigen::VectorXd out(ties.count());
  for (Eigen::Index u = 0; u < out.size(); ++u) {
    double sum = 0.0;
    for (const int v : ties.vertices(u)) sum += vector[v];
    out[u] = sum;
  }
  return out;
}

SparseMatrix plus_square(const SparseMatrix& first, const SparseMatrix& root, const Eigen::VectorXd& weight) {
  VOLUTE_CHECK(first.cols() == root.cols() && weight.size() == root.rows(), first.cols(), root.cols(), weight.size());
  using ByRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  const ByRows by_rows(root);
  return by_columns(first.rows(), first.cols(), [&](Eigen::Index c, ColumnSum& sum) {
    for (SparseMatrix::InnerIterator right(root, c); right; ++right) {
      const Eigen::Index k = right.row();
      for (ByRows::InnerIterator left(by_rows, k); left; ++left)
        sum.add(static_cast<int>(left.col()), left.value() * weight[k] * right.value());
    }
    for (SparseMatrix::InnerIterator it(first, c); it; ++it) sum.add(static_cast<int>(it.row()), it.value());
  });
}

}  // namespace volute::planner
