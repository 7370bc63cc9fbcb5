// What the planner hands on: poses of the tool in the part, in the order in which they are visited.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vector.hpp"

namespace volute::kinematics {

using geometry::Vec3;

/// How the tool comes to a point from the one before.
enum class MoveKind : std::uint8_t {
  rapid,     ///< in the air at the machine's own speed
  approach,  ///< from clearance to the first cut, at feed
  cut,
  link,     ///< from one pass to the next along the surface, at feed
  retract,  ///< away from the part, at feed
};

/// Where the tool is and where it points, in the part frame P.
struct ToolPose {
  Vec3 tip_P_mm = Vec3::Zero();
  Vec3 axis_P = Vec3::UnitZ();  ///< unit, from tip to holder
};

struct ToolPathPoint {
  ToolPose pose;
  MoveKind move = MoveKind::cut;
  double feed_mm_s = 0.0;            ///< of the tip relative to the part, on the way here; 0 for rapid
  Vec3 contact_P_mm = Vec3::Zero();  ///< CC point; meaningful for cut and link
  Vec3 normal_P = Vec3::UnitZ();     ///< outward surface normal there
  double turn = 0.0;                 ///< how many turns of the spiral lie behind (level of the path field); 0 elsewhere
};

struct ToolPath {
  std::vector<ToolPathPoint> points;
};

}  // namespace volute::kinematics
