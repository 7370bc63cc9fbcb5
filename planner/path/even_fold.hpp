// Places where passes turn back, so that wide parts of a surface get more of them than narrow ones.
#pragma once

#include <span>
#include <vector>

#include "planner/path/even_domain.hpp"
#include "planner/path/even_field.hpp"
#include "planner/path/level_trace.hpp"

namespace volute::planner {

/// theta with the folds in it: it jumps by two more across a chain of edges from one end of each fold to the other
/// (they join domain.folds), so that phi - theta winds by two around each end and two of its level lines stop there.
/// What is held (boundaries, the collar of a slit) keeps its theta. Errors (bad_input): surface-no-path, fold-short
/// (fewer than four edges), fold-near (two folds end within two intervals), fold-given (an end where phi is held); as
/// SparseSolver::factor. Requires: no folds in the domain; ends are inner vertices.
Result<void> lay_folds(EvenDomain& domain, const IntervalRule& rule, std::span<const Fold> folds);

/// Whole values of phi - theta at which the ends of the folds may be held, one pair a fold: combinations, the nearest
/// to the field's own first. With them the two passes that turn back at one end lie next to those of the other, so that
/// of three passes side by side the middle one runs backwards and the rest of the path stays as it was. One empty
/// combination where there are no folds.
std::vector<std::vector<std::array<double, 2>>> fold_choices(const EvenDomain& domain, const EvenField& field);

/// Sum over the folds of how far, squared, the nearest such levels are from the field's own.
double fold_misfit(const EvenDomain& domain, const EvenField& field);

/// The edges at which lines end: the first and the last of each fold.
std::vector<Index> torn_edges(const EvenDomain& domain);

/// Lines joined where they end at a fold: passes that go on through it, and the two that are left, which turn back.
/// Only the line that begins on the outer boundary has the direction of the path. By falling length.
std::vector<LevelLine> joined_at_folds(const EvenDomain& domain, std::vector<LevelLine> lines);

/// A ring run backwards between two neighbouring points of `line`, where the two come nearest: passes turn back twice
/// there. False, and nothing changed, where they are farther apart than `reach_mm`. Requires: ring closed.
bool splice(const TriangleMesh& mesh, const LevelLine& ring, double reach_mm, LevelLine& line);

}  // namespace volute::planner
