// The calm direction of a spiral that is cut in several pieces: the same for both ends of every rapid.
#pragma once

#include <optional>
#include <vector>

#include "planner/options.hpp"
#include "planner/path/cc_path.hpp"

namespace volute::planner {

/// The sum of the planned axes (tilt and yaw in the feed frame) over one turn round a place of the whole path, weighed
/// by length. A piece that is shorter than a turn has no turn to average its lean over; by itself it would lean along
/// its own feed, the next piece along another, and a rotary would go round with the feed in the rapids between them.
class TurnMeans {
 public:
  /// Nothing: the path is one piece (which has its own turns), or its turns do not rise from the first piece to the
  /// last by more than one.
  static std::optional<TurnMeans> of(const CcPath& path, const OrientationOptions& options, double feed_window_mm);

  /// Mean over half a turn to both sides; shorter than a unit vector where the axes differ. Requires: a turn of the
  /// path.
  [[nodiscard]] Vec3 mean(double turn) const;

 private:
  std::vector<double> turns_;    ///< of every point, rising
  std::vector<double> lengths_;  ///< sums before each point, and of all
  std::vector<Vec3> sums_;
};

}  // namespace volute::planner
