// Ways through the middle of a surface: where slits leave equal room on either side.
#pragma once

#include <utility>
#include <vector>

#include "planner/path/even_domain.hpp"

namespace volute::planner {

/// Distances and ways along the edges of a mesh.
class RidgeWays {
 public:
  explicit RidgeWays(const TriangleMesh& mesh);

  /// Edge-path distance of every vertex from a set, mm; infinite where none is reached.
  [[nodiscard]] std::vector<double> distance_mm(const std::vector<Index>& sources) const;

  /// The way from one of the sources to `to` that costs least, an edge its length over the square of `room_mm` there:
  /// it seeks the ridge of the room. Corners of the way that lie within `kept_mm` of the chords are left out; the first
  /// is a source, the last is `to`. Empty where no way leads there. Requires: room_mm >= 0, one a vertex.
  [[nodiscard]] std::vector<Index> way(const std::vector<Index>& sources, Index to, const std::vector<double>& room_mm,
                                       double kept_mm) const;

 private:
  const TriangleMesh* mesh_;
  std::vector<std::vector<std::pair<double, Index>>> next_;  ///< per vertex: length of an edge, its other end
};

}  // namespace volute::planner
