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
  EvenFieldOptions first_field{.step = 3.0};  ///< coarse: its directions still have far to turn
  EvenFieldOptions field;
  int trial_outer = 6, trial_inner = 20;    ///< of a first field: direction updates, and ADMM steps after each
  int first_outer = 8, first_inner = 25;    ///< more of them for the field that is gone on with
  int settle_outer = 3, settle_inner = 15;  ///< after levels are held, or on the fine mesh
  int round_outer = 1, round_inner = 15;    ///< after each correction
  int stiffened_outer = 3;                  ///< after one that made bending dearer
  int rounds = 5;                           ///< corrections from the scallop map, at the most
  double gain_step_max = 1.3;               ///< of one correction
  double gain_max = 3.0;
  int sharp_max = 8;        ///< corners over 60 degrees: with more, bending is made dearer around them
  double stiffening = 4.0;  ///< of one correction
  double stiffening_max = 64.0;
};

struct EvenRound {
  EvenField field;
  EvenPath path;
  CcPath cc;
  ScallopStatistics scallop;
  std::vector<Vec3> sharp_mm;  ///< places of corners over 60 degrees, the outer boundary's left out
  int sharp_corners = 0;       ///< as PathReport::sharp_corners_60
  double length_mm = 0.0;
};

struct FirstField {
  EvenField field;
  std::vector<Vec2> slopes;  ///< as EvenFieldSolver::slopes
};

/// The first field, its floating holes free: good enough to compare centres by. Errors: as SparseSolver::factor.
Result<FirstField> first_field(const EvenDomain& domain, const IntervalRule& rule, const EvenLoopOptions& options);

/// Goes on with a first field until it stands still. Errors: as SparseSolver::factor.
Result<void> settle_first_field(const EvenDomain& domain, const IntervalRule& rule, const EvenLoopOptions& options,
                                EvenField& field);

/// Goes on from `field`: holds the floating holes midway between path levels (theta is turned for that), traces,
/// measures, corrects: closer passes where the scallop is too high, dearer bending where too many corners are sharp.
/// Errors (bad_input): path-even-broken when no round holds one piece; as SparseSolver::factor.
/// `ready`: EvenFieldSolver::factor of this domain with options.field, where that was had before.
Result<EvenRound> even_rounds(EvenDomain& domain, EvenField field, const IntervalRule& rule,
                              const EvenLoopOptions& options, std::optional<SparseSolver> ready = std::nullopt);

}  // namespace volute::planner
