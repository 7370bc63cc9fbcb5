// Folds: passes that turn back where a surface is wide.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "geometry/mesh_measure.hpp"
#include "planner/path/even_centre.hpp"
#include "planner/path/even_fold.hpp"
#include "planner/path/even_fold_pull.hpp"
#include "planner/path/even_fold_search.hpp"
#include "planner/path/even_loop.hpp"
#include "planner/path/even_path.hpp"
#include "tests/planner/path/dense_scallop.hpp"
#include "tests/planner/path/sample_surfaces.hpp"

namespace volute::planner {
namespace {

constexpr double radius_mm = 3.0, scallop_mm = 0.2;
constexpr double hole_x_mm = -12.0, hole_radius_mm = 14.0;

IntervalRule rule() { return {.radius_mm = radius_mm, .scallop_mm = scallop_mm}; }

/// A flat plate, 60 by 40 mm, with a hole to the left: 4 mm of ground beside it, 28 on its other side.
EvenSurface lopsided_ring() {
  samples::PlateOptions options;
  options.width_mm = 60.0;
  options.columns = 60;
  options.holes = {{hole_x_mm, 0.0, hole_radius_mm}};
  return *EvenSurface::build(samples::plate(options));
}

Index place_at(const EvenSurface& surface, double x_mm, double y_mm) {
  const auto& vertices = surface.mesh.vertices_mm;
  const auto off = [&](const Vec3& p) { return (p - Vec3(x_mm, y_mm, 0.0)).squaredNorm(); };
  const auto nearest =
      std::min_element(vertices.begin(), vertices.end(), [&](const Vec3& a, const Vec3& b) { return off(a) < off(b); });
  return static_cast<Index>(nearest - vertices.begin());
}

/// Around the hole; counter-clockwise from the fold's first end to its second the wide side is passed.
Centre around_hole(const EvenSurface& surface, bool folded) {
  Centre out{1, {}};
  if (folded) out.folds.push_back({place_at(surface, 12.0, -9.0), place_at(surface, 12.0, 9.0)});
  return out;
}

EvenDomain domain_of(const EvenSurface& surface, const Centre& centre) {
  auto domain = even_domain(surface, centre);
  EXPECT_TRUE(domain.has_value());
  const auto laid = lay_folds(*domain, rule(), centre.folds);
  EXPECT_TRUE(laid.has_value()) << (laid ? "" : laid.error().message);
  return std::move(*domain);
}

/// By how much theta grows counter-clockwise around a vertex, along the far edges of the triangles about it.
double circulation(const EvenDomain& domain, Index vertex) {
  double sum = 0.0;
  for (Index h : domain.topology.outgoing(vertex)) {
    const Index next = geometry::next_halfedge(h), last = geometry::next_halfedge(next);
    sum += domain.theta.at_corner(domain.mesh, h / 3, last % 3) - domain.theta.at_corner(domain.mesh, h / 3, next % 3);
  }
  return sum;
}

/// How often the path crosses the ray from the hole's middle at an angle.
int crossings(const CcPath& path, double angle_rad) {
  const Vec3 middle(hole_x_mm, 0.0, 0.0), ray(std::cos(angle_rad), std::sin(angle_rad), 0.0),
      side(-ray.y(), ray.x(), 0);
  int count = 0;
  for (const CcPiece& piece : path.pieces) {
    for (std::size_t i = 1; i < piece.points.size(); ++i) {
      const Vec3 a = piece.points[i - 1].point_P_mm - middle, b = piece.points[i].point_P_mm - middle;
      if (a.dot(ray) > 0.0 && b.dot(ray) > 0.0 && (a.dot(side) > 0.0) != (b.dot(side) > 0.0)) ++count;
    }
  }
  return count;
}

EvenRound planned(const EvenSurface& surface, const Centre& centre) {
  EvenDomain domain = domain_of(surface, centre);
  const EvenLoopOptions options;
  auto first = first_field(domain, rule(), options);
  EXPECT_TRUE(first.has_value());
  EXPECT_TRUE(settle_first_field(domain, rule(), options, first->field).has_value());
  auto round = even_rounds(domain, std::move(first->field), rule(), options);
  EXPECT_TRUE(round.has_value()) << (round ? "" : round.error().message);
  return round ? std::move(*round) : EvenRound{};
}

// Closed form: two more passes between the ends mean that theta winds by two around them, to either side, and around
// nothing else; what is held stays.
TEST(EvenFold, ThetaWindsByTwoAroundTheEnds) {
  const EvenSurface surface = lopsided_ring();
  const EvenDomain plain = domain_of(surface, around_hole(surface, false));
  const Centre centre = around_hole(surface, true);
  const EvenDomain domain = domain_of(surface, centre);
  ASSERT_EQ(domain.folds.size(), 1u);
  EXPECT_EQ(domain.folds[0].front(), centre.folds[0].from);
  EXPECT_EQ(domain.folds[0].back(), centre.folds[0].to);
  const auto& fold = domain.folds[0];
  const double from = circulation(domain, fold.front());
  EXPECT_NEAR(std::abs(from), 2.0, 1e-9);
  EXPECT_NEAR(from + circulation(domain, fold.back()), 0.0, 1e-9);
  // An end's jump stands at the other vertex of its edge, so that the edge is what lines stop at.
  for (Index v = 0; v < static_cast<Index>(domain.mesh.vertices_mm.size()); ++v) {
    const bool at_end = v == fold[0] || v == fold[1] || v == fold.back() || v == fold[fold.size() - 2];
    if (at_end || domain.topology.is_boundary_vertex(v)) continue;
    EXPECT_NEAR(circulation(domain, v), 0.0, 1e-9) << v;
  }
  for (const auto& loop : domain.topology.boundary_loops()) {
    for (Index v : loop.vertices) {
      EXPECT_EQ(domain.theta.vertex[static_cast<std::size_t>(v)], plain.theta.vertex[static_cast<std::size_t>(v)]);
    }
  }
}

// Two passes more on the wide side for the same number on the narrow one, in one piece that keeps the scallop, and
// shorter for it.
TEST(EvenFold, AddsTwoPassesWhereTheSurfaceIsWide) {
  const EvenSurface surface = lopsided_ring();
  const EvenRound plain = planned(surface, around_hole(surface, false));
  const EvenRound folded = planned(surface, around_hole(surface, true));
  ASSERT_EQ(plain.path.pieces, 1);
  ASSERT_EQ(folded.path.pieces, 1);
  const auto more_on_the_wide_side = [](const EvenRound& round) {
    return crossings(round.cc, 0.02) - crossings(round.cc, std::numbers::pi + 0.02);
  };
  EXPECT_EQ(more_on_the_wide_side(folded) - more_on_the_wide_side(plain), 2);
  EXPECT_LT(folded.length_mm, 0.95 * plain.length_mm);
  EXPECT_LE(folded.scallop.max_ratio, 1.10);
  EXPECT_LE(samples::greatest_scallop_ratio(surface.mesh, folded.cc, radius_mm, scallop_mm, 1500, 7), 1.10);
  for (const CcPiece& piece : folded.cc.pieces) {
    for (std::size_t i = 1; i < piece.points.size(); ++i)
      ASSERT_GE(piece.points[i].turn, piece.points[i - 1].turn) << i;
  }
}

/// What a longer optimisation than the searches' trials promises for these folds.
double promised_mm(const EvenSurface& surface, std::vector<Fold> folds) {
  Centre centre = around_hole(surface, false);
  centre.folds = std::move(folds);
  auto domain = even_domain(surface, centre);
  if (!domain || !lay_folds(*domain, rule(), centre.folds)) return std::numeric_limits<double>::infinity();
  EvenLoopOptions quick;
  quick.trial_outer = 2;
  quick.trial_inner = 10;
  const auto first = first_field(*domain, rule(), quick);
  return first ? promised_length_mm(*domain, rule(), first->slopes) : std::numeric_limits<double>::infinity();
}

// Folds at random, each scored by itself: none saves much more than the one that the search finds.
TEST(EvenFold, TheSearchKeepsWhatShortensThePath) {
  const EvenSurface surface = lopsided_ring();
  FoldSearchOptions options;
  options.folds_max = 1;
  const auto found = with_folds(surface, rule(), options, around_hole(surface, true));
  ASSERT_TRUE(found.has_value()) << (found ? "" : found.error().message);
  ASSERT_EQ(found->size(), 2u);
  EXPECT_EQ(found->at(0).folds.size(), 1u);
  EXPECT_TRUE(found->at(1).folds.empty());
  const double with_fold_mm = promised_mm(surface, found->at(0).folds);
  EXPECT_LT(with_fold_mm, 0.97 * promised_mm(surface, {}));

  constexpr unsigned seed = 20261122;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x_mm(6.0, 26.0), y_mm(-16.0, 16.0);
  double least_mm = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 24; ++k) {
    const Fold fold{place_at(surface, x_mm(random), y_mm(random)), place_at(surface, x_mm(random), y_mm(random))};
    if (fold.from != fold.to) least_mm = std::min(least_mm, promised_mm(surface, {fold}));
  }
  EXPECT_LE(with_fold_mm, 1.005 * least_mm);
}

/// Rank correlation (Spearman). Requires: no two values alike.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto rank = [](const std::vector<double>& values, double value) {
    return static_cast<double>(std::count_if(values.begin(), values.end(), [&](double v) { return v < value; }));
  };
  const auto n = static_cast<double>(a.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(rank(a, a[i]) - rank(b, b[i]), 2);
  return 1.0 - 6.0 * sum / (n * (n * n - 1.0));
}

// What the multipliers promise against the length of a field optimised with the fold: they screen, they need not
// choose.
TEST(EvenFold, ThePullTellsWhichFoldsShortenThePath) {
  const EvenSurface surface = lopsided_ring();
  const EvenDomain domain = domain_of(surface, around_hole(surface, false));
  const FoldSearchOptions options;
  const auto solver = EvenFieldSolver::build(domain, rule(), options.field, std::nullopt);
  ASSERT_TRUE(solver.has_value());
  EvenField field = solver->start();
  solver->improve(field, std::vector<double>(domain.mesh.triangles.size(), 1.0), 6, 20);
  const auto pull_mm = fold_pull_mm(domain, rule(), options.field, field);
  ASSERT_TRUE(pull_mm.has_value());

  constexpr unsigned seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x_mm(6.0, 26.0), y_mm(-16.0, 16.0);
  const double plain_mm = promised_mm(surface, {});
  std::vector<double> told_mm, saved_mm;
  while (told_mm.size() < 30) {
    const Fold fold{place_at(surface, x_mm(random), y_mm(random)), place_at(surface, x_mm(random), y_mm(random))};
    const double saved = fold.from == fold.to ? -INFINITY : plain_mm - promised_mm(surface, {fold});
    if (!std::isfinite(saved)) continue;  // ends too near to each other
    told_mm.push_back(pull_mm->at(static_cast<std::size_t>(fold.to)) -
                      pull_mm->at(static_cast<std::size_t>(fold.from)));
    saved_mm.push_back(saved);
  }
  EXPECT_GT(rank_correlation(told_mm, saved_mm), 0.7);
  const auto best = std::max_element(told_mm.begin(), told_mm.end()) - told_mm.begin();
  EXPECT_GT(saved_mm[static_cast<std::size_t>(best)], 0.0)
      << "told to save " << told_mm[static_cast<std::size_t>(best)];
}

// Held at equal levels, the two passes that are joined at either end are the same two: a ring. The path runs it all the
// same, and what it runs is the ring, point by point.
TEST(EvenFold, ARingBetweenTheEndsIsRunToo) {
  const EvenSurface surface = lopsided_ring();
  EvenDomain domain = domain_of(surface, around_hole(surface, true));
  const EvenLoopOptions options;
  auto first = first_field(domain, rule(), options);
  ASSERT_TRUE(first.has_value());
  EvenField field = std::move(first->field);
  const double level = fold_choices(domain, field).front()[0][0];
  const auto solver = EvenFieldSolver::build(domain, rule(), options.field, HeldLevels{{}, {{level, level}}});
  ASSERT_TRUE(solver.has_value());
  solver->improve(field, std::vector<double>(domain.mesh.triangles.size(), 1.0), 6, 20);
  std::vector<double> winding(field.phi.size());
  for (std::size_t v = 0; v < winding.size(); ++v) winding[v] = field.phi[v] - domain.theta.vertex[v];
  const auto torn = torn_edges(domain);
  const auto lines =
      joined_at_folds(domain, trace_levels(domain.mesh, domain.topology, {winding, domain.theta.jump, torn}, 0.5));
  std::size_t rings = 0, ring_points = 0;
  for (const LevelLine& line : lines) {
    EXPECT_EQ(line.triangles.size() + (line.closed ? 0 : 1), line.points.size());
    if (!line.closed || line.length_mm < 10.0) continue;
    ++rings;
    ring_points += line.points.size();
  }
  ASSERT_EQ(rings, 1u);
  const EvenPath path = even_path(domain, field, rule().interval_mm(0.0));
  EXPECT_EQ(path.pieces, 1);
  EXPECT_EQ(path.splices, 1);
  EXPECT_GT(path.points.size(), ring_points);
}

// A ring of 5 mm and a straight pass 1 mm away from it become one line, no step of which is longer than the way across.
TEST(EvenFold, ARingIsRunBetweenTwoPointsOfAPass) {
  samples::PlateOptions options;
  const EvenSurface surface = *EvenSurface::build(samples::plate(options));
  const auto level_line = [&](const std::function<double(const Vec3&)>& value, bool closed) {
    std::vector<double> values;
    for (const Vec3& p : surface.mesh.vertices_mm) values.push_back(value(p));
    for (LevelLine& line : trace_levels(surface.mesh, surface.topology, {values, {}}, 0.5)) {
      if (line.closed == closed) return line;
    }
    return LevelLine{};
  };
  // The cone's one level in reach is a circle, the slope's a straight line at y = 6.
  const LevelLine ring = level_line([](const Vec3& p) { return std::min(0.9, 0.1 * p.norm()); }, true);
  const LevelLine pass =
      level_line([](const Vec3& p) { return std::clamp(0.5 + 0.1 * (p.y() - 6.0), 0.1, 0.9); }, false);
  ASSERT_NEAR(ring.length_mm, 2.0 * std::numbers::pi * 5.0, 0.3);
  ASSERT_NEAR(pass.length_mm, 40.0, 0.1);
  LevelLine far = pass;
  EXPECT_FALSE(splice(surface.mesh, ring, 0.8, far));
  EXPECT_EQ(far.points.size(), pass.points.size());
  LevelLine line = pass;
  ASSERT_TRUE(splice(surface.mesh, ring, 2.0, line));
  EXPECT_EQ(line.points.size(), pass.points.size() + ring.points.size());
  EXPECT_EQ(line.triangles.size() + 1, line.points.size());
  EXPECT_NEAR(line.length_mm, pass.length_mm + ring.length_mm, 1e-12);
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const Vec3 step = position_mm(surface.mesh, line.points[i]) - position_mm(surface.mesh, line.points[i - 1]);
    EXPECT_LT(step.norm(), 2.0) << i;
  }
}

TEST(EvenFold, SaysWhatIsWrongWithItsEnds) {
  const EvenSurface surface = lopsided_ring();
  auto domain = even_domain(surface, around_hole(surface, false));
  ASSERT_TRUE(domain.has_value());
  const Index a = place_at(surface, 12.0, -9.0), near = place_at(surface, 13.0, -9.0), b = place_at(surface, 12.0, 9.0);
  const auto code = [&](const std::vector<Fold>& folds) {
    EvenDomain copy = *domain;
    const auto laid = lay_folds(copy, rule(), folds);
    return laid ? std::string() : laid.error().code;
  };
  EXPECT_EQ(code({{a, near}}), "fold-short");
  EXPECT_EQ(code({{a, b}, {place_at(surface, 20.0, 0.0), near}}), "fold-near");
  EXPECT_EQ(code({{a, domain->outer.vertices.front()}}), "fold-given");
}

}  // namespace
}  // namespace volute::planner
