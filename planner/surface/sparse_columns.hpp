// Sparse matrices made column by column, columns side by side.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "planner/surface/operators.hpp"

namespace volute::planner {

/// The entries of one column while they are added up.
class ColumnSum {
 public:
  explicit ColumnSum(Eigen::Index rows)
      : value_(static_cast<std::size_t>(rows)), met_(static_cast<std::size_t>(rows), 0) {}
  void add(int row, double value) {
    const auto r = static_cast<std::size_t>(row);
    if (met_[r] == 0) {
      met_[r] = 1;
      value_[r] = value;
      rows_.push_back(row);
    } else {
      value_[r] += value;
    }
  }
  /// Calls visit(row, value) for every entry, rows ascending, and forgets them.
  template <class Visit>
  void take(Visit visit) {
    std::sort(rows_.begin(), rows_.end());
    for (const int row : rows_) {
      const auto r = static_cast<std::size_t>(row);
      met_[r] = 0;
      visit(row, value_[r]);
    }
    rows_.clear();
  }

 private:
  std::vector<double> value_;
  std::vector<char> met_;
  std::vector<int> rows_;
};

/// The matrix whose column c has the entries that `fill(c, sum)` adds to the ColumnSum; those of one place are added in
/// the order in which they come. `fill` is called for several columns at once. The same bytes on any number of threads.
template <class Fill>
SparseMatrix by_columns(Eigen::Index rows, Eigen::Index columns, Fill fill) {
  constexpr Eigen::Index chunk = 1024;
  struct Part {
    std::vector<int> row;
    std::vector<double> value;
  };
  std::vector<Part> parts(static_cast<std::size_t>((columns + chunk - 1) / chunk));
  SparseMatrix out(rows, columns);
  int* const start = out.outerIndexPtr();  // at first: the number of entries of the column before
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    ColumnSum sum(rows);
    const Eigen::Index begin = static_cast<Eigen::Index>(p) * chunk, end = std::min(columns, begin + chunk);
    for (Eigen::Index c = begin; c < end; ++c) {
      const std::size_t before = parts[p].row.size();
      fill(c, sum);
      sum.take([&](int row, double value) {
        parts[p].row.push_back(row);
        parts[p].value.push_back(value);
      });
      start[c + 1] = static_cast<int>(parts[p].row.size() - before);
    }
  });
  for (Eigen::Index c = 0; c < columns; ++c) start[c + 1] += start[c];
  out.resizeNonZeros(start[columns]);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    const int first = start[static_cast<Eigen::Index>(p) * chunk];
    std::copy(parts[p].row.begin(), parts[p].row.end(), out.innerIndexPtr() + first);
    std::copy(parts[p].value.begin(), parts[p].value.end(), out.valuePtr() + first);
  });
  return out;
}

}  // namespace volute::planner
