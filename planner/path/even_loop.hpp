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
  int first_outer = 14, first_inner = 25;   ///< of the first field: direction updates, and ADMM steps after each
  int settle_outer = 3, settle_inner = 15;  ///< after levels are held, or on the fine mesh
  int round_outer = 1, round_inner = 15;    ///< after each correction
  int rounds = 5;                           ///< corrections from the scallop map, at the most
  double gain_step_max = 1.3;               ///< of one correction
  double gain_max = 3.0;
};

struct EvenRound {
  EvenField field;
  EvenPath path;
  CcPath cc;
  ScallopStatistics scallop;
  double length_mm = 0.0;
};

struct FirstField {
  EvenField field;
  std::vector<Vec2> slopes;  ///< as EvenFieldSolver::slopes
};

/// The first field, its floating holes free. Errors: as SparseSolver::factor.
Result<FirstField> first_field(const EvenDomain& domain, const IntervalRule& rule, const EvenLoopOptions& options);

/// Goes on from `field`: holds the floating holes midway between path levels (theta is turned for that), traces,
/// measures, corrects. Errors (bad_input): path-even-broken when no round holds one piece; as SparseSolver::factor.
Result<EvenRound> even_rounds(EvenDomain& domain, EvenField field, const IntervalRule& rule,
                              const EvenLoopOptions& options);

}  // namespace volute::planner
