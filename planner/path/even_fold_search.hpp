// Where folds shorten the path.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "planner/path/even_centre.hpp"

namespace volute::planner {

/// A centre and the path length that its field promises, mm; infinite where there is none.
struct ScoredCentre {
  double score = std::numeric_limits<double>::infinity();
  Centre centre;
};
/// Scores of centres, all at once.
using ScoreCentres = std::function<std::vector<ScoredCentre>(const std::vector<Centre>&)>;

/// Folds added to the best slit and to the best centre that is a hole, one by one: each the best of many, its ends then
/// moved; the last is the one after which another would save less than `options.fold_gain_min` of the path. Every step
/// joins `found`, which comes sorted and stays so, the shortest first. `room_mm`: per vertex, from every boundary; ends
/// keep 1.5 intervals of it. The same bytes on any number of threads, if `score` gives them.
void add_folds(const EvenSurface& coarse, const IntervalRule& rule, const CentreSearchOptions& options,
               std::span<const double> room_mm, const ScoreCentres& score, std::vector<ScoredCentre>& found);

}  // namespace volute::planner
