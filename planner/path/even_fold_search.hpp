// Where folds shorten the path.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "planner/path/even_domain.hpp"
#include "planner/path/even_field.hpp"

namespace volute::planner {

struct FoldSearchOptions {
  int folds_max = 0;        ///< of one centre
  int tried = 12;           ///< pairs of ends that promise most, each weighed by a field of its own
  int tried_at_last = 48;   ///< as many where those do not help, and all ends are moved again before
  int moves_max = 6;        ///< of a fold's ends, at each length of step
  double gain_min = 0.004;  ///< share of the length that a fold must save
  double move_gain_min = 0.002;
  int outer = 3, inner = 15;                                ///< of each trial field
  EvenFieldOptions field{.step = 20.0, .relaxation = 1.0};  ///< stiff: near enough after these few steps
};

/// The centre without folds and with ever more of them, the shortest path promised first. Each fold is the best of
/// those that the multipliers of the field before it promise most of (fold_pull_mm), weighed by fields of their own;
/// its ends are then moved to where they are drawn; the last is the one after which another would save less than
/// `options.gain_min` of the path. Ends keep 1.5 intervals from every boundary and stay off the collar of a slit. The
/// same on any number of threads. Requires: `start` on `surface`; its folds are not kept. Errors: as even_domain.
Result<std::vector<Centre>> with_folds(const EvenSurface& surface, const IntervalRule& rule,
                                       const FoldSearchOptions& options, const Centre& start);

}  // namespace volute::planner
