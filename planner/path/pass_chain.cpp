#include "planner/path/pass_chain.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/mesh_measure.hpp"

namespace volute::planner {

double constant_interval_mm(const TriangleMesh& mesh, const IntervalField& intervals) {
  struct Share {
    double interval_mm, area_mm2;
  };
  std::vector<Share> shares;
  double area = 0.0, below = 0.0;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    shares.push_back({intervals.narrowest_interval_mm(t), geometry::triangle_area_mm2(mesh, t)});
    area += shares.back().area_mm2;
  }
  std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.interval_mm < b.interval_mm; });
  for (const Share& s : shares) {
    below += s.area_mm2;
    if (below > 0.01 * area) return s.interval_mm;
  }
  return shares.back().interval_mm;
}

std::vector<RawPoint> link_across(const SurfaceLocator& locator, const RawPoint& from, const RawPoint& to,
                                  double spacing_mm) {
  const Vec3 chord = to.point_mm - from.point_mm;
  const int parts = std::max(1, static_cast<int>(std::ceil(chord.norm() / spacing_mm)));
  std::vector<RawPoint> link{from};
  for (int k = 1; k < parts; ++k) {
    const double share = static_cast<double>(k) / parts;
    const auto hit = locator.nearest(from.point_mm + share * chord, chord.norm());
    if (hit) link.push_back({hit->point_mm, hit->normal, from.turn + share * (to.turn - from.turn), Vec3::Zero()});
  }
  link.push_back(to);
  return link;
}

void finish_runs(const std::vector<Run>& runs, const PathOptions& options, const CurveOptions& curve,
                 CcPathResult& result) {
  for (const Run& run : runs) result.path.pieces.push_back(finished_piece(run, options, curve));
  if (options.direction == Direction::outward) std::reverse(result.path.pieces.begin(), result.path.pieces.end());
  result.report.rapid_traversals = static_cast<int>(runs.size()) - 1;
  result.report.liftings = 2 * static_cast<int>(runs.size());
}

}  // namespace volute::planner
