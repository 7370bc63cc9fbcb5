#include "planner/path/start_point.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "geometry/mesh_measure.hpp"

namespace volute::planner {

namespace {

double length_of(const std::vector<CcPoint>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i].point_P_mm - points[i - 1].point_P_mm).norm();
  return length;
}

/// Vertices of the outer boundary from the start to the path's first point, the way that the path runs.
double lead_along_boundary(CcPiece& piece, const TriangleMesh& surface, const geometry::MeshTopology& topology,
                           const Vec3& start_P_mm, Sense sense) {
  const std::vector<Index>& loop = topology.boundary_loops()[0].vertices;
  const auto place = [&](std::size_t i) -> const Vec3& {
    return surface.vertices_mm[static_cast<std::size_t>(loop[i])];
  };
  const auto nearest = [&](const Vec3& p) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < loop.size(); ++i)
      if ((place(i) - p).squaredNorm() < (place(best) - p).squaredNorm()) best = i;
    return best;
  };
  const std::size_t n = loop.size(), step = sense == Sense::counter_clockwise ? 1 : n - 1;
  const std::vector<Vec3> normals = geometry::vertex_normals(surface);
  const CcPoint& first = piece.points.front();
  std::vector<CcPoint> run;
  for (std::size_t i = nearest(start_P_mm), end = nearest(first.point_P_mm); i != end; i = (i + step) % n)
    run.push_back({place(i), normals[static_cast<std::size_t>(loop[i])], first.turn, false});
  if (run.empty()) return 0.0;
  run.push_back(first);
  const double added = length_of(run);
  piece.points.insert(piece.points.begin(), run.begin(), run.end() - 1);
  return added;
}

/// The closing loop's points again, up to the one nearest to the start.
double lengthen_closing_loop(CcPiece& piece, const Vec3& start_P_mm) {
  constexpr double same_turn = 1e-9, closed_mm = 1e-6;
  const double turn = piece.points.back().turn;
  std::size_t first = piece.points.size();
  while (first > 0 && std::abs(piece.points[first - 1].turn - turn) < same_turn) --first;
  const std::vector<CcPoint> loop(piece.points.begin() + static_cast<std::ptrdiff_t>(first), piece.points.end());
  if (loop.size() < 3 || (loop.front().point_P_mm - loop.back().point_P_mm).norm() > closed_mm) return 0.0;
  const auto end = std::min_element(loop.begin(), loop.end() - 1, [&](const CcPoint& a, const CcPoint& b) {
    return (a.point_P_mm - start_P_mm).squaredNorm() < (b.point_P_mm - start_P_mm).squaredNorm();
  });
  piece.points.insert(piece.points.end(), loop.begin() + (end == loop.begin() ? 0 : 1),
                      end == loop.begin() ? loop.begin() : end + 1);
  return length_of({loop.begin(), end + 1});
}

}  // namespace

double begin_at(CcPiece& inward_piece, const TriangleMesh& surface, const geometry::MeshTopology& topology,
                const Vec3& start_P_mm, Direction direction, Sense sense) {
  VOLUTE_CHECK(inward_piece.points.size() >= 2 && !topology.boundary_loops().empty(), inward_piece.points.size());
  return direction == Direction::inward ? lead_along_boundary(inward_piece, surface, topology, start_P_mm, sense)
                                        : lengthen_closing_loop(inward_piece, start_P_mm);
}

}  // namespace volute::planner
