// What a fold would save, told by the multipliers of the field.
#pragma once

#include <vector>

#include "planner/path/even_domain.hpp"
#include "planner/path/even_field.hpp"

namespace volute::planner {

/// Per vertex, mm: a fold laid from a to b shortens the path by about pull[b] - pull[a], and an end at b is drawn along
/// the gradient of the pull (an end at a against it). It is first order, at directions that stay and a field that is
/// optimal, so it screens pairs of ends and does not choose among the best of them (rank correlation with the length of
/// a field optimised with the fold 0.8).
///
/// Folds add to theta a function with jumps; the least length changes by minus the integral of y . grad of it, where y
/// is the multiplier of q = grad(phi - theta). phi is free, so y is free of divergence, and of flux through the holes
/// and the centre: y is the turned gradient of a potential, and the integral is twice the potential's difference
/// between the ends. What y has of divergence (ADMM is stopped early) is taken off first.
/// `options`: those that `field` was optimised with. Errors: as SparseSolver::factor.
Result<std::vector<double>> fold_pull_mm(const EvenDomain& domain, const IntervalRule& rule,
                                         const EvenFieldOptions& options, const EvenField& field);

}  // namespace volute::planner
