// The scallops that a path really leaves, measured densely: where the surface's normal enters the union of the balls
// along the path.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "planner/path/cc_path.hpp"

namespace volute::planner {

using geometry::Index;
using geometry::TriangleMesh;

struct ScallopMap {
  std::vector<double> worst_ratio;     ///< per triangle: greatest height over the allowed one
  std::vector<Vec3> worst_place_P_mm;  ///< per triangle: where that is
  ScallopStatistics statistics;        ///< weighted by area
};

struct ScallopSampling {
  int per_edge = 3;               ///< squared: the points of a triangle
  double exact_from_ratio = 0.0;  ///< heights below this share of the allowed one may be given as too high, up to it
  /// Triangles with a sample over this share are looked at more closely, from that sample uphill: a crest is narrower
  /// than the samples are apart.
  double closer_from_ratio = 0.8;
};

/// Heights at `per_edge`^2 points of each triangle, for the statistics by area; for the greatest ones also at boundary
/// vertices, along boundary edges, and uphill from the highest sample of a triangle. Balls of radius r stand on the
/// path's CC points (centre CC + r normal), densely along each segment of each piece. The height at a point x with
/// normal n is the least t with x + t n inside a ball; where no ball is met it is r: uncut. Heights below 0 (a ball
/// that gouges) count as they are. Accuracy: the balls' spacing of an interval over 20 adds at most 0.3 % of the
/// allowed height. With `exact_from_ratio` most points are settled by the ball that served their neighbour, five times
/// faster. Requires: radius > scallop > 0, one normal a vertex. Deterministic on any number of threads. Properties: 1.
/// On a plane, passes at the exact interval give ratio 1, crests and corners of the surface included. 2. No pass lowers
/// a height when removed.
ScallopMap measure_scallop(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals, const CcPath& path,
                           double radius_mm, double scallop_mm, const ScallopSampling& sampling = {});

}  // namespace volute::planner
