#include "planner/path/even_path.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "planner/path/level_trace.hpp"

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
        back.push_back({{previous, v, std::clamp((half_turn - fallen) / -change, 1e-7, 1.0 - 1e-7)}, 0.0});
      }
      break;
    }
    fallen -= change;
    theta = domain.theta.vertex[at(v)];
    previous = v;
    back.push_back({SurfacePoint::vertex(v), 0.0});
  }
  std::reverse(back.begin(), back.end());
  return back;
}

/// A closed line turned so that it begins next to `from` and its first step goes on in `direction`.
std::vector<EvenPathPoint> loop_from(const EvenDomain& domain, const LevelLine& line, const Vec3& from,
                                     const Vec3& direction, double turn) {
  const std::size_t n = line.points.size();
  std::size_t nearest = 0;
  double least = 1e300;
  for (std::size_t i = 0; i < n; ++i) {
    const double d = (position_mm(domain.mesh, line.points[i]) - from).squaredNorm();
    if (d < least) {
      least = d;
      nearest = i;
    }
  }
  const Vec3 ahead =
      position_mm(domain.mesh, line.points[(nearest + 1) % n]) - position_mm(domain.mesh, line.points[nearest]);
  const bool forward = ahead.dot(direction) >= 0.0;
  std::vector<EvenPathPoint> out;
  for (std::size_t step = 0; step <= n; ++step) {
    out.push_back({line.points[(forward ? nearest + step : nearest + n - step) % n], turn});
  }
  return out;
}

/// The longest closed line of phi = turn that runs around the centre.
const LevelLine* closing_line(const std::vector<LevelLine>& lines, const EvenDomain& domain, const EvenField& field,
                              double turn) {
  for (const LevelLine& line : lines) {
    if (line.closed && std::abs(value_at(field.phi, line.points.front()) - turn) < 0.25) return &line;
  }
  (void)domain;
  return nullptr;
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
  for (const SurfacePoint& p : main.points) {
    const double turn = value_at(field.phi, p);
    if (turn > last_turn) break;
    out.points.push_back({p, turn});
  }
  for (std::size_t i = 1; i < lines.size(); ++i) {
    double turn = 0.0;
    for (const SurfacePoint& p : lines[i].points) turn += value_at(field.phi, p);
    if (turn / static_cast<double>(lines[i].points.size()) < last_turn) ++out.pieces;
  }
  const auto closing = trace_levels(domain.mesh, domain.topology, {field.phi, {}}, last_turn - std::floor(last_turn));
  const LevelLine* loop = closing_line(closing, domain, field, last_turn);
  if (loop != nullptr && out.points.size() >= 2) {
    const Vec3 end = position_mm(domain.mesh, out.points.back().place);
    const Vec3 before = position_mm(domain.mesh, out.points[out.points.size() - 2].place);
    const auto closed = loop_from(domain, *loop, end, end - before, last_turn);
    out.points.insert(out.points.end(), closed.begin(), closed.end());
  }
  return out;
}

CcPath cc_path_of(const EvenDomain& domain, const EvenPath& path) {
  CcPiece piece;
  for (const EvenPathPoint& p : path.points) {
    CcPoint point;
    point.point_P_mm = vector_at(domain.mesh.vertices_mm, p.place);
    point.normal_P = vector_at(domain.vertex_normals, p.place).normalized();
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
