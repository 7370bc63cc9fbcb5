// The path as the control follows it: points in axis space, with what limits the way to each.
#pragma once

#include <cstdint>
#include <limits>

#include "kinematics/model/machine.hpp"
#include "sim/trace.hpp"

namespace volute::sim {

using geometry::Vec3;
/// d(tip mm in M)/dq.
using TipRates = Eigen::Matrix<double, 3, kinematics::axis_count>;

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// What is kept of one block of the program until its last sample is out.
struct BlockInfo {
  std::int64_t line = 0;
  std::int64_t ordinal = 0;  ///< blocks of the program are counted from 0
  bool rapid = false;
  bool feed_average = true;  ///< its plan goes through the average of feed moves, not through the longer one of rapids
  bool cutting = false;
  double tip_length_mm = 0.0;      ///< of the tip relative to the part
  double programmed_time_s = 0.0;  ///< what its feed asks; rapids: 0
  double time_s = 0.0;             ///< what it took
  double capped_s = 0.0;           ///< longest stay at one limit, and that limit
  Limit limit = Limit::programmed_feed;
  int axis = -1;
};

/// One point of the polygon that the control rounds; the piece of path that ends here belongs to `block`.
struct PathPoint {
  AxisVector q = AxisVector::Zero();
  TipRates tip_rates = TipRates::Zero();  ///< at q
  /// Length of the piece in the path parameter s: tip length in mm, or rotation_weight_mm_per_rad times the rotation
  /// where that is more.
  double length = 0.0;
  double speed_max = no_limit;  ///< of s on the piece
  Limit speed_limit = Limit::programmed_feed;
  /// How far the path may leave this point and the tip may leave the path around it; infinite: as the piece lengths
  /// allow.
  double corner_tolerance_mm = no_limit, corner_tolerance_rad = no_limit;
  double lag_tolerance_mm = no_limit, lag_tolerance_rad = no_limit;
  bool tcp = false;  ///< tolerances are held at the tip, else on the linear axes
  BlockInfo* block = nullptr;
};

/// A rotation without tip motion counts this many millimetres a radian in s.
constexpr double rotation_weight_mm_per_rad = 1.0;

}  // namespace volute::sim
