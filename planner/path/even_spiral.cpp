#include "planner/path/even_spiral.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>

#include "geometry/mesh_measure.hpp"
#include "geometry/number_text.hpp"
#include "planner/path/even_centre.hpp"
#include "planner/path/even_fold.hpp"
#include "planner/path/even_fold_search.hpp"
#include "planner/path/even_loop.hpp"
#include "planner/path/even_prolong.hpp"
#include "planner/path/path_measure.hpp"
#include "planner/surface/condition.hpp"

namespace volute::planner {
namespace {

using geometry::Angle;
using geometry::Vec2;

constexpr double scallop_kept = 1.2;     ///< times the allowed one: with more, another centre is tried
constexpr double long_path = 1.5;        ///< times the path of a plane as large: with more, sharper bends are tried
constexpr double map_hole_radius = 1.0;  ///< of the centre in the picture, turns

Vec2 in_map(const EvenField& field, double theta, double phi) {
  const double angle = 2.0 * std::numbers::pi * theta, radius = field.turns + map_hole_radius - phi;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// The path in the map, turn by turn: phi - theta = k + 1/2.
std::vector<std::vector<Vec2>> guide_lines(const EvenField& field) {
  constexpr int parts = 60;
  std::vector<std::vector<Vec2>> out;
  for (double level = -0.5; level < field.turns; level += 1.0) {
    std::vector<Vec2> line;
    for (int i = 0; i <= parts; ++i) {
      const double theta = static_cast<double>(i) / parts, phi = level + theta;
      if (phi >= 0.0 && phi <= field.turns) line.push_back(in_map(field, theta, phi));
    }
    if (line.size() > 1) out.push_back(std::move(line));
  }
  return out;
}

/// The field as a picture: each vertex at the angle theta and the radius left to the centre.
MapDrawing drawing_of(const EvenDomain& domain, const EvenField& field) {
  MapDrawing map;
  for (std::size_t v = 0; v < field.phi.size(); ++v) {
    map.vertices.push_back(in_map(field, domain.theta.vertex[v], field.phi[v]));
  }
  map.triangles = domain.mesh.triangles;
  map.guide_lines = guide_lines(field);
  for (const auto& slit : domain.slits) {
    auto& line = map.bridges_P.emplace_back();
    for (Index v : slit) line.push_back(domain.mesh.vertices_mm[static_cast<std::size_t>(v)]);
  }
  return map;
}

PathReport report_of(const EvenRound& round, const IntervalField& interval, const PathOptions& options) {
  PathReport report;
  report.strategy = "spiral";
  report.method = "even";
  report.length_mm = round.length_mm;
  report.lower_bound_mm = interval.lower_bound_mm();
  report.length_ratio = report.length_mm / report.lower_bound_mm;
  report.pieces = static_cast<int>(round.cc.pieces.size());
  const double interval_mm = path_interval_mm(interval.rule().radius_mm, options.scallop_mm, 0.0);
  const double spacing_mm = interval_mm / 16.0;
  for (const CcPiece& piece : round.cc.pieces) {
    report.cc_points += static_cast<int>(piece.points.size());
    const auto points = even_points(piece, spacing_mm);
    const auto angles = corner_angles_rad(points, spacing_mm, 0.5 * interval_mm, Angle::degrees(35.0).radians());
    report.sharp_corners += static_cast<int>(angles.size());
    report.sharp_corners_60 += static_cast<int>(
        std::count_if(angles.begin(), angles.end(), [](double a) { return a > Angle::degrees(60.0).radians(); }));
  }
  report.scallop_ratio_p9999 = round.scallop.p9999_ratio;
  report.scallop_ratio_max = round.scallop.max_ratio;
  report.scallop_area_above_percent = round.scallop.area_above_percent;
  return report;
}

/// Share of a turn in which the outer boundary's wedge is bridged: the path may leave it at a slope of 1 in 15.
double ramp_share_of(const EvenSurface& surface, const IntervalRule& rule) {
  const double share = 15.0 * rule.interval_mm(0.0) / surface.topology.boundary_loops().front().length_mm;
  return share < 0.8 ? std::max(share, 0.15) : 1.0;
}

/// The mesh that the field lives on: as fine as passes need it, and no finer than a field can be solved on quickly.
Result<EvenSurface> field_surface(const EvenSurface& surface, const IntervalRule& rule) {
  constexpr double triangles_max = 60000.0, triangles_kept = 40000.0;
  constexpr double edge_share_max = 0.7;  // of the interval
  if (static_cast<double>(surface.mesh.triangles.size()) > triangles_max) {
    return coarse_surface(surface, static_cast<int>(triangles_kept));
  }
  // An equilateral triangle of edge e has the area sqrt(3) / 4 e^2; halved edges are 0.75 of the longest on average.
  const double edge_least_mm = std::sqrt(geometry::area_mm2(surface.mesh) / triangles_kept / (0.433 * 0.75 * 0.75));
  return surface.refined(std::max(edge_share_max * rule.interval_mm(0.0), edge_least_mm));
}

struct Planned {
  EvenDomain domain;
  EvenRound round;
  std::string note;  ///< what the user should know of how it was found
  Centre centre;     ///< on the surface that the field lives on
};

/// One way to look for the path.
struct Search {
  CentreSearchOptions centres;
  FoldSearchOptions folds;
  EvenLoopOptions loop;
  int coarse_triangles = 5000;  ///< of the mesh on which the first fields of the best centres are found
};

/// Passes may bend sharply, which long and narrow parts of a surface ask for: they turn back there instead of running
/// on closer together.
Search with_bend(double bend) {
  Search search;
  for (EvenFieldOptions* field :
       {&search.centres.field, &search.folds.field, &search.loop.first_field, &search.loop.field})
    field->bend = bend;
  search.loop.sharp_max = std::numeric_limits<int>::max();
  return search;
}

/// Sharper bends; then sharper still, with creases, on meshes fine enough to see them; then few corners again, but
/// passes that turn back; then sharp bends and passes that turn back; then sharper still.
std::vector<Search> searches_for_shorter(bool folds) {
  Search creased = with_bend(0.03);
  for (EvenFieldOptions* field : {&creased.centres.field, &creased.loop.first_field, &creased.loop.field})
    field->creases = true;
  creased.centres.triangles = 4000;
  creased.coarse_triangles = 16000;
  if (!folds) return {with_bend(0.1), creased};
  std::vector<Search> out{with_bend(0.1), creased};
  for (const Search& search : {Search{}, with_bend(0.1), with_bend(0.03)}) {
    out.push_back(search);
    out.back().folds.folds_max = 12;
  }
  return out;
}

/// A centre with its first field on the coarse mesh.
struct Finalist {
  Centre centre;
  EvenDomain domain;
  EvenField field;
  double promised_mm = 0.0;
};

/// The domain with the centre's folds laid.
Result<EvenDomain> folded_domain(const EvenSurface& surface, const Centre& centre, const IntervalRule& rule,
                                 double ramp_share) {
  auto domain = even_domain(surface, centre, ramp_share);
  if (!domain) return domain;
  if (auto laid = lay_folds(*domain, rule, centre.folds); !laid) return tl::unexpected(laid.error());
  return domain;
}

Result<Finalist> finalist_of(const EvenSurface& coarse, const Centre& centre, const IntervalRule& rule,
                             double ramp_share, const EvenLoopOptions& loop) {
  auto domain = folded_domain(coarse, centre, rule, ramp_share);
  if (!domain) return tl::unexpected(domain.error());
  auto first = first_field(*domain, rule, loop);
  if (!first) return tl::unexpected(first.error());
  const double promised_mm = promised_length_mm(*domain, rule, first->slopes);
  return Finalist{centre, std::move(*domain), std::move(first->field), promised_mm};
}

/// The finalists, the shortest first; the last error where there is none.
Result<std::vector<Finalist>> finalists_of(const EvenSurface& coarse, std::span<const Centre> centres,
                                           const IntervalRule& rule, double ramp_share, const EvenLoopOptions& loop) {
  std::vector<std::optional<Result<Finalist>>> tried(centres.size());
  tbb::parallel_for(std::size_t{0}, tried.size(),
                    [&](std::size_t i) { tried[i] = finalist_of(coarse, centres[i], rule, ramp_share, loop); });
  std::vector<Finalist> out;
  for (auto& finalist : tried) {
    if (*finalist) out.push_back(std::move(**finalist));
  }
  if (out.empty()) return tl::unexpected((*tried.back()).error());
  std::stable_sort(out.begin(), out.end(),
                   [](const Finalist& a, const Finalist& b) { return a.promised_mm < b.promised_mm; });
  return out;
}

Result<Planned> planned_around(const EvenSurface& surface, const EvenSurface& coarse, Finalist& finalist,
                               const IntervalRule& rule, double ramp_share, const EvenLoopOptions& loop) {
  const Centre centre = moved_centre(coarse, finalist.centre, surface);
  Result<void> settled;
  Result<EvenDomain> domain{};
  Result<SparseSolver> factor = geometry::bad_input("path-even-broken", "no domain");
  tbb::parallel_invoke([&] { settled = settle_first_field(finalist.domain, rule, loop, finalist.field); },
                       [&] {
                         domain = folded_domain(surface, centre, rule, ramp_share);
                         if (domain) factor = EvenFieldSolver::factor(*domain, rule, loop.field);
                       });
  if (!settled) return tl::unexpected(settled.error());
  if (!domain) return tl::unexpected(domain.error());
  if (!factor) return tl::unexpected(factor.error());
  auto round =
      even_rounds(*domain, prolonged(finalist.domain, finalist.field, *domain), rule, loop, std::move(*factor));
  if (!round) return tl::unexpected(round.error());
  return Planned{std::move(*domain), std::move(*round), {}, centre};
}

/// The shortest first, then the one with the fewest arms (short arms on a small part leave no room for turns around
/// their tips); of the longer search the two shortest; all where there are folds, which may leave pieces.
std::vector<std::size_t> tried_in_order(const std::vector<Finalist>& finalists, bool ridges) {
  const bool folded = !finalists.front().centre.folds.empty();
  const std::size_t tries_max = folded ? finalists.size() : 2;
  std::vector<std::size_t> order;
  const auto add = [&](std::size_t i) {
    if (i < finalists.size() && std::find(order.begin(), order.end(), i) == order.end()) order.push_back(i);
  };
  const auto simplest = std::min_element(finalists.begin(), finalists.end(), [](const Finalist& a, const Finalist& b) {
    return a.centre.arms.size() < b.centre.arms.size();
  });
  add(0);
  if (!ridges && !folded) add(static_cast<std::size_t>(simplest - finalists.begin()));
  for (std::size_t i = 1; order.size() < std::min(tries_max, finalists.size()); ++i) add(i);
  return order;
}

/// The length, and as much of it again as the greatest scallop is past what is kept.
double weight(const EvenRound& round) {
  return round.length_mm * (1.0 + std::max(0.0, round.scallop.max_ratio - scallop_kept));
}

/// The best few centres of a search on the coarse mesh, or one centre with the best few sets of folds, with their
/// fields.
Result<std::vector<Finalist>> searched_finalists(const EvenSurface& coarse, const IntervalRule& rule,
                                                 const PathOptions& options, double ramp_share, const Search& search,
                                                 const std::optional<Centre>& folded) {
  constexpr std::size_t finalists_max = 4;
  auto centres =
      folded ? with_folds(coarse, rule, search.folds, *folded) : choose_centres(coarse, rule, options, search.centres);
  if (!centres) return tl::unexpected(centres.error());
  return finalists_of(coarse, std::span(*centres).first(std::min(centres->size(), finalists_max)), rule, ramp_share,
                      search.loop);
}

bool held(const Result<Planned>& planned) { return planned && planned->round.scallop.max_ratio <= scallop_kept; }

/// Length over that of a plane as large.
double flat_ratio(const EvenRound& round, const EvenSurface& surface, const IntervalRule& rule) {
  return round.length_mm * rule.interval_mm(0.0) / geometry::area_mm2(surface.mesh);
}

/// The centre found on a coarse mesh, the best few weighed by a better field, and the path around it; around another
/// where it falls into pieces or leaves far more than the scallop. `folded`: this centre, with folds; others too as
/// long as the path is long.
Result<Planned> planned_by(const Search& search, const EvenSurface& surface, const IntervalRule& rule,
                           const PathOptions& options, const std::optional<Centre>& folded = std::nullopt) {
  const double ramp_share = ramp_share_of(surface, rule);
  const auto coarse = coarse_surface(surface, search.coarse_triangles);
  if (!coarse) return tl::unexpected(coarse.error());
  PathOptions on_coarse = options;
  if (options.centre_loop > 0 && options.centre_loop < static_cast<int>(surface.topology.boundary_loops().size())) {
    on_coarse.centre_loop = moved_centre(surface, {Index{options.centre_loop}, {}}, *coarse).loop;
  }
  auto finalists = searched_finalists(*coarse, rule, on_coarse, ramp_share, search,
                                      folded ? std::optional(moved_centre(surface, *folded, *coarse)) : std::nullopt);
  if (!finalists) return tl::unexpected(finalists.error());
  Result<Planned> planned = geometry::bad_input("path-even-broken", "no centre was tried");
  for (const std::size_t i : tried_in_order(*finalists, search.centres.ridges)) {
    auto next = planned_around(surface, *coarse, (*finalists)[i], rule, ramp_share, search.loop);
    if (next && planned && weight(next->round) >= weight(planned->round)) continue;
    if (next || !planned) planned = std::move(next);
    if (held(planned) && (!folded || flat_ratio(planned->round, surface, rule) <= long_path)) break;
  }
  return planned;
}

/// As planned_by; where that leaves far more than the scallop, around a centre with arms along ridges too.
Result<Planned> planned_or_longer(Search search, const EvenSurface& surface, const IntervalRule& rule,
                                  const PathOptions& options) {
  auto planned = planned_by(search, surface, rule, options);
  if (held(planned) || options.centre_loop > 0 || search.centres.ridges) return planned;
  search.centres.ridges = true;
  auto next = planned_by(search, surface, rule, options);
  if (next && (!planned || weight(next->round) < weight(planned->round))) return next;
  return planned;
}

/// `rounder_mm`: length of the path with few corners, infinite where there is none.
std::string shorter_note(const Planned& planned, double rounder_mm) {
  const std::size_t folds = planned.domain.folds.size() + static_cast<std::size_t>(planned.round.path.splices);
  const std::string what =
      folds == 0 ? "even: passes bend sharply: with few corners "
                 : "even: passes turn back at " + std::to_string(2 * folds) +
                       " places and run the other way between them (path.cut_direction = climb or conventional forbids "
                       "it): without that ";
  if (!std::isfinite(rounder_mm)) return what + "there is no path in one piece";
  return what + "the path would be " + geometry::short_text(100.0 * (rounder_mm / planned.round.length_mm - 1.0), 2) +
         " % longer";
}

/// The usual search, and others with sharper bends and folds as long as the path is long. The lightest path goes on.
Result<Planned> planned_round(const EvenSurface& surface, const IntervalRule& rule, const PathOptions& options) {
  constexpr double shorter_by = 0.97;       // times the first path: for less, sharp bends and folds are not worth it
  constexpr double folds_area_min = 600.0;  // square intervals: on smaller surfaces a path loses most at its ends
  const double interval_mm = rule.interval_mm(0.0);
  const bool folds = options.cut_direction == CutDirection::any &&
                     geometry::area_mm2(surface.mesh) >= folds_area_min * interval_mm * interval_mm;
  auto planned = planned_or_longer({}, surface, rule, options);
  const double rounder_mm = planned ? planned->round.length_mm : std::numeric_limits<double>::infinity();
  double lighter_than = planned ? shorter_by * weight(planned->round) : std::numeric_limits<double>::infinity();
  for (const Search& search : searches_for_shorter(folds)) {
    if (planned && flat_ratio(planned->round, surface, rule) <= long_path) break;
    const bool folded = search.folds.folds_max > 0;
    if (folded && !planned) break;
    auto next = folded ? planned_by(search, surface, rule, options, planned->centre)
                       : planned_or_longer(search, surface, rule, options);
    if (!next || weight(next->round) >= lighter_than) continue;
    planned = std::move(next);
    lighter_than = weight(planned->round);
    planned->note = shorter_note(*planned, rounder_mm);
  }
  return planned;
}

}  // namespace

Result<CcPathResult> plan_even_spiral(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                      const PathOptions& options, const OrientationOptions& orientation) {
  auto conditioned = condition(surface, {.deviation_max_mm = std::min(0.05, 0.5 * options.scallop_mm)});
  if (!conditioned) return tl::unexpected(conditioned.error());
  const auto prepared = EvenSurface::build(conditioned->mesh);
  if (!prepared) return tl::unexpected(prepared.error());
  const IntervalField interval(prepared->mesh, interval_rule(cutter, options.scallop_mm, orientation),
                               prepared->curvature);
  const auto on = field_surface(*prepared, interval.rule());
  if (!on) return tl::unexpected(on.error());
  auto planned = planned_round(*on, interval.rule(), options);
  if (!planned) return tl::unexpected(planned.error());
  auto& [domain, round, note, centre] = *planned;

  const bool finer_given = on->mesh.triangles.size() < prepared->mesh.triangles.size();
  if (finer_given) round.cc = on_surface(*prepared, round.cc);
  CcPathResult out;
  out.surface.triangles = static_cast<int>(surface.triangles.size());
  out.surface.boundary_loops = static_cast<int>(prepared->topology.boundary_loops().size());
  out.surface.area_mm2 = geometry::area_mm2(surface);
  out.report = report_of(round, interval, options);
  if (!note.empty()) out.report.notes.push_back(std::move(note));
  out.map = drawing_of(domain, round.field);
  out.path = std::move(round.cc);
  return out;
}

}  // namespace volute::planner
