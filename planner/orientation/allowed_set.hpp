// Which orientations are allowed at a point of the path: axis travel, process limits from the normal, nothing touched.
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "planner/orientation/rotary_chart.hpp"
#include "planner/orientation/stations.hpp"

namespace volute::planner {

/// Why an orientation is not allowed.
enum class Blocked { no, travel, tilt, width, interference };

class AllowedSet {
 public:
  /// All arguments outlive the set.
  AllowedSet(std::span<const Station> stations, const kinematics::Tool& tool, const RotaryChart& chart,
             const Interference& interference, const OrientationOptions& options);

  [[nodiscard]] kinematics::ToolPose pose(int i, const Vec3& axis_P) const;
  /// Tilt from the normal within [tilt_min, tilt_max]; for flat and bull cutters also: the cut is no narrower than the
  /// path was planned for.
  [[nodiscard]] Blocked process_limit(int i, const Vec3& axis_P) const;
  /// The same with a margin of 2 degrees (at most a quarter of the tilt band) to the tilt limits.
  [[nodiscard]] bool is_well_within_limits(int i, const Vec3& axis_P) const;
  /// Travel and process limits: cheap.
  [[nodiscard]] Blocked limit(int i, const Rotaries& at) const;
  /// Nothing touches: the assembly, and with a machine its links on one branch of the rotaries at least.
  [[nodiscard]] bool is_free(int i, const Vec3& axis_P) const;
  /// Nothing touches, the links of the machine at these rotaries.
  [[nodiscard]] bool is_free(int i, const Rotaries& at) const;
  /// Everything, with the rotaries wherever they reach the axis.
  [[nodiscard]] Blocked blocked(int i, const Vec3& axis_P) const;
  [[nodiscard]] Blocked blocked(int i, const Rotaries& at) const;
  /// The motion from station i to i + 1 as the axis path makes it (ToolMotion), machine links and all; the ends are not
  /// looked at.
  [[nodiscard]] bool motion_is_free(int i, const Rotaries& from, const Rotaries& to) const;

  /// The allowed axis nearest to `wanted_P`, found on rings 2 degrees apart, then `margin` further where that is
  /// allowed too.
  [[nodiscard]] std::optional<Vec3> nearest(int i, const Vec3& wanted_P, geometry::Angle margin) const;
  /// The axis turned the least so that it keeps the tilt limits with a margin of at most 2 degrees.
  [[nodiscard]] Vec3 within_tilt(int i, const Vec3& axis_P) const;
  /// What stands in the way of every orientation at i, in words.
  [[nodiscard]] std::string what_blocks(int i, const Vec3& wanted_P) const;

  [[nodiscard]] const RotaryChart& chart() const { return *chart_; }
  [[nodiscard]] const kinematics::Tool& tool() const { return *tool_; }
  [[nodiscard]] const Interference& interference() const { return *interference_; }
  /// Least and greatest tilt from the normal, rad: the greatest stays short of a right angle.
  [[nodiscard]] std::array<double, 2> tilt_limits() const {
    return {options_->tilt_min.radians(), std::min(options_->tilt_max.radians(), 0.5 * std::numbers::pi - 1e-6)};
  }
  [[nodiscard]] std::span<const Station> stations() const { return stations_; }
  [[nodiscard]] Vec3 planned_axis(int i) const;  ///< tilt and yaw of the options in the feed frame

 private:
  std::span<const Station> stations_;
  const kinematics::Tool* tool_;
  const RotaryChart* chart_;
  const Interference* interference_;
  const OrientationOptions* options_;
  double least_width_mm_;
  std::vector<Vec3> rings_;  ///< directions round z by rising angle
};

}  // namespace volute::planner
