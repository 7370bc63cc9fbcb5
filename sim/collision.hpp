// Collisions in the run, by Bullet in double precision: independent of the planner's FCL.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "kinematics/model/machine.hpp"
#include "sim/finding.hpp"
#include "sim/machining/cut_surface.hpp"
#include "sim/trace.hpp"

namespace volute::sim {

struct CollisionScene {
  geometry::TriangleMesh part_P;
  std::vector<geometry::TriangleMesh> obstacles_P;
  std::vector<std::string> obstacle_names;
  kinematics::Tool tool;
  double gouge_tolerance_mm = 0.01;  ///< the cutter may go this deep into the part while it cuts
  double clearance_mm = 0.0;         ///< report closest distances below this as findings of kind "clearance"; 0: touching only
};

struct CollisionReport {
  std::int64_t pairs_checked = 0;
  int sim_hits = 0;
  double closest_mm = 0.0;
  std::string closest_pair;
  std::int64_t at_line = 0;
  std::vector<Finding> findings;
};

/// One state of the machine to check.
struct MachineState { AxisVector q; kinematics::ToolPose pose_P; std::int64_t line = 0; double time_s = 0.0; bool rapid = false; bool cutting = false; };

/// Checks the states and the motion between neighbours so that nothing moves further than `step_mm` unseen.
/// `machine` with its link shapes, `setup` for where the part stands.
CollisionReport check_collisions(const CollisionScene& scene, const kinematics::Machine& machine, const kinematics::Setup& setup,
                                 const std::vector<MachineState>& states, double step_mm);

}  // namespace volute::sim
