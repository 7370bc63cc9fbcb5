#include "planner/path/even_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "planner/path/even_ending.hpp"
#include "planner/path/even_fold.hpp"
#include "planner/path/even_prolong.hpp"
#include "planner/path/level_trace.hpp"
#include "planner/surface/edge_curve.hpp"

namespace volute::planner {
namespace {

using geometry::at;
using geometry::BoundaryLoop;

double value_at(const std::vector<double>& values, const SurfacePoint& p) {
  return p.is_vertex() ? values[at(p.a)] : (1.0 - p.t) * values[at(p.a)] + p.t * values[at(p.b)];
}

Vec3 vector_at(const std::vector<Vec3>& values, const SurfacePoint& p) {
  return p.is_vertex() ? values[at(p.a)] : Vec3((1.0 - p.t) * values[at(p.a)] + p.t * values[at(p.b)]);
}

/// The outer boundary backwards from `start` until theta has fallen by half a turn, in the order in which the tool
/// runs.
std::vector<EvenPathPoint> boundary_half_turn(const EvenDomain& domain, const SurfacePoint& start) {
  constexpr double half_turn =
      0.49;  // where theta stands still (gathered growth) the half itself might never be passed
  const auto& loop = domain.outer.vertices;
  const std::size_t n = loop.size();
  std::size_t i = 0;
  while (i < n && !(start.touches(loop[i]) && start.touches(loop[(i + 1) % n]))) ++i;
  VOLUTE_CHECK(i < n, start.a, start.b);
  std::vector<EvenPathPoint> back;
  double fallen = 0.0, theta = value_at(domain.theta.vertex, start);
  Index previous = geometry::no_index;
  for (std::size_t step = 0; step < n; ++step) {
    const Index v = loop[(i + n - step) % n];
    // Neighbouring vertices differ by far less than a turn: the whole turns between them are the seam's.
    const double change = std::remainder(domain.theta.vertex[at(v)] - theta, 1.0);
    if (fallen - change >= half_turn) {
      if (previous != geometry::no_index) {
        back.push_back({{previous, v, std::clamp((half_turn - fallen) / -change, 1e-7, 1.0 - 1e-7)}, 0.0, {}, 0.0});
      }
      break;
    }
    fallen -= change;
    theta = domain.theta.vertex[at(v)];
    previous = v;
    back.push_back({SurfacePoint::vertex(v), 0.0, {}, 0.0});
  }
  std::reverse(back.begin(), back.end());
  return back;
}

/// Once around a closed line from `crossing`, a point of the line's segment in `triangle`, back to it. Both lines have
/// greater values on their left, so the direction is that of the spiral. Empty where the line does not pass the
/// triangle.
std::vector<EvenPathPoint> once_around(const LevelLine& line, Index triangle, const EvenPathPoint& crossing) {
  const auto found = std::find(line.triangles.begin(), line.triangles.end(), triangle);
  if (found == line.triangles.end()) return {};
  const std::size_t n = line.points.size(), segment = static_cast<std::size_t>(found - line.triangles.begin());
  std::vector<EvenPathPoint> out = {crossing};
  for (std::size_t step = 1; step <= n; ++step)
    out.push_back({line.points[(segment + step) % n], crossing.turn, {}, 0.0});
  out.push_back(crossing);
  return out;
}

std::vector<Vec3> positions(const TriangleMesh& mesh, const SurfacePath& path) {
  std::vector<Vec3> out;
  for (const SurfacePoint& p : path) out.push_back(position_mm(mesh, p));
  return out;
}

/// The closed line of a turn that passes through a triangle.
std::optional<LevelLine> turn_through(const EvenDomain& domain, const EvenField& field, double turn, Index triangle) {
  for (LevelLine& line : trace_levels(domain.mesh, domain.topology, {field.phi, {}}, turn - std::floor(turn))) {
    if (!line.closed || std::abs(value_at(field.phi, line.points.front()) - turn) > 0.25) continue;
    if (std::find(line.triangles.begin(), line.triangles.end(), triangle) != line.triangles.end())
      return std::move(line);
  }
  return {};
}

/// From the last turn, a full interval outside the slit, into the slit and along it; false where it has no way in.
bool append_slit(const EvenDomain& domain, const LevelLine& line, Index triangle, const EvenPathPoint& crossing,
                 double turns, double interval_mm, EvenPath& out) {
  std::vector<Vec3> slit;
  for (Index v : slit_line(domain)) slit.push_back(domain.mesh.vertices_mm[at(v)]);
  if (slit.size() < 3) return false;
  const std::size_t n = line.points.size();
  const auto segment = static_cast<std::size_t>(std::find(line.triangles.begin(), line.triangles.end(), triangle) -
                                                line.triangles.begin());
  const LastTurn turn{positions(domain.mesh, line.points), (segment + 1) % n};
  const SlitEnding ending = slit_ending(slit, turn, interval_mm);
  if (ending.points_mm.empty()) return false;
  out.points.push_back(crossing);
  for (std::size_t step = 0; step <= ending.steps; ++step)
    out.points.push_back({line.points[(turn.begin + step) % n], crossing.turn, {}, 0.0});
  out.ending_mm = ending.points_mm;
  out.ending_turn = turns;
  return true;
}

/// The spiral cut off where phi first passes `last_turn` (with folds, where passes lead inward and out again: where it
/// does so last); it goes on from `crossing` in `triangle`.
struct CutOff {
  EvenPathPoint crossing;
  Index triangle = geometry::no_index;
};
std::optional<CutOff> cut_off(const EvenField& field, const LevelLine& main, double last_turn, bool folded,
                              EvenPath& out) {
  const auto within = [&](const SurfacePoint& p) { return value_at(field.phi, p) <= last_turn; };
  const auto end = folded ? std::find_if(main.points.rbegin(), main.points.rend(), within).base()
                          : std::find_if_not(main.points.begin(), main.points.end(), within);
  const auto i = static_cast<std::size_t>(end - main.points.begin());
  for (std::size_t k = 0; k < i; ++k)
    out.points.push_back({main.points[k], value_at(field.phi, main.points[k]), {}, 0.0});
  if (i == 0 || i == main.points.size()) return {};
  const double before = value_at(field.phi, main.points[i - 1]), after = value_at(field.phi, main.points[i]);
  return CutOff{{main.points[i - 1], last_turn, main.points[i], (last_turn - before) / (after - before)},
                main.triangles[i - 1]};
}

/// The spiral and its end: in a slit, a last turn one interval outside it and the slit itself; else once around the
/// line half an interval before the centre. Returns the last turn that belongs to the spiral.
double append_spiral(const EvenDomain& domain, const EvenField& field, const LevelLine& main, double interval_mm,
                     EvenPath& out) {
  const std::size_t begin = out.points.size();
  if (!slit_line(domain).empty() && field.turns > 2.0) {
    const double last_turn = field.turns - 1.0;
    const auto end = cut_off(field, main, last_turn, !domain.folds.empty(), out);
    const auto line = end ? turn_through(domain, field, last_turn, end->triangle) : std::nullopt;
    if (line && append_slit(domain, *line, end->triangle, end->crossing, field.turns, interval_mm, out))
      return last_turn;
    out.points.resize(begin);
  }
  const double last_turn = field.turns - 0.5;
  const auto end = cut_off(field, main, last_turn, !domain.folds.empty(), out);
  const auto line = end ? turn_through(domain, field, last_turn, end->triangle) : std::nullopt;
  if (line) {
    const auto closing = once_around(*line, end->triangle, end->crossing);
    out.points.insert(out.points.end(), closing.begin(), closing.end());
  }
  return last_turn;
}

/// The point of the nominal surface over an edge, [Sun2016] eq. 15, 16.
Vec3 on_edge_curve(const EvenDomain& domain, const SurfacePoint& p) {
  return EdgeCurve(domain.mesh.vertices_mm[at(p.a)], domain.mesh.vertices_mm[at(p.b)], domain.vertex_normals[at(p.a)],
                   domain.vertex_normals[at(p.b)])
      .point_mm(p.t);
}

double mean_turn(const EvenField& field, const LevelLine& line) {
  double sum = 0.0;
  for (const SurfacePoint& p : line.points) sum += value_at(field.phi, p);
  return sum / static_cast<double>(line.points.size());
}

/// A ring no longer than the circle of one interval across: around a vertex that stands out of the field. The passes
/// beside it cover what it encloses, and the scallop map sees where they do not.
bool is_ripple(const EvenDomain& domain, const LevelLine& line, double interval_mm) {
  if (!line.closed) return false;
  const auto places = positions(domain.mesh, line.points);
  double length_mm = (places.front() - places.back()).norm();
  for (std::size_t i = 1; i < places.size(); ++i) length_mm += (places[i] - places[i - 1]).norm();
  return length_mm <= std::numbers::pi * interval_mm;
}

bool same_place(const CcPoint& a, const CcPoint& b) {
  constexpr double same_point_mm = 1e-6;
  return (a.point_P_mm - b.point_P_mm).norm() < same_point_mm;
}

/// Where folds have left rings, the first line runs them too, and they leave the list. Returns how many.
int splice_rings(const EvenDomain& domain, const EvenField& field, double interval_mm, std::vector<LevelLine>& lines) {
  constexpr double reach_intervals = 1.5;
  int spliced = 0;
  for (std::size_t i = 1; i < lines.size();) {
    const LevelLine& ring = lines[i];
    const bool lost =
        ring.closed && mean_turn(field, ring) < field.turns - 1.0 && !is_ripple(domain, ring, interval_mm);
    if (!lost || !splice(domain.mesh, ring, reach_intervals * interval_mm, lines.front())) {
      ++i;
      continue;
    }
    ++spliced;
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return spliced;
}

}  // namespace

EvenPath even_path(const EvenDomain& domain, const EvenField& field, double interval_mm) {
  std::vector<double> winding(field.phi.size());
  for (std::size_t v = 0; v < winding.size(); ++v) winding[v] = field.phi[v] - domain.theta.vertex[v];
  const auto torn = torn_edges(domain);
  auto lines =
      joined_at_folds(domain, trace_levels(domain.mesh, domain.topology, {winding, domain.theta.jump, torn}, 0.5));
  EvenPath out;
  if (lines.empty() || lines.front().closed) {
    out.pieces = 0;
    return out;
  }
  if (!domain.folds.empty()) out.splices = splice_rings(domain, field, interval_mm, lines);
  const LevelLine& main = lines.front();
  out.points = boundary_half_turn(domain, main.points.front());
  const double last_turn = append_spiral(domain, field, main, interval_mm, out);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (mean_turn(field, lines[i]) < last_turn && !is_ripple(domain, lines[i], interval_mm)) ++out.pieces;
  }
  return out;
}

CcPath cc_path_of(const EvenDomain& domain, const EvenPath& path) {
  CcPiece piece;
  for (const EvenPathPoint& p : path.points) {
    CcPoint point;
    const auto vector_of = [&](const std::vector<Vec3>& values) {
      const Vec3 from = vector_at(values, p.place);
      return p.share > 0.0 ? Vec3(from + p.share * (vector_at(values, p.toward) - from)) : from;
    };
    point.point_P_mm =
        p.share > 0.0 || p.place.is_vertex() ? vector_of(domain.mesh.vertices_mm) : on_edge_curve(domain, p.place);
    point.normal_P = vector_of(domain.vertex_normals).normalized();
    point.turn = p.turn;
    if (!piece.points.empty() && same_place(piece.points.back(), point)) continue;
    piece.points.push_back(point);
  }
  // Between the ends of folds phi is no number of turns: there it stands still at the greatest so far.
  if (!domain.folds.empty()) {
    for (std::size_t i = 1; i < piece.points.size(); ++i)
      piece.points[i].turn = std::max(piece.points[i].turn, piece.points[i - 1].turn);
  }
  CcPath out;
  out.pieces.push_back(std::move(piece));
  if (!path.ending_mm.empty()) {
    const auto ending = on_mesh(domain.mesh, domain.vertex_normals, domain.operators, path.ending_mm);
    const double from = path.points.back().turn;
    for (std::size_t i = 0; i < ending.size(); ++i) {
      CcPoint p = ending[i];
      p.turn = from + (path.ending_turn - from) * static_cast<double>(i + 1) / static_cast<double>(ending.size());
      if (!same_place(out.pieces[0].points.back(), p)) out.pieces[0].points.push_back(p);
    }
  }
  return out;
}

}  // namespace volute::planner
