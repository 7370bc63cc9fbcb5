// Seeded scenes: a small freeform plate with one to five obstacles beside the path.
#pragma once

#include <string>
#include <vector>

#include "planner/plan.hpp"

namespace volute::scenes {

/// The same scene for the same seed on every machine: posts, boxes, spheres and leaning cylinders, 3 to 12 mm from the
/// plate's edge, 8 to 80 mm high; the tall ones stand in the way of the holder.
struct RandomScene {
  unsigned seed = 0;
  geometry::TriangleMesh plate;
  std::vector<geometry::TriangleMesh> obstacles;
  std::vector<std::string> names;
};
RandomScene random_scene(unsigned seed);

/// A ball of radius 3 on a slim shank with a stepped holder from 40 mm, scallop 0.3, on the machine.
planner::PlanRequest plan_request(const RandomScene& scene, const kinematics::Machine& machine,
                                  planner::Smoothing smoothing);

}  // namespace volute::scenes
