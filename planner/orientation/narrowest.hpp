// Where along the path the least is allowed.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/orientation/allowed_set.hpp"

namespace volute::planner {

/// The share of a 5 degree raster of directions within the limits of tilt that is allowed at station i.
double allowed_share(const AllowedSet& allowed, int i);

/// Stations in the order of their allowed_share, the least first, equal ones as they were given. A station is asked no
/// further than it takes to see that others have less: what was found free so far bounds its share from below.
///
/// Properties, each with a test of that name: 1. NarrowestComeInTheOrderOfTheirShares. 2. FewerAreAskedThanThereAre.
class NarrowestSearch {
 public:
  /// `allowed` has to outlive the search.
  NarrowestSearch(const AllowedSet& allowed, std::span<const int> stations);
  /// Nothing when all have come.
  std::optional<int> next();
  /// Orientations asked so far.
  [[nodiscard]] int asked() const;

 private:
  struct Direction {
    geometry::Angle tilt, yaw;
  };
  struct Candidate {
    int station = 0, place = 0;  ///< place: as given
    int asked = 0, free = 0;
  };
  [[nodiscard]] bool is_known(const Candidate& candidate) const;
  void ask_on(Candidate& candidate) const;

  const AllowedSet& allowed_;
  std::vector<Direction> raster_;
  std::vector<Candidate> heap_;  ///< the least share so far on top
  int asked_ = 0;
};

}  // namespace volute::planner
