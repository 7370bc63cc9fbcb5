// Symmetric positive definite matrices with a narrow band: factor and solve by one sweep.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace volute::planner {

/// Row i holds the entries (i, i), (i, i - 1) ... (i, i - B); entries left of the first column are 0.
template <int B>
using BandMatrix = std::vector<std::array<double, static_cast<std::size_t>(B) + 1>>;

/// Replaces the matrix by its factors L D L^T: the diagonal holds 1 / D, below it stands L.
/// Requires: positive definite. Time O(n B^2), one division a row.
template <int B>
void factor_banded(BandMatrix<B>& matrix) {
  constexpr auto width = static_cast<std::size_t>(B);
  const std::size_t n = matrix.size();
  // What row i - j needs of its own: its unscaled entries d l.
  for (std::size_t i = 0; i < n; ++i) {
    auto& row = matrix[i];
    double diagonal = row[0];
    for (std::size_t j = width; j >= 1; --j) {
      if (j > i) continue;
      const auto& above = matrix[i - j];
      double value = row[j];
      // Columns shared by both rows, left of i - j; row[k] still holds d l for k > j.
      for (std::size_t k = j + 1; k <= width && k <= i; ++k) value -= row[k] * above[k - j];
      row[j] = value;
    }
    for (std::size_t j = 1; j <= width && j <= i; ++j) {
      const double l = row[j] * matrix[i - j][0];
      diagonal -= l * row[j];
      row[j] = l;
    }
    row[0] = 1.0 / diagonal;
  }
}

/// Solves with the factors, in place.
template <int B>
void solve_banded(const BandMatrix<B>& factors, std::span<double> right) {
  constexpr auto width = static_cast<std::size_t>(B);
  const std::size_t n = factors.size();
  for (std::size_t i = 0; i < n; ++i) {
    double value = right[i];
    for (std::size_t j = 1; j <= width && j <= i; ++j) value -= factors[i][j] * right[i - j];
    right[i] = value;
  }
  for (std::size_t i = n; i-- > 0;) {
    double value = right[i] * factors[i][0];
    for (std::size_t j = 1; j <= width && i + j < n; ++j) value -= factors[i + j][j] * right[i + j];
    right[i] = value;
  }
}

}  // namespace volute::planner
