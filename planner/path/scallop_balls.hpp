// The balls that stand on a path, densely along it, and which of them enters a normal of the surface first.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "planner/path/cc_path.hpp"
#include "planner/path/point_grid.hpp"

namespace volute::planner {

using geometry::Index;

/// A place of the surface, its normal, and the ball, by its number along the path, that enters the normal first so far.
struct ScallopEntry {
  Vec3 point_mm = Vec3::Zero(), normal = Vec3::UnitZ();
  double height_mm = 0.0;
  Index ball = geometry::no_index;

  /// Where the normal is entered.
  [[nodiscard]] Vec3 entered_mm() const { return point_mm + height_mm * normal; }
};

/// All that was looked at: no ball outside the box has changed an answer.
using LookedAt = Eigen::AlignedBox3d;

/// Balls of one radius on a path's CC points (centre CC + r normal) and along each segment of each piece, a twentieth
/// of an interval apart at the most.
class ScallopBalls {
 public:
  ScallopBalls(const CcPath& path, double radius_mm, double interval_mm);

  [[nodiscard]] double radius_mm() const { return radius_mm_; }
  [[nodiscard]] const Vec3& centre_mm(Index ball) const { return along_[static_cast<std::size_t>(ball)]; }
  /// Do both search in the same cells? Then balls that both have are found, or left out, by both.
  [[nodiscard]] bool same_cells(const ScallopBalls& other) const { return cells_.cell_mm() == other.cells_.cell_mm(); }

  [[nodiscard]] ScallopEntry nothing_met(const Vec3& point_mm, const Vec3& normal) const {
    return {point_mm, normal, radius_mm_, geometry::no_index};
  }
  /// Where a ball enters the normal; infinite where it does not.
  [[nodiscard]] double height_mm(Index ball, const ScallopEntry& entry) const;

  /// Follows the path from a ball to where the height falls no more, or is low enough.
  void follow(Index from, double enough_mm, ScallopEntry& entry, LookedAt& looked_at) const;
  /// Takes a ball's height where the search looks at that ball anyway, so that what cannot enter below it is soon told.
  void begin_with(Index ball, ScallopEntry& entry) const;
  /// Every ball that may enter. What is seen within a short reach is never too low; only heights over `matters_mm` are
  /// worth a longer one. Where the surface is sharply convex the balls' centres stand farther apart than the passes.
  void search(double matters_mm, ScallopEntry& entry, LookedAt& looked_at) const;

 private:
  /// Balls that follow one another along the path and in the cells, and the chord from the first to the last.
  struct Run {
    Vec3 from_mm, chord_mm;
    double per_length_sq;  ///< one over the chord's squared length; 0: a single place
    double off_mm;         ///< no ball is farther from the chord
  };
  static double chord_distance_sq(const Run& run, const Vec3& place_mm);
  void find_runs();
  [[nodiscard]] Run run_of(std::span<const Vec3> balls) const;
  [[nodiscard]] bool misses(const Run& run, const ScallopEntry& entry) const;
  bool lower(const Vec3& centre_mm, Index ball, ScallopEntry& entry) const;
  void within(double reach_mm, ScallopEntry& entry, LookedAt& looked_at) const;

  std::vector<Vec3> along_, in_cells_;
  double radius_mm_, interval_mm_;
  PointGrid cells_;
  std::vector<Run> runs_;
  std::vector<std::size_t> run_begin_;  ///< its first ball in the cells, and the end
  std::vector<Index> run_of_;           ///< its number, of each ball in the cells
};

}  // namespace volute::planner
