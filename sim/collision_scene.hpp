// Which bodies there are in a run, how they move, and which of them may not meet.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/collision.hpp"
#include "sim/collision_shapes.hpp"

namespace volute::sim {

struct MovingBody {
  std::shared_ptr<const CollisionBody> body;
  std::function<Transform(const AxisVector& q)> X_M;  ///< where the body's frame stands in M
};

struct BodyPair {
  std::size_t a = 0, b = 0;      ///< indices into bodies
  bool cutter_and_part = false;  ///< the cutter, taken in by `forgiven_mm`, with the part
  double forgiven_mm = 0.0;
};

struct CollisionPairs {
  std::vector<MovingBody> bodies;
  std::vector<BodyPair> pairs;
  [[nodiscard]] std::string pair_name(std::size_t pair) const {
    return bodies[pairs[pair].a].body->name() + "-" + bodies[pairs[pair].b].body->name();
  }
};

/// `machine` must outlive the result: the bodies' motions refer to it.
CollisionPairs collision_pairs(const CollisionScene& scene, const kinematics::Machine& machine,
                               const kinematics::Setup& setup);

}  // namespace volute::sim
