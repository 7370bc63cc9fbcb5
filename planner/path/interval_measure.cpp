#include "planner/path/interval_measure.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/path/point_grid.hpp"

namespace volute::planner {

namespace {

constexpr std::size_t stride = 4;  ///< of the samples, every so many ask for their neighbour

/// Samples of the path that belong to passes.
struct TurnSamples {
  std::vector<Vec3> points;
  std::vector<double> turns;
};
TurnSamples turn_samples(const CcPath& path, double spacing_mm) {
  TurnSamples samples;
  for (const CcPiece& piece : path.pieces) {
    for (std::size_t i = 1; i < piece.points.size(); ++i) {
      const CcPoint &p = piece.points[i - 1], &q = piece.points[i];
      if (q.link) continue;
      const int parts = std::max(1, static_cast<int>(std::ceil((q.point_P_mm - p.point_P_mm).norm() / spacing_mm)));
      for (int k = 0; k < parts; ++k) {
        const double share = static_cast<double>(k) / parts;
        samples.points.push_back(p.point_P_mm + share * (q.point_P_mm - p.point_P_mm));
        samples.turns.push_back(p.turn + share * (q.turn - p.turn));
      }
    }
  }
  return samples;
}

std::vector<Vec3> centroids_of(const TriangleMesh& surface) {
  std::vector<Vec3> centroids;
  for (const geometry::Triangle& t : surface.triangles) {
    const auto at = [&](std::size_t k) -> const Vec3& { return surface.vertices_mm[static_cast<std::size_t>(t[k])]; };
    centroids.emplace_back((at(0) + at(1) + at(2)) / 3.0);
  }
  return centroids;
}

/// Where the next turn passes a place on the path, and what is allowed between them.
class NextTurn {
 public:
  NextTurn(const TriangleMesh& surface, const IntervalField& intervals, const TurnSamples& samples)
      : intervals_(intervals),
        samples_(samples),
        flat_mm_(intervals.rule().interval_mm(0.0)),
        grid_(samples.points, flat_mm_),
        centroids_(centroids_of(surface)),
        triangles_(centroids_, flat_mm_),
        normals_(geometry::triangle_normals(surface)) {}

  [[nodiscard]] std::optional<double> ratio(std::size_t i) const {
    const auto next = next_sample(i);
    if (!next) return std::nullopt;
    const Vec3 to_next = samples_.points[*next] - samples_.points[i];
    const auto triangle = triangle_at(samples_.points[i] + 0.5 * to_next);
    if (!triangle) return std::nullopt;
    const Vec3& normal = normals_[*triangle];
    const Vec3 across = to_next - to_next.dot(normal) * normal;
    if (across.isZero()) return std::nullopt;
    return to_next.norm() / intervals_.interval_mm(static_cast<Index>(*triangle), across.normalized());
  }

 private:
  [[nodiscard]] std::optional<std::size_t> next_sample(std::size_t i) const {
    const Vec3& here = samples_.points[i];
    double nearest_mm = 3.0 * flat_mm_;
    std::optional<std::size_t> next;
    grid_.near(here, nearest_mm, [&](Index j) {
      const auto k = static_cast<std::size_t>(j);
      const double distance = (samples_.points[k] - here).norm(), turns = samples_.turns[k] - samples_.turns[i];
      if (distance >= nearest_mm || turns < 0.6 || turns > 1.4) return;
      nearest_mm = distance;
      next = k;
    });
    return next;
  }
  [[nodiscard]] std::optional<std::size_t> triangle_at(const Vec3& place) const {
    std::optional<std::size_t> nearest;
    triangles_.near(place, flat_mm_, [&](Index j) {
      const auto k = static_cast<std::size_t>(j);
      if (!nearest || (centroids_[k] - place).squaredNorm() < (centroids_[*nearest] - place).squaredNorm()) nearest = k;
    });
    return nearest;
  }

  const IntervalField& intervals_;
  const TurnSamples& samples_;
  double flat_mm_;
  PointGrid grid_;
  std::vector<Vec3> centroids_;
  PointGrid triangles_;
  std::vector<Vec3> normals_;
};

}  // namespace

std::vector<IntervalSample> interval_samples(const TriangleMesh& surface, const IntervalField& intervals,
                                             const CcPath& path) {
  const TurnSamples samples = turn_samples(path, 0.125 * intervals.rule().interval_mm(0.0));
  const NextTurn next(surface, intervals, samples);
  std::vector<std::optional<double>> ratio((samples.points.size() + stride - 1) / stride);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, ratio.size(), 64),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t k = range.begin(); k < range.end(); ++k) ratio[k] = next.ratio(stride * k);
                    });
  std::vector<IntervalSample> found;
  for (std::size_t k = 0; k < ratio.size(); ++k)
    if (ratio[k]) found.push_back({samples.points[stride * k], samples.turns[stride * k], *ratio[k]});
  return found;
}

}  // namespace volute::planner
