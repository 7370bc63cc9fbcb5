// From the poses of every interpolation cycle to the moves of a swept cutter.
#pragma once

#include "sim/machining/chord_thinner.hpp"
#include "sim/machining/cut_surface.hpp"

namespace volute::sim {

/// A pose's place: the tip, and the point `reach_mm` up the axis. So of every pose left out both stay within the
/// tolerance of the straight line between those of the poses kept. A kept pose carries the line of the move that ends
/// in it.
struct PosePlace {
  using Point = Eigen::Matrix<double, 6, 1>;
  double reach_mm = 0.0;
  [[nodiscard]] Point point(const SweptPose& p) const {
    Point out;
    out << p.pose.tip_P_mm, p.pose.tip_P_mm + reach_mm * p.pose.axis_P;
    return out;
  }
  [[nodiscard]] bool same_stretch(const SweptPose& a, const SweptPose& b) const { return a.rapid == b.rapid; }
};

class PoseThinner : public ChordThinner<SweptPose, PosePlace> {
 public:
  PoseThinner(double tolerance_mm, double reach_mm) : ChordThinner(tolerance_mm, PosePlace{reach_mm}) {}
};

}  // namespace volute::sim
