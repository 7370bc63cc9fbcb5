// A mesh against a cone that turns about a pivot within bounds.
#include <algorithm>
#include <cmath>

#include "planner/sphere_tree_walk.hpp"

namespace volute::planner {

using walk::Entry;
using walk::Piece;
using walk::Stack;

namespace {

// For turns a triangle is quartered so often: it errs by its size's square over the cone's radius then.
constexpr int turn_halvings = 4;

bool triangle_clear_of_turn(const AxialCone& cone, double grown_mm, const TurnBound& turn, const Piece& t,
                            int halvings) {
  const double far =
      std::max({(t.a - turn.pivot_mm).norm(), (t.b - turn.pivot_mm).norm(), (t.c - turn.pivot_mm).norm()});
  const double to_ball_mm = far <= turn.within_mm ? distance_mm(turn.ball_centre_mm, t.a, t.b, t.c) : 0.0;
  if (far <= turn.within_mm && to_ball_mm > turn.ball_radius_mm + clear_rounding_mm) return true;
  const double needed = grown_mm + turn.moved_mm(far) + clear_rounding_mm;
  const Vec3 centre = (t.a + t.b + t.c) / 3.0;
  const double radius =
      std::sqrt(std::max({(t.a - centre).squaredNorm(), (t.b - centre).squaredNorm(), (t.c - centre).squaredNorm()}));
  if (distance_bound_mm(cone, centre) - radius > needed || walk::parted_mm(cone, t) > needed) return true;
  if (halvings == 0) return false;
  const Vec3 ab = 0.5 * (t.a + t.b), bc = 0.5 * (t.b + t.c), ca = 0.5 * (t.c + t.a);
  for (const Piece& quarter : {Piece{ab, bc, ca}, Piece{t.a, ab, ca}, Piece{ab, t.b, bc}, Piece{ca, bc, t.c}}) {
    if (!triangle_clear_of_turn(cone, grown_mm, turn, quarter, halvings - 1)) return false;
  }
  return true;
}

}  // namespace

bool SphereTree::is_clear_of_turn(const AxialCone& cone, double grown_mm, const TurnBound& turn) const {
  if (nodes_.empty()) return true;
  // Above 0: surely clear. Below: by how much it fails, the worst on top.
  const auto spare = [&](int n) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    const double far = (node.centre_mm - turn.pivot_mm).norm() + node.radius_mm;
    return distance_bound_mm(cone, node.centre_mm) - node.radius_mm - grown_mm - clear_rounding_mm - turn.moved_mm(far);
  };
  Stack stack;
  stack.push(0, spare(0));
  while (!stack.empty()) {
    const Entry top = stack.pop();
    if (top.bound > 0.0) continue;
    const Node& node = nodes_[static_cast<std::size_t>(top.node)];
    for (int k = 0; k < node.count; ++k) {
      const Corners& t = corners_[static_cast<std::size_t>(node.first + k)];
      if (!triangle_clear_of_turn(cone, grown_mm, turn, {t.a, t.b, t.c}, turn_halvings)) return false;
    }
    if (node.count > 0) continue;
    const double left = spare(node.first), right = spare(node.first + 1);
    stack.push(left <= right ? node.first + 1 : node.first, std::max(left, right));
    stack.push(left <= right ? node.first : node.first + 1, std::min(left, right));
  }
  return true;
}

bool SphereTree::is_inside_for_turn(const AxialCone& cone, double grown_mm, const TurnBound& turn) const {
  if (nodes_.empty()) return false;
  // A disc has no inside of its own.
  const bool is_disc = cone.z_max_mm <= cone.z_min_mm;
  const auto depth = [&](const Vec3& p) {
    return grown_mm + (is_disc ? -distance_bound_mm(cone, p) : depth_in_cone_mm(cone, p));
  };
  const auto stays_inside = [&](const Vec3& p) {
    return depth(p) > turn.moved_mm((p - turn.pivot_mm).norm()) + clear_rounding_mm;
  };
  // Above 0: a point of it may stay inside. The most promising one on top.
  const auto promise = [&](int n) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    const double near = std::max((node.centre_mm - turn.pivot_mm).norm() - node.radius_mm, 0.0);
    return depth(node.centre_mm) + node.radius_mm - turn.moved_mm(near);
  };
  Stack stack;
  stack.push(0, promise(0));
  while (!stack.empty()) {
    const Entry top = stack.pop();
    if (top.bound <= 0.0) continue;
    const Node& node = nodes_[static_cast<std::size_t>(top.node)];
    for (int k = 0; k < node.count; ++k) {
      const Corners& t = corners_[static_cast<std::size_t>(node.first + k)];
      if (stays_inside(t.a) || stays_inside(t.b) || stays_inside(t.c) || stays_inside((t.a + t.b + t.c) / 3.0))
        return true;
    }
    if (node.count > 0) continue;
    const double left = promise(node.first), right = promise(node.first + 1);
    stack.push(left >= right ? node.first + 1 : node.first, std::min(left, right));
    stack.push(left >= right ? node.first : node.first + 1, std::max(left, right));
  }
  return false;
}

}  // namespace volute::planner
