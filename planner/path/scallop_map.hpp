// The scallops that a path really leaves, measured densely: where the surface's normal enters the union of the balls
// along the path.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "planner/path/cc_path.hpp"
#include "planner/path/scallop_balls.hpp"
#include "planner/path/scallop_climb.hpp"

namespace volute::planner {

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
  /// Triangles with a sample over this share are sampled `thorough_per_edge`^2 times, and climbed from the highest of
  /// each third, whose crests may be as high. For verdicts; infinite: the highest of `per_edge`^2 alone leads uphill.
  double thorough_from_ratio = std::numeric_limits<double>::infinity();
  int thorough_per_edge = 9;
};

/// Heights at `per_edge`^2 points of each triangle, for the statistics by area; for the greatest ones also at boundary
/// vertices, along boundary edges, and uphill from the highest sample of a triangle. Balls of radius r stand on the
/// path's CC points (centre CC + r normal), densely along each segment of each piece. The height at a point x with
/// normal n is the least t with x + t n inside a ball; where no ball is met it is r: uncut. Heights below 0 (a ball
/// that gouges) count as they are, of the balls near by. Accuracy: the balls' spacing of an interval over 20 adds at
/// most 0.3 % of the allowed height. With `exact_from_ratio` most points are settled by the ball that served their
/// neighbour, five times faster. Requires: radius > scallop > 0, one normal a vertex. Deterministic on any number of
/// threads. Properties: 1. On a plane, passes at the exact interval give ratio 1, crests and corners of the surface
/// included. 2. No pass lowers a height when removed.
ScallopMap measure_scallop(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals, const CcPath& path,
                           double radius_mm, double scallop_mm, const ScallopSampling& sampling = {});

/// The same for one path after another that differ in places: triangles near which nothing changed keep their heights.
/// Requires: mesh and normals outlive the meter. Properties: 1. Each map equals that of measure_scallop, bit by bit.
/// 2. After a path that differs in one place few triangles are measured again.
class ScallopMeter {
 public:
  ScallopMeter(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals, double radius_mm, double scallop_mm,
               const ScallopSampling& sampling = {});
  ~ScallopMeter();
  ScallopMeter(ScallopMeter&&) = delete;
  ScallopMeter& operator=(ScallopMeter&&) = delete;

  /// The map of a path, valid until the next call.
  const ScallopMap& measure(const CcPath& path);
  /// Triangles that the last call looked at.
  [[nodiscard]] std::size_t measured() const { return measured_; }

 private:
  struct Last;
  ScallopEntry entry(const Last& last, std::size_t t, const Vec3& place, Index& guess, LookedAt& looked_at) const;
  SeenPlace highest_of(const Last& last, std::size_t t, const SeenPlace& sampled, Index& guess,
                       LookedAt& looked_at) const;
  void measure_triangle(Last& last, std::size_t t, Index& guess, LookedAt& looked_at) const;

  const TriangleMesh& mesh_;
  std::span<const Vec3> vertex_normals_;
  double radius_mm_, scallop_mm_;
  ScallopSampling sampling_;
  std::vector<Vec3> places_, thorough_places_;                ///< barycentric, the same in every triangle
  std::vector<std::size_t> order_;                            ///< in which triangles are measured
  std::map<std::size_t, std::vector<Vec3>> boundary_places_;  ///< of triangles at the boundary
  std::vector<double> area_mm2_;
  std::unique_ptr<Last> last_;
  std::size_t measured_ = 0;
};

}  // namespace volute::planner
