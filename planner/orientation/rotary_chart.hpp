// The two rotary axes as a chart of the directions that the tool can point to, seen from the part.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kinematics/model/machine.hpp"

namespace volute::planner {

using geometry::Vec3;

/// Positions of axes[3] and axes[4], rad, unwrapped.
using Rotaries = std::array<double, 2>;

/// One way to point the tool. At (or next to) the pole one rotary has (next to) no influence: it is free.
struct RotaryChoice {
  Rotaries at{};
  int free_axis = -1;  ///< 0 or 1; -1: none
};

/// Properties, each with a test of that name: 1. AxisAgreesWithForward: axis_P(q) is the axis of tool_pose at q.
/// 2. ChoicesPointAsAsked: every choice reaches the asked axis.
class RotaryChart {
 public:
  RotaryChart(const kinematics::Machine& machine, const kinematics::Setup& setup);

  [[nodiscard]] Vec3 axis_P(const Rotaries& at) const;
  /// Where the tool points with both rotaries at their zero pose.
  [[nodiscard]] Vec3 rest_axis_P() const { return part_from_machine_ * zero_axis_M_; }
  /// From now on rotary k has no end: its travel is left to rewinds of the axis path.
  void release(int k) { released_[static_cast<std::size_t>(k)] = true; }
  /// Where the rotaries stand before the first of a row of axes, and how long the way from there is: the rapid from the
  /// piece before. Nothing: the row is the path's first.
  struct Before {
    Rotaries at{};
    double way_mm = 0.0;
  };
  void come_from(const Before& before) { before_ = before; }
  [[nodiscard]] const std::optional<Before>& before() const { return before_; }
  /// Every branch, each rotary in (-pi, pi], travel not yet looked at. Within `pole_rad` of the pole the free axis is
  /// named.
  [[nodiscard]] std::vector<RotaryChoice> choices(const Vec3& axis_P) const;
  [[nodiscard]] bool in_travel(const Rotaries& at) const;
  /// Can the axis be reached within travel, on any branch and turn?
  [[nodiscard]] bool reaches(const Vec3& axis_P) const;
  /// The values of rotary k that stand for the same position as `value_rad`, within travel; for an endless axis the one
  /// in (-pi, pi].
  [[nodiscard]] std::vector<double> turns(int k, double value_rad) const;
  [[nodiscard]] bool is_endless(int k) const;
  [[nodiscard]] const kinematics::Axis& axis(int k) const { return machine_->axes[static_cast<std::size_t>(3 + k)]; }

  /// Nearer to the pole than this the free rotary is left to the smoothing.
  static constexpr double pole_rad = 0.02;

 private:
  const kinematics::Machine* machine_;
  geometry::Mat3 part_from_machine_;
  std::array<int, 2> order_{};                          ///< rotaries from workpiece to tool
  std::array<std::array<geometry::Mat3, 3>, 2> parts_;  ///< R(t) = parts[0] + cos t parts[1] + sin t parts[2]
  Vec3 zero_axis_M_;
  std::array<bool, 2> released_{};
  std::optional<Before> before_;
};

}  // namespace volute::planner
