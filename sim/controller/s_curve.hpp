// The S-curve: from rest to rest with bounded jerk, in seven phases.
#pragma once

#include <array>

namespace volute::sim {

/// Way and its derivatives in time.
struct Progress {
  double way = 0.0, speed = 0.0, acceleration = 0.0, jerk = 0.0;
};

/// One unit of way in one unit of time: jerk up, even acceleration, jerk down, even speed, and the mirror image of
/// these. Property 1: way, speed and acceleration are continuous and are 0, 0, 0 at the start and 1, 0, 0 at the
/// end. 2. Speed is never negative. 3. Within a phase jerk is constant and neither acceleration nor the growth of speed
/// changes sign.
class SCurve {
 public:
  static constexpr int phases = 7;
  /// `jerk_share` of the time is spent changing the acceleration, `even_share` of the rest at the greatest
  /// acceleration, what remains at the greatest speed. Requires: 0 < jerk_share <= 1, 0 <= even_share <= 1.
  SCurve(double jerk_share, double even_share);

  /// When phase k begins; phase 7 begins at 1.
  [[nodiscard]] double begin(int phase) const { return begin_[static_cast<std::size_t>(phase)]; }
  /// At a time of that phase.
  [[nodiscard]] Progress at(int phase, double time) const;
  [[nodiscard]] Progress at(double time) const;

 private:
  std::array<double, phases + 1> begin_{};
  std::array<Progress, phases / 2 + 1> start_{};  ///< of the first half; the second is its mirror image
};

/// The shape of the quickest S-curve over a unit of way under bounds of speed, acceleration and jerk.
struct SCurveShape {
  double jerk_share = 1.0, even_share = 0.0;
};
/// Requires: all three > 0; speed and acceleration may be infinite.
SCurveShape quickest_shape(double speed, double acceleration, double jerk);

}  // namespace volute::sim
