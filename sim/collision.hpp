// Collisions in the run, by Bullet in double precision: independent of the planner's FCL.
#pragma once

#include <cstdint>
#include <functional>
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
  /// The blank before the run: held against the machine's links (the run through the stock holds the tool against it).
  geometry::TriangleMesh stock_P = {};
  kinematics::Tool tool;
  double gouge_tolerance_mm = 0.01;  ///< the cutter may go this deep into the part
  double state_error_mm = 0.0;       ///< states may stand this far beside the run: the cutter is forgiven as much more
  double clearance_mm = 0.0;  ///< report closest distances below this as findings of kind "clearance"; 0: touching only
};

struct CollisionReport {
  std::int64_t pairs_checked = 0;  ///< pairs of convex pieces that Bullet tested
  int sim_hits = 0;                ///< stretches of the run in which a pair meets
  double closest_mm =
      0.0;  ///< least distance of any pair but cutter and part; meaningful when closest_pair is not empty
  std::string closest_pair;
  std::int64_t at_line = 0;
  std::vector<Finding> findings;
};

/// One state of the machine to check.
struct MachineState {
  AxisVector q;
  kinematics::ToolPose pose_P;
  std::int64_t line = 0;
  double time_s = 0.0;
  bool rapid = false;
  bool cutting = false;
};

/// Checks the states and the motion between neighbours (axes move linearly) so that nothing moves further than
/// `step_mm` unseen. `machine` with its link shapes, `setup` for where the part stands. Pairs: cutter, shank and holder
/// with the part, the obstacles and every link but the spindle's; the links with part, obstacles and each other. Left
/// out: what stands still to each other, and links that are neighbours in the chain. The cutter may touch the part down
/// to the gouge tolerance, on rapids too (they begin and end at the surface): deeper is a finding; how deep the cut
/// surface tells. A mesh is a shell: a body wholly inside a solid without touching its skin is not seen, which needs a
/// jump past the skin of more than the body's size in one step.
///
/// A finding of kind "collision" tells line, time, axes and pose where the pair first meets, and in `value` how deep it
/// gets: body_depth_mm, the greatest over at most 32 moments of the stretch.
///
/// closest_mm is exact at the places looked at up to 1 mm or twice the clearance, above that it may be told 5 % too
/// great; between those places it can be less by step_mm or a quarter of itself, whichever is more.
///
/// Properties: 1. The report does not depend on the number of threads. 2. A pair nearer than the clearance for longer
/// than step_mm of motion is found.
///
/// Requires: step_mm > 0.
CollisionReport check_collisions(const CollisionScene& scene, const kinematics::Machine& machine,
                                 const kinematics::Setup& setup, const std::vector<MachineState>& states,
                                 double step_mm);

}  // namespace volute::sim
