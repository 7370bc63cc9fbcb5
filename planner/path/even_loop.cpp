#include "planner/path/even_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/index.hpp"
#include "planner/path/even_fold.hpp"
#include "planner/path/even_nudge.hpp"
#include "planner/path/even_prolong.hpp"
#include "planner/path/even_rounding.hpp"
#include "planner/path/path_measure.hpp"
#include "planner/path/point_grid.hpp"

namespace volute::planner {

using geometry::at;
namespace {

constexpr double area_above_max_percent = 0.15;  ///< of the area, over the allowed scallop

double length_of(const CcPath& path) {
  double sum = 0.0;
  for (const CcPiece& piece : path.pieces) {
    for (std::size_t i = 1; i < piece.points.size(); ++i) {
      sum += (piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm).norm();
    }
  }
  return sum;
}

/// Heights grow with the square of the interval. Where single places are too high, they are taken down to what a place
/// may have, with more than the root, since a gain on a small place is averaged out by what is around it; where too
/// much of the area is, each a little more than its height asks for: with the root alone the others come back round by
/// round.
double gain_for(double ratio, bool much_area, double step_max) {
  constexpr double place_ratio = 1.08, place_power = 0.75, eager_max = 1.05;
  if (!much_area) return std::clamp(std::pow(ratio / place_ratio, place_power), 1.0, step_max);
  return std::min(std::max(std::sqrt(ratio), std::min(ratio * std::sqrt(ratio), eager_max)), step_max);
}

/// The gain of this round: where the scallop is too high, spread over most of an interval.
std::vector<double> correction(const EvenDomain& domain, const std::vector<double>& worst_ratio, bool much_area,
                               double reach_mm, double step_max) {
  const auto& triangles = domain.mesh.triangles;
  std::vector<Vec3> middles;
  for (const auto& t : triangles) {
    middles.push_back(
        (domain.mesh.vertices_mm[at(t[0])] + domain.mesh.vertices_mm[at(t[1])] + domain.mesh.vertices_mm[at(t[2])]) /
        3.0);
  }
  const PointGrid grid(middles, reach_mm);
  std::vector<double> gain(triangles.size(), 1.0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (worst_ratio[t] <= 1.0) continue;
    const double value = gain_for(worst_ratio[t], much_area, step_max);
    grid.near(middles[t], reach_mm, [&](Index i) {
      if ((middles[at(i)] - middles[t]).norm() <= reach_mm) gain[at(i)] = std::max(gain[at(i)], value);
    });
  }
  std::vector<double> sum(domain.mesh.vertices_mm.size(), 0.0), area(sum.size(), 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (Index v : triangles[t]) {
      sum[at(v)] += domain.operators[t].area_mm2 * gain[t];
      area[at(v)] += domain.operators[t].area_mm2;
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    double mean = 0.0;
    for (Index v : triangles[t]) mean += sum[at(v)] / area[at(v)] / 3.0;
    gain[t] = std::max(gain[t], mean);
  }
  return gain;
}

constexpr double greatest_kept = 1.10;   ///< times the allowed scallop: a round with more is corrected
constexpr double nudged_down_to = 1.07;  ///< what nudging aims at: the spline through these points adds a little

/// How far a round is past what it should hold.
double fault(const EvenRound& round, int sharp_max, double greatest = greatest_kept) {
  constexpr double one_corner = 0.02;  // as bad as so much of the scallop
  const ScallopStatistics& s = round.scallop;
  return std::max(0.0, s.p9999_ratio - 1.05) + std::max(0.0, s.max_ratio - greatest) +
         std::max(0.0, s.area_above_percent - area_above_max_percent) +
         one_corner * std::max(0, round.sharp_corners - sharp_max);
}

/// Less fault is better, and among equals the shorter path.
bool better(const EvenRound& a, const EvenRound& b, int sharp_max) {
  if ((a.path.pieces == 1) != (b.path.pieces == 1)) return a.path.pieces == 1;
  if (fault(a, sharp_max) != fault(b, sharp_max)) return fault(a, sharp_max) < fault(b, sharp_max);
  return a.length_mm < b.length_mm;
}

/// Bending made dearer within two intervals of the sharp places; false where nothing changed.
bool stiffen_around(const EvenDomain& domain, const std::vector<Vec3>& sharp_mm, double reach_mm,
                    const EvenLoopOptions& options, std::vector<double>& bend_gain) {
  const PointGrid grid(domain.mesh.vertices_mm, reach_mm);
  std::vector<char> near(bend_gain.size(), 0);
  for (const Vec3& place : sharp_mm) {
    grid.near(place, reach_mm, [&](Index v) {
      if ((domain.mesh.vertices_mm[at(v)] - place).norm() <= reach_mm) near[at(v)] = 1;
    });
  }
  bool changed = false;
  for (std::size_t v = 0; v < near.size(); ++v) {
    if (near[v] == 0 || bend_gain[v] >= options.stiffening_max) continue;
    bend_gain[v] *= options.stiffening;
    changed = true;
  }
  return changed;
}

/// Puts the points that moved back onto the surface.
void put_on_surface(const EvenDomain& domain, CcPiece& piece, const std::vector<char>& moved) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (moved[i] != 0) places.push_back(piece.points[i].point_P_mm);
  }
  const auto put = on_mesh(domain.mesh, domain.vertex_normals, domain.operators, places);
  for (std::size_t i = 0, next = 0; i < moved.size(); ++i) {
    if (moved[i] == 0) continue;
    piece.points[i].point_P_mm = put[next].point_P_mm;
    piece.points[i].normal_P = put[next++].normal_P;
  }
}

/// Adds the piece's corners over 60 degrees: their number by the report's own measure, and their places.
void find_corners(const CcPiece& piece, double interval_mm, EvenRound& round) {
  constexpr double sharp_rad = std::numbers::pi / 3.0;
  const double spacing_mm = interval_mm / 16.0;
  const auto points = even_points(piece, spacing_mm);
  round.sharp_corners += static_cast<int>(corner_angles_rad(points, spacing_mm, 0.5 * interval_mm, sharp_rad).size());
  const auto places = sharp_places_mm(piece, interval_mm, sharp_rad);
  round.sharp_mm.insert(round.sharp_mm.end(), places.begin(), places.end());
}

/// Passes turn back sharply at the ends of folds: those corners are meant, and bending is not made dearer for them.
void leave_out_folds(const EvenDomain& domain, double reach_mm, EvenRound& round) {
  const auto before = static_cast<int>(round.sharp_mm.size());
  std::erase_if(round.sharp_mm, [&](const Vec3& place) {
    return std::any_of(domain.folds.begin(), domain.folds.end(), [&](const std::vector<Index>& fold) {
      return (domain.mesh.vertices_mm[at(fold.front())] - place).norm() < reach_mm ||
             (domain.mesh.vertices_mm[at(fold.back())] - place).norm() < reach_mm;
    });
  });
  round.sharp_corners -= before - static_cast<int>(round.sharp_mm.size());
}

/// What of a round comes from its path: length, corners, scallops.
ScallopMap measure_round(const EvenDomain& domain, const IntervalRule& rule, ScallopMeter& meter, EvenRound& round) {
  round.sharp_corners = 0;
  round.sharp_mm.clear();
  for (const CcPiece& piece : round.cc.pieces) find_corners(piece, rule.interval_mm(0.0), round);
  leave_out_folds(domain, 1.5 * rule.interval_mm(0.0), round);
  round.length_mm = length_of(round.cc);
  const ScallopMap& map = meter.measure(round.cc);
  round.scallop = map.statistics;
  return map;
}

/// Single places too high: the passes beside them are moved, as long as that helps. Returns the map of what is kept.
ScallopMap nudged(const EvenDomain& domain, const IntervalRule& rule, int sharp_max, ScallopMeter& meter,
                  ScallopMap map, EvenRound& best) {
  constexpr int nudges_max = 8, failures_max = 2;
  constexpr double mended_from = 1.04;
  constexpr NudgeOptions nudge_options{.aim_ratio = 1.03};
  constexpr std::size_t places_max = 400;  // more are no single places
  const double interval_mm = rule.interval_mm(0.0);
  const auto left = [&](const EvenRound& round) { return fault(round, sharp_max, nudged_down_to); };
  EvenRound now = best;
  ScallopMap now_map = map;
  for (int n = 0, failures = 0; n < nudges_max && failures < failures_max && left(best) > 0.0; ++n) {
    if (now.scallop.area_above_percent > area_above_max_percent) break;
    const auto places = high_places(now_map, mended_from, 0.5 * interval_mm);
    if (places.empty() || places.size() > places_max) break;
    for (CcPiece& piece : now.cc.pieces) {
      put_on_surface(domain, piece, nudge(piece, places, interval_mm, nudge_options));
      fill_bends(piece, interval_mm);
    }
    now_map = measure_round(domain, rule, meter, now);
    if (left(now) >= left(best)) {
      ++failures;
      continue;
    }
    best = now;
    map = now_map;
  }
  return map;
}

EvenRound trace_round(const EvenDomain& domain, const IntervalRule& rule, const EvenField& field, int sharp_max,
                      ScallopMeter& meter, std::vector<double>& worst) {
  EvenRound round;
  round.field = field;
  round.path = even_path(domain, field, rule.interval_mm(0.0));
  round.cc = cc_path_of(domain, round.path);
  for (CcPiece& piece : round.cc.pieces) {
    put_on_surface(domain, piece, round_corners(piece, rule.interval_mm(0.0)));
    fill_bends(piece, rule.interval_mm(0.0));
  }
  ScallopMap map = measure_round(domain, rule, meter, round);
  if (round.path.pieces == 1) map = nudged(domain, rule, sharp_max, meter, std::move(map), round);
  worst = std::move(map.worst_ratio);
  return round;
}

struct Corrections {
  std::vector<double> gain;       ///< of the needed gradient, per triangle
  std::vector<double> bend_gain;  ///< of the cost of bending, per vertex
};

struct LoopContext {
  const EvenDomain& domain;
  const IntervalRule& rule;
  const EvenLoopOptions& options;
};

/// Answers what a round left, and takes the field on.
Result<void> correct(const LoopContext& in, const EvenRound& round, const std::vector<double>& worst, Corrections& made,
                     EvenFieldSolver& solver, EvenField& field) {
  const double interval_mm = in.rule.interval_mm(0.0);
  const bool much_area = round.scallop.area_above_percent > area_above_max_percent;
  const auto step = correction(in.domain, worst, much_area, 0.7 * interval_mm, in.options.gain_step_max);
  for (std::size_t t = 0; t < step.size(); ++t) made.gain[t] = std::min(made.gain[t] * step[t], in.options.gain_max);
  int outer = in.options.round_outer;
  if (round.sharp_corners > in.options.sharp_max &&
      stiffen_around(in.domain, round.sharp_mm, 2.0 * interval_mm, in.options, made.bend_gain)) {
    if (auto stiff = solver.stiffen(made.bend_gain); !stiff) return stiff;
    outer = in.options.stiffened_outer;
  }
  solver.improve(field, made.gain, outer, in.options.round_inner);
  return {};
}

/// The field with its levels held, and what goes on with it. Levels of folds are the first, among the nearest few, at
/// which the field is one piece.
Result<EvenFieldSolver> settled_solver(EvenDomain& domain, const IntervalRule& rule, const EvenLoopOptions& options,
                                       EvenField& field, std::optional<SparseSolver> ready) {
  constexpr std::size_t tries_max = 8;
  constexpr int hopeful_tries = 5, hopeful_pieces = 3;  // after so many tries one has left no more pieces, or none will
  int tries = 0, fewest = std::numeric_limits<int>::max();
  HeldLevels levels = settled_levels(domain, field);
  auto choices = fold_choices(domain, field);
  choices.resize(std::min(choices.size(), tries_max));
  const std::vector<double> gain(domain.mesh.triangles.size(), 1.0);
  for (auto& choice : choices) {
    levels.folds = std::move(choice);
    auto solver = EvenFieldSolver::build(domain, rule, options.field, levels, std::move(ready));
    if (!solver) return solver;
    EvenField tried = field;
    solver->improve(tried, gain, options.settle_outer, options.settle_inner);
    if (!domain.folds.empty()) {
      const int pieces = even_path(domain, tried, rule.interval_mm(0.0)).pieces;
      fewest = std::min(fewest, pieces);
      if (++tries == hopeful_tries && fewest > hopeful_pieces) break;
      if (pieces != 1) {
        ready = std::move(*solver).factor();
        continue;
      }
    }
    field = std::move(tried);
    return solver;
  }
  return geometry::bad_input("path-even-broken", "with its folds the even spiral falls into pieces");
}

}  // namespace

Result<FirstField> first_field(const EvenDomain& domain, const IntervalRule& rule, const EvenLoopOptions& options) {
  const auto solver = EvenFieldSolver::build(domain, rule, options.first_field, std::nullopt);
  if (!solver) return tl::unexpected(solver.error());
  EvenField field = solver->start();
  const std::vector<double> gain(domain.mesh.triangles.size(), 1.0);
  solver->improve(field, gain, options.trial_outer, options.trial_inner);
  auto slopes = solver->slopes(field);
  return FirstField{std::move(field), std::move(slopes)};
}

Result<void> settle_first_field(const EvenDomain& domain, const IntervalRule& rule, const EvenLoopOptions& options,
                                EvenField& field) {
  const auto solver = EvenFieldSolver::build(domain, rule, options.first_field, std::nullopt);
  if (!solver) return tl::unexpected(solver.error());
  const std::vector<double> gain(domain.mesh.triangles.size(), 1.0);
  solver->improve(field, gain, options.first_outer, options.first_inner);
  return {};
}

Result<EvenRound> even_rounds(EvenDomain& domain, EvenField field, const IntervalRule& rule,
                              const EvenLoopOptions& options, std::optional<SparseSolver> ready) {
  Corrections made{std::vector<double>(domain.mesh.triangles.size(), 1.0),
                   std::vector<double>(domain.mesh.vertices_mm.size(), 1.0)};
  auto solver = settled_solver(domain, rule, options, field, std::move(ready));
  if (!solver) return tl::unexpected(solver.error());
  ScallopMeter meter(domain.mesh, domain.vertex_normals, rule.radius_mm, rule.scallop_mm,
                     {.exact_from_ratio = 0.9, .closer_from_ratio = 0.92});
  std::optional<EvenRound> best;
  std::vector<double> worst;
  for (int r = 0; r <= options.rounds; ++r) {
    EvenRound round = trace_round(domain, rule, field, options.sharp_max, meter, worst);
    const bool last = r == options.rounds || (round.path.pieces == 1 && fault(round, options.sharp_max) == 0.0);
    if (!last) {
      const auto corrected = correct({domain, rule, options}, round, worst, made, *solver, field);
      if (!corrected) return tl::unexpected(corrected.error());
    }
    if (!best || better(round, *best, options.sharp_max)) best = std::move(round);
    if (last) break;
  }
  if (best->path.pieces != 1) {
    return geometry::bad_input("path-even-broken",
                               "the even spiral falls into " + std::to_string(best->path.pieces) +
                                   " pieces on this surface; method \"periodic\" holds one piece, with uneven passes");
  }
  return std::move(*best);
}

}  // namespace volute::planner
