// The machine's own links: where they stand for a pose of the tool, and which of them are watched.
#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "kinematics/inverse/inverse.hpp"
#include "planner/interference_trees.hpp"

namespace volute::planner {

using kinematics::axis_count;

namespace {

/// How many axes of the chain stand between the link and the workpiece.
int place_of_link(const kinematics::Machine& machine, int link) {
  if (link < 0) return machine.table_axes;
  const auto place = std::find(machine.chain.begin(), machine.chain.end(), link) - machine.chain.begin();
  return static_cast<int>(place) < machine.table_axes ? static_cast<int>(place) : static_cast<int>(place) + 1;
}

/// A link that stands at the place (all places of a machine have one; index -1 is the base).
int link_at_place(const kinematics::Machine& machine, int place) {
  if (place == machine.table_axes) return -1;
  return machine.chain[static_cast<std::size_t>(place < machine.table_axes ? place : place - 1)];
}

LinkBody link_body(const kinematics::Machine& machine, const kinematics::LinkShape& shape) {
  LinkBody body{place_of_link(machine, shape.link), shape.name, SphereTree(shape.mesh_M), Vec3::Zero(), 0.0};
  body.centre_mm = 0.5 * (body.tree.least_mm() + body.tree.greatest_mm());
  for (const Vec3& v : shape.mesh_M.vertices_mm) body.radius_mm = std::max(body.radius_mm, (v - body.centre_mm).norm());
  return body;
}

}  // namespace

void Interference::Trees::add_machine(const kinematics::Machine& from, const kinematics::Setup& at,
                                      const Scene& scene) {
  machine = from;
  setup = at;
  geometry::Mat3 directions;
  for (int k = 0; k < 3; ++k) directions.col(k) = from.axes[static_cast<std::size_t>(k)].direction_M;
  linear_gain = directions.isUnitary(1e-9) ? 1.0 : std::sqrt(3.0) * directions.inverse().norm();
  for (const kinematics::LinkShape& shape : from.shapes) {
    if (!shape.mesh_M.triangles.empty()) links.push_back(link_body(from, shape));
  }
  using Kind = WatchedPair::Kind;
  for (std::size_t k = 0; k < links.size(); ++k) {
    // What stands on the side of the workpiece with no axis between does not move relative to the scene.
    for (std::size_t b = 0; links[k].place > 0 && b < bodies.size(); ++b)
      pairs.push_back({Kind::link_body, k, b, scene.clearance_mm, false});
    for (std::size_t p = 0; links[k].place < axis_count && p < pieces.size(); ++p)
      pairs.push_back({Kind::piece_link, p, k, 0.0, false});
    for (std::size_t other = k + 1; other < links.size(); ++other) {
      if (std::abs(links[k].place - links[other].place) <= 1) continue;
      // Links that touch where the machine stands at zero are joined by design.
      const double at_zero_mm = links[k].tree.mesh_distance_mm(links[other].tree, geometry::Transform::Identity(),
                                                               motion_tolerance_mm + distance_rounding_mm);
      if (at_zero_mm > motion_tolerance_mm) pairs.push_back({Kind::link_link, k, other, motion_tolerance_mm, false});
    }
  }
}

Stand Interference::Trees::stand(const kinematics::ToolPose& pose, const RotaryPair& rotaries) const {
  Stand at{pose, rotaries, {}};
  const Vec3 tip_M_mm = setup.part_in_machine * pose.tip_P_mm;
  const kinematics::AxisVector q =
      kinematics::solve_linear(*machine, tool_length_mm, tip_M_mm, rotaries[0], rotaries[1]);
  for (int place = 0; place <= axis_count; ++place)
    at.X_M_place[static_cast<std::size_t>(place)] =
        kinematics::link_motion(*machine, link_at_place(*machine, place), q);
  return at;
}

bool Interference::links_are_free(const kinematics::ToolPose& pose, const RotaryPair& rotaries) const {
  return !first_link_hit(pose, rotaries);
}

std::optional<InterferenceHit> Interference::first_link_hit(const kinematics::ToolPose& pose,
                                                            const RotaryPair& rotaries) const {
  if (!has_machine()) return std::nullopt;
  const Stand at = trees_->stand(pose, rotaries);
  for (std::size_t p = trees_->assembly_pairs; p < trees_->pairs.size(); ++p) {
    if (trees_->touches(trees_->pairs[p], at)) return trees_->names(trees_->pairs[p]);
  }
  return std::nullopt;
}

}  // namespace volute::planner
