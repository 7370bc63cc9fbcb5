#include "planner/path/even_path.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "planner/path/level_trace.hpp"
#include "planner/surface/edge_curve.hpp"

namespace volute::planner {
namespace {

using geometry::BoundaryLoop;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

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

/// The spiral cut off where phi first passes `last_turn`, then once around the line of that turn.
void append_spiral(const EvenDomain& domain, const EvenField& field, const LevelLine& main, double last_turn,
                   EvenPath& out) {
  std::size_t i = 0;
  for (; i < main.points.size() && value_at(field.phi, main.points[i]) <= last_turn; ++i) {
    out.points.push_back({main.points[i], value_at(field.phi, main.points[i]), {}, 0.0});
  }
  if (i == 0 || i == main.points.size()) return;
  const double before = value_at(field.phi, main.points[i - 1]), after = value_at(field.phi, main.points[i]);
  const EvenPathPoint crossing{main.points[i - 1], last_turn, main.points[i], (last_turn - before) / (after - before)};
  for (const LevelLine& line :
       trace_levels(domain.mesh, domain.topology, {field.phi, {}}, last_turn - std::floor(last_turn))) {
    if (!line.closed || std::abs(value_at(field.phi, line.points.front()) - last_turn) > 0.25) continue;
    const auto closing = once_around(line, main.triangles[i - 1], crossing);
    out.points.insert(out.points.end(), closing.begin(), closing.end());
    if (!closing.empty()) return;
  }
}

/// The point of the nominal surface over an edge, [Sun2016] eq. 15, 16.
Vec3 on_edge_curve(const EvenDomain& domain, const SurfacePoint& p) {
  return EdgeCurve(domain.mesh.vertices_mm[at(p.a)], domain.mesh.vertices_mm[at(p.b)], domain.vertex_normals[at(p.a)],
                   domain.vertex_normals[at(p.b)])
      .point_mm(p.t);
}

}  // namespace

EvenPath even_path(const EvenDomain& domain, const EvenField& field) {
  std::vector<double> winding(field.phi.size());
  for (std::size_t v = 0; v < winding.size(); ++v) winding[v] = field.phi[v] - domain.theta.vertex[v];
  const auto lines = trace_levels(domain.mesh, domain.topology, {winding, domain.theta.jump}, 0.5);
  EvenPath out;
  if (lines.empty() || lines.front().closed) {
    out.pieces = 0;
    return out;
  }
  const double last_turn = field.turns - 0.5;
  const LevelLine& main = lines.front();
  out.points = boundary_half_turn(domain, main.points.front());
  append_spiral(domain, field, main, last_turn, out);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    double turn = 0.0;
    for (const SurfacePoint& p : lines[i].points) turn += value_at(field.phi, p);
    if (turn / static_cast<double>(lines[i].points.size()) < last_turn) ++out.pieces;
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
    constexpr double same_point_mm = 1e-6;
    if (!piece.points.empty() && (piece.points.back().point_P_mm - point.point_P_mm).norm() < same_point_mm) continue;
    piece.points.push_back(point);
  }
  CcPath out;
  out.pieces.push_back(std::move(piece));
  return out;
}

}  // namespace volute::planner
