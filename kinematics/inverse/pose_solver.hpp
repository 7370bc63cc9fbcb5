// What the direction problem and the linear axes need of a machine, worked out once for a whole path. Private to
// kinematics/inverse.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "kinematics/inverse/inverse.hpp"

namespace volute::kinematics {

/// Of two vectors, in [0, pi]; exact near both ends.
inline double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// 0, 1 or 2 ways to point the tool, kept in place.
struct RotarySolutions {
  std::array<RotarySolution, 2> way{};
  std::size_t count = 0;
  [[nodiscard]] std::span<const RotarySolution> all() const { return {way.data(), count}; }
};

/// Closed-form inverse kinematics of one machine with one tool.
class PoseSolver {
 public:
  PoseSolver(const Machine& machine, double tool_length_mm);

  /// As solve_rotaries. The length of `axis_M` does not matter.
  [[nodiscard]] RotarySolutions rotaries(const Vec3& axis_M) const;
  /// As solve_linear.
  [[nodiscard]] AxisVector linear(const Vec3& tip_M_mm, double first_rad, double second_rad) const;
  /// Where the tool points (in M) with the rotaries so.
  [[nodiscard]] Vec3 axis_M(double first_rad, double second_rad) const;
  /// The pose in M at any axis position: the tip, and where the tool points.
  [[nodiscard]] ToolPose pose_M(const AxisVector& q) const;

 private:
  /// A rotary and its line.
  struct Turn {
    int axis = 3;
    Vec3 direction, point;
    double zero = 0.0;
  };
  /// Sine and cosine of how far a rotary has turned from the machine's zero pose.
  struct Angle2 {
    double sine, cosine;
  };
  /// R v for a constant v: along + cosine across + sine ahead.
  struct TurnedVector {
    Vec3 along, across, ahead;
    TurnedVector() = default;
    TurnedVector(const Vec3& direction, const Vec3& v);
    [[nodiscard]] Vec3 at(const Angle2& angle) const { return along + angle.cosine * across + angle.sine * ahead; }
  };
  /// A linear axis and how many of the two rotaries (workpiece first) stand before it.
  struct Slide {
    int axis = 0, turns_before = 0;
    Vec3 direction;
    double zero = 0.0;
  };
  [[nodiscard]] RotarySolution in_axis_order(double by_workpiece_rad, double by_tool_rad, bool at_pole) const;
  [[nodiscard]] std::array<Angle2, 2> angles(double first_rad, double second_rad) const;
  /// v turned by the first `count` rotaries, or back.
  [[nodiscard]] Vec3 turned(Vec3 v, int count, const std::array<Angle2, 2>& at) const;
  [[nodiscard]] Vec3 turned_back(Vec3 v, int count, const std::array<Angle2, 2>& at) const;
  /// The tip with every linear axis at its zero.
  [[nodiscard]] Vec3 tip_without_slides(const std::array<Angle2, 2>& at) const;

  std::array<Turn, 2> turns_;  ///< nearer to the workpiece, nearer to the tool
  std::array<Slide, 3> slides_;
  TurnedVector tip_arm_, tool_;  ///< from the second rotary's point to the tip, and the tool axis, turned by it
  bool slides_together_ = true;  ///< the same rotaries stand before all three
  geometry::Mat3 slides_inverse_;
  // the spherical triangle's constants: sums and differences of its sides sigma and rho, halved
  double sine_sum_, cosine_sum_, sine_difference_, cosine_difference_;
  double azimuth_at_zero_;  ///< psi0
  Vec3 reference_,
      beside_;  ///< with the first rotary's direction a right-handed frame: azimuths about it count from here
  // the turned axis in that plane is (x, y) = along + cos(phi) ahead + sin(phi) side
  Eigen::Vector2d along_, ahead_, side_;
};

}  // namespace volute::kinematics
