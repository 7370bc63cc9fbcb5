#include "planner/path/even_loop.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/number_text.hpp"
#include "planner/path/even_prolong.hpp"
#include "planner/path/even_rounding.hpp"
#include "planner/path/point_grid.hpp"

namespace volute::planner {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

double length_of(const CcPath& path) {
  double sum = 0.0;
  for (const CcPiece& piece : path.pieces) {
    for (std::size_t i = 1; i < piece.points.size(); ++i) {
      sum += (piece.points[i].point_P_mm - piece.points[i - 1].point_P_mm).norm();
    }
  }
  return sum;
}

/// The gain of this round: where the scallop is too high, the square root of its ratio, spread over most of an
/// interval.
std::vector<double> correction(const EvenDomain& domain, const std::vector<double>& worst_ratio, double reach_mm,
                               double step_max) {
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
    const double value = std::min(std::sqrt(worst_ratio[t]), step_max);
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

/// How far a round is past what it should hold; less is better, and among equals the shorter path.
double fault(const EvenRound& round) {
  const ScallopStatistics& s = round.scallop;
  return std::max(0.0, s.p9999_ratio - 1.05) + std::max(0.0, s.max_ratio - 1.10) +
         std::max(0.0, s.area_above_percent - 0.15);
}

bool better(const EvenRound& a, const EvenRound& b) {
  if ((a.path.pieces == 1) != (b.path.pieces == 1)) return a.path.pieces == 1;
  if (fault(a) != fault(b)) return fault(a) < fault(b);
  return a.length_mm < b.length_mm;
}

/// Rounds the corners and puts what moved back onto the surface.
void round_on_surface(const EvenDomain& domain, CcPiece& piece, double interval_mm) {
  const auto moved = round_corners(piece, interval_mm);
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

EvenRound trace_round(const EvenDomain& domain, const IntervalRule& rule, const EvenField& field,
                      std::vector<double>& worst) {
  EvenRound round;
  round.field = field;
  round.path = even_path(domain, field, rule.interval_mm(0.0));
  round.cc = cc_path_of(domain, round.path);
  for (CcPiece& piece : round.cc.pieces) round_on_surface(domain, piece, rule.interval_mm(0.0));
  round.length_mm = length_of(round.cc);
  ScallopMap map = measure_scallop(domain.mesh, domain.vertex_normals, round.cc, rule.radius_mm, rule.scallop_mm);
  round.scallop = map.statistics;
  worst = std::move(map.worst_ratio);
  return round;
}

}  // namespace

Result<FirstField> first_field(const EvenDomain& domain, const IntervalRule& rule, const EvenLoopOptions& options) {
  const auto solver = EvenFieldSolver::build(domain, rule, options.field, std::nullopt);
  if (!solver) return tl::unexpected(solver.error());
  EvenField field = solver->start();
  const std::vector<double> gain(domain.mesh.triangles.size(), 1.0);
  solver->improve(field, gain, options.first_outer, options.first_inner);
  auto slopes = solver->slopes(field);
  return FirstField{std::move(field), std::move(slopes)};
}

Result<EvenRound> even_rounds(EvenDomain& domain, EvenField field, const IntervalRule& rule,
                              const EvenLoopOptions& options) {
  const auto levels = settled_levels(domain, field);
  const auto solver = EvenFieldSolver::build(domain, rule, options.field, levels);
  if (!solver) return tl::unexpected(solver.error());
  std::vector<double> gain(domain.mesh.triangles.size(), 1.0), worst;
  solver->improve(field, gain, options.settle_outer, options.settle_inner);
  std::optional<EvenRound> best;
  const double reach_mm = 0.7 * rule.interval_mm(0.0);
  for (int r = 0; r <= options.rounds; ++r) {
    EvenRound round = trace_round(domain, rule, field, worst);
    if (!best || better(round, *best)) best = std::move(round);
    if (r == options.rounds || (best->path.pieces == 1 && fault(*best) == 0.0)) break;
    const auto step = correction(domain, worst, reach_mm, options.gain_step_max);
    for (std::size_t t = 0; t < gain.size(); ++t) gain[t] = std::min(gain[t] * step[t], options.gain_max);
    solver->improve(field, gain, options.round_outer, options.round_inner);
  }
  if (best->path.pieces != 1) {
    return geometry::bad_input("path-even-broken",
                               "the even spiral falls into " + std::to_string(best->path.pieces) +
                                   " pieces on this surface; method \"periodic\" holds one piece, with uneven passes");
  }
  return std::move(*best);
}

}  // namespace volute::planner
