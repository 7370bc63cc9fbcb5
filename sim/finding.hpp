// What the verifier found wrong, in the user's words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/machine.hpp"

namespace volute::sim {

/// report.json "findings". Sorted by severity: collision, gouge, limit, travel, uncut, tilt, disagreement, clearance.
struct Finding {
  std::string kind;
  std::int64_t line = 0;  ///< of the program; key "block" in the report
  double time_s = 0.0;
  std::string axis_or_pair;
  double value = 0.0, limit = 0.0;  ///< mm, deg, or the axis's unit
  std::string text;                 ///< one line
  /// Where the tool stood in the part, and the axes (mm, rad), when it began; nothing where there is no one moment.
  std::optional<kinematics::ToolPose> pose_P = {};
  std::optional<kinematics::AxisVector> axes = {};
};

/// Place of a kind in the order of severity, 0 the worst; unknown kinds come last.
int severity(const std::string& kind);

/// By severity, then line, then time; equal ones keep their order.
void sort_by_severity(std::vector<Finding>& findings);

}  // namespace volute::sim
