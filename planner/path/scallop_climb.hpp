// From a place of a triangle uphill to where the scallop is highest: crests are narrower than samples are apart.
#pragma once

#include <array>

#include "planner/path/scallop_balls.hpp"

namespace volute::planner {

using geometry::TriangleMesh;

/// A triangle, to walk on.
class Facet {
 public:
  Facet(const TriangleMesh& mesh, std::size_t triangle);
  /// Root of twice the area: 0 where there is nothing to walk on.
  [[nodiscard]] double size_mm() const { return size_mm_; }
  [[nodiscard]] Vec3 in_plane(const Vec3& v) const { return v - v.dot(normal_) * normal_; }
  /// Barycentric place `step_mm` from `from` along a direction, or as far as the triangle goes; on an edge that the
  /// direction leaves by, along that edge. Requires: size_mm() > 0.
  [[nodiscard]] Vec3 walked(const Vec3& from, const Vec3& direction, double step_mm) const;

 private:
  [[nodiscard]] Vec3 shares(const Vec3& way_mm) const;
  std::array<Vec3, 3> corner_mm_, hat_per_mm_;
  Vec3 normal_;
  double size_mm_;
};

/// A barycentric place of a triangle and what enters its normal first.
struct SeenPlace {
  Vec3 place;
  ScallopEntry entry;
};

/// How the height to a ball grows along the triangle.
Vec3 height_slope(const ScallopBalls& balls, const Facet& facet, const ScallopEntry& entry, Index ball);

/// The way up a crest between two slopes: the shortest vector to the line between their ends; both rise along it.
Vec3 along_crest(const Vec3& a, const Vec3& b);

/// Share of the way from one place to another at which the ball of the one and that of the other enter as high.
double crest_share(const ScallopBalls& balls, const ScallopEntry& from, const ScallopEntry& to);

/// Walks uphill from a place seen: away from the ball that enters there, onto the crest between it and the next one,
/// and up that crest. `look_at(place)` answers what is seen at each place on the way and keeps the highest.
template <class LookAt>
void climb_scallop(const ScallopBalls& balls, const Facet& facet, SeenPlace here, double step_mm, LookAt look_at) {
  constexpr int rounds = 8, shorter_max = 3;
  constexpr double level = 0.1;  // of the slopes beside a crest: it rises no more
  for (int round = 0, shorter = 0; round < rounds && shorter < shorter_max; ++round) {
    if (here.entry.ball == geometry::no_index) return;  // uncut: no place is higher
    const Vec3 up = height_slope(balls, facet, here.entry, here.entry.ball);
    SeenPlace next = look_at(facet.walked(here.place, up, step_mm));
    if (next.entry.height_mm <= here.entry.height_mm && next.entry.ball != geometry::no_index) {
      const SeenPlace beyond = next;
      next = look_at(here.place + crest_share(balls, here.entry, beyond.entry) * (beyond.place - here.place));
      const Vec3 other = height_slope(balls, facet, next.entry, beyond.entry.ball);
      const Vec3 crest = along_crest(height_slope(balls, facet, next.entry, here.entry.ball), other);
      if (crest.norm() > level * other.norm()) {
        const SeenPlace farther = look_at(facet.walked(next.place, crest, step_mm));
        if (farther.entry.height_mm > next.entry.height_mm) next = farther;
      } else if (next.entry.height_mm <= here.entry.height_mm) {
        return;
      }
    }
    if (next.entry.height_mm > here.entry.height_mm) {
      here = next;
    } else {
      ++shorter;
      step_mm *= 0.4;
    }
  }
}

}  // namespace volute::planner
