// Positions of every axis along a tool path: what inverse kinematics makes and the post writes.
#pragma once

#include <cstdint>
#include <vector>

#include "kinematics/model/machine.hpp"
#include "kinematics/model/tool_path.hpp"

namespace volute::kinematics {

struct AxisPathPoint {
  AxisVector q = AxisVector::Zero();  ///< machine coordinates, rotaries unwrapped
  ToolPose pose;                      ///< the pose that q reaches, in P
  MoveKind move = MoveKind::cut;
  double feed_mm_s = 0.0;
  bool machine_move =
      false;  ///< at rapid with TCP off, axes straight: the way over the top of Z while a rotary is rewound
  std::int32_t source = -1;  ///< index of the tool path's point; -1: put in between (linearization, rewind)
};

struct AxisPath {
  std::vector<AxisPathPoint> points;
};

}  // namespace volute::kinematics
