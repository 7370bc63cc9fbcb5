// Two sphere trees against each other, and how deep a mesh reaches into a cone.
#include <algorithm>
#include <cmath>

#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>

#include "planner/sphere_tree.hpp"

namespace volute::planner {

namespace {

struct NodePair {
  int a, b;
  double bound;
};

double triangle_distance_mm(const Vec3* a, const Vec3* b) {
  Vec3 on_a, on_b;
  return fcl::detail::TriangleDistanced::triDistance(a, b, on_a, on_b);
}

}  // namespace

double SphereTree::mesh_distance_mm(const SphereTree& other, const geometry::Transform& X_this_other,
                                    double cap_mm) const {
  double best = cap_mm;
  if (nodes_.empty() || other.nodes_.empty()) return best;
  const auto bound = [&](int a, int b) {
    const Node &x = nodes_[static_cast<std::size_t>(a)], &y = other.nodes_[static_cast<std::size_t>(b)];
    return (x.centre_mm - X_this_other * y.centre_mm).norm() - x.radius_mm - y.radius_mm;
  };
  const auto leaves = [&](const Node& x, const Node& y) {
    for (int j = 0; j < y.count; ++j) {
      const Corners& t = other.corners_[static_cast<std::size_t>(y.first + j)];
      const Ball& t_ball = other.balls_[static_cast<std::size_t>(y.first + j)];
      const Vec3 moved[3] = {X_this_other * t.a, X_this_other * t.b, X_this_other * t.c};
      const Vec3 centre_mm = X_this_other * t_ball.centre_mm;
      for (int i = 0; i < x.count; ++i) {
        const Corners& s = corners_[static_cast<std::size_t>(x.first + i)];
        const Ball& s_ball = balls_[static_cast<std::size_t>(x.first + i)];
        if ((s_ball.centre_mm - centre_mm).norm() - s_ball.radius_mm - t_ball.radius_mm >= best) continue;
        const Vec3 fixed[3] = {s.a, s.b, s.c};
        best = std::min(best, triangle_distance_mm(fixed, moved));
      }
    }
  };
  std::vector<NodePair> open = {{0, 0, bound(0, 0)}};
  while (!open.empty() && best > 0.0) {
    const NodePair top = open.back();
    open.pop_back();
    if (top.bound >= best) continue;
    const Node &x = nodes_[static_cast<std::size_t>(top.a)], &y = other.nodes_[static_cast<std::size_t>(top.b)];
    if (x.count > 0 && y.count > 0) {
      leaves(x, y);
      continue;
    }
    const bool split_a = y.count > 0 || (x.count == 0 && x.radius_mm >= y.radius_mm);
    const NodePair left =
        split_a ? NodePair{x.first, top.b, bound(x.first, top.b)} : NodePair{top.a, y.first, bound(top.a, y.first)};
    const NodePair right = split_a ? NodePair{x.first + 1, top.b, bound(x.first + 1, top.b)}
                                   : NodePair{top.a, y.first + 1, bound(top.a, y.first + 1)};
    open.push_back(left.bound <= right.bound ? right : left);
    open.push_back(left.bound <= right.bound ? left : right);
  }
  return best;
}

double depth_in_cone_mm(const AxialCone& cone, const Vec3& point_mm) {
  const Vec3 d = point_mm - cone.base_mm;
  const double z = d.dot(cone.axis);
  const double rho = std::sqrt(std::max(d.squaredNorm() - z * z, 0.0));
  const double slope = (cone.top_radius_mm - cone.bottom_radius_mm) / (cone.z_max_mm - cone.z_min_mm);
  const double wall = cone.bottom_radius_mm + slope * (z - cone.z_min_mm);
  return std::min({z - cone.z_min_mm, cone.z_max_mm - z, (wall - rho) / std::sqrt(1.0 + slope * slope)});
}

double SphereTree::depth_mm(const AxialCone& cone) const {
  double best = 0.0;
  if (nodes_.empty()) return best;
  std::vector<int> open = {0};
  while (!open.empty()) {
    const Node& node = nodes_[static_cast<std::size_t>(open.back())];
    open.pop_back();
    if (depth_in_cone_mm(cone, node.centre_mm) + node.radius_mm <= best) continue;
    for (int k = 0; k < node.count; ++k)
      best = std::max(best, depth_in_cone_mm(cone, balls_[static_cast<std::size_t>(node.first + k)].centre_mm));
    if (node.count == 0) open.insert(open.end(), {node.first, node.first + 1});
  }
  return best;
}

}  // namespace volute::planner
