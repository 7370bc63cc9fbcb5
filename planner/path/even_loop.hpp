// The closed loop: field, path, dense scallop map, local gain, field again; the best round in one piece is kept.
#pragma once

#include <string>
#include <vector>

#include "planner/path/even_domain.hpp"
#include "planner/path/even_field.hpp"
#include "planner/path/even_path.hpp"
#include "planner/path/scallop_map.hpp"

namespace volute::planner {

struct EvenLoopOptions {
  EvenFieldOptions field;
  int outer = 6, inner = 30;   ///< of the first field; each is one direction update and its ADMM steps
  int rounds = 4;              ///< corrections from the scallop map
  double gain_step_max = 1.3;  ///< of one correction
  double gain_max = 3.0;
};

struct EvenRound {
  EvenField field;
  EvenPath path;
  CcPath cc;
  ScallopStatistics scallop;
  double length_mm = 0.0;
};

/// Errors (bad_input): path-even-broken when no round holds one piece; as SparseSolver::factor.
Result<EvenRound> even_rounds(const EvenDomain& domain, const IntervalRule& rule, const EvenLoopOptions& options);

}  // namespace volute::planner
