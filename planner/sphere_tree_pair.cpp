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

/// Kept from call to call: the stack of a search.
std::vector<int>& scratch() {
  thread_local std::vector<int> kept;
  return kept;
}

double triangle_distance_mm(const Vec3* a, const Vec3* b) {
  Vec3 on_a, on_b;
  return fcl::detail::TriangleDistanced::triDistance(a, b, on_a, on_b);
}

/// A lower bound on the distance of two boxes, the second one standing at X: the widest gap along their edges.
double box_gap_mm(const Vec3& least_a, const Vec3& greatest_a, const geometry::Transform& X, const Vec3& least_b,
                  const Vec3& greatest_b) {
  const Vec3 half_a = 0.5 * (greatest_a - least_a), half_b = 0.5 * (greatest_b - least_b);
  const Vec3 between = X * (0.5 * (least_b + greatest_b)) - 0.5 * (least_a + greatest_a);
  const geometry::Mat3 R = X.linear(), size = R.cwiseAbs();
  const Vec3 along_a = between.cwiseAbs() - half_a - size * half_b;
  const Vec3 along_b = (R.transpose() * between).cwiseAbs() - half_b - size.transpose() * half_a;
  return std::max(along_a.maxCoeff(), along_b.maxCoeff());
}

}  // namespace

double SphereTree::cone_gap_mm(const AxialCone& cone) const {
  const double half_length = 0.5 * (cone.z_max_mm - cone.z_min_mm);
  const double radius = std::max(cone.bottom_radius_mm, cone.top_radius_mm);
  const Vec3 middle = cone.base_mm + 0.5 * (cone.z_min_mm + cone.z_max_mm) * cone.axis;
  const Vec3 across = (Vec3::Ones() - cone.axis.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  const Vec3 half = half_length * cone.axis.cwiseAbs() + radius * across;
  return ((middle - 0.5 * (least_mm_ + greatest_mm_)).cwiseAbs() - half - 0.5 * (greatest_mm_ - least_mm_)).maxCoeff();
}

bool SphereTree::is_clear(const AxialCone& cone, double by_mm) const {
  if (nodes_.empty() || cone_gap_mm(cone) >= by_mm) return true;
  const auto bound = [&](int n) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    return distance_bound_mm(cone, node.centre_mm) - node.radius_mm;
  };
  std::vector<int>& open = scratch();
  open.assign(1, 0);
  while (!open.empty()) {
    const int n = open.back();
    open.pop_back();
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    for (int k = node.first; k < node.first + node.count; ++k) {
      const Ball& ball = balls_[static_cast<std::size_t>(k)];
      const double to_centre = distance_bound_mm(cone, ball.centre_mm);
      if (to_centre - ball.radius_mm >= by_mm) continue;
      // The bound is below the distance only for slanted cones past their ends: so near a point of the mesh, no proof.
      if (to_centre < by_mm || !triangle_is_clear(cone, static_cast<std::size_t>(k), by_mm)) return false;
    }
    if (node.count > 0) continue;
    const double left = bound(node.first), right = bound(node.first + 1);
    const int nearer = left <= right ? node.first : node.first + 1, other = left <= right ? node.first + 1 : node.first;
    if (std::max(left, right) < by_mm) open.push_back(other);
    if (std::min(left, right) < by_mm) open.push_back(nearer);
  }
  return true;
}

double SphereTree::mesh_distance_mm(const SphereTree& other, const geometry::Transform& X_this_other,
                                    double cap_mm) const {
  double best = cap_mm;
  if (nodes_.empty() || other.nodes_.empty()) return best;
  if (box_gap_mm(least_mm_, greatest_mm_, X_this_other, other.least_mm_, other.greatest_mm_) >= best) return best;
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
