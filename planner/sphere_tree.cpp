#include "planner/sphere_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "planner/sphere_tree_walk.hpp"

namespace volute::planner {

using walk::Entry;
using walk::Piece;
using walk::Stack;

namespace {

constexpr int leaf_triangles = 2;
// Near the cone a triangle is quartered so often: the bound errs by an eighth of its size.
constexpr int leaf_halvings = 3;
// A bound this near to a corner's distance, as a share of the triangle's size, is not made better.
constexpr double leaf_error_share = 0.125;
// Triangles longer than this share of the mesh's box (or this many mm) are cut up.
constexpr double long_edge_share = 1.0 / 48.0, long_edge_mm = 1.0;

/// Halves the longest edge until none is longer than `most_mm`.
void cut_up(const Piece& whole, double most_mm, std::vector<Piece>& pieces) {
  std::vector<Piece> open = {whole};
  while (!open.empty()) {
    const Piece p = open.back();
    open.pop_back();
    const double ab = (p.b - p.a).norm(), bc = (p.c - p.b).norm(), ca = (p.a - p.c).norm();
    if (std::max({ab, bc, ca}) <= most_mm) {
      pieces.push_back(p);
    } else if (ab >= bc && ab >= ca) {
      const Vec3 m = 0.5 * (p.a + p.b);
      open.insert(open.end(), {{p.a, m, p.c}, {m, p.b, p.c}});
    } else if (bc >= ca) {
      const Vec3 m = 0.5 * (p.b + p.c);
      open.insert(open.end(), {{p.a, p.b, m}, {p.a, m, p.c}});
    } else {
      const Vec3 m = 0.5 * (p.c + p.a);
      open.insert(open.end(), {{p.a, p.b, m}, {m, p.b, p.c}});
    }
  }
}

double longest_wanted_mm(const geometry::TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& v : mesh.vertices_mm) box.extend(v);
  return box.isEmpty() ? long_edge_mm : std::max(long_edge_mm, long_edge_share * box.diagonal().norm());
}

/// The greatest component along `direction` of any point of the cone.
double support_mm(const AxialCone& cone, const Vec3& direction) {
  const double along = direction.dot(cone.axis);
  const double square = std::sqrt(std::max(direction.squaredNorm() - along * along, 0.0));
  return direction.dot(cone.base_mm) + std::max(cone.z_min_mm * along + cone.bottom_radius_mm * square,
                                                cone.z_max_mm * along + cone.top_radius_mm * square);
}

/// The point of the cone that is nearest to one outside it.
Vec3 nearest_in_cone(const AxialCone& cone, const Vec3& point_mm) {
  const Vec3 d = point_mm - cone.base_mm;
  const double z = d.dot(cone.axis);
  const Vec3 square = d - z * cone.axis;
  const double rho = square.norm();
  // In the half-plane through the axis: the side, then the end that the point lies beyond.
  const double rise = cone.z_max_mm - cone.z_min_mm, widening = cone.top_radius_mm - cone.bottom_radius_mm;
  const double along = (z - cone.z_min_mm) * rise + (rho - cone.bottom_radius_mm) * widening;
  const double t = std::clamp(along / std::max(rise * rise + widening * widening, 1e-300), 0.0, 1.0);
  double at_z = cone.z_min_mm + t * rise, at_rho = cone.bottom_radius_mm + t * widening;
  const auto prefer = [&](double other_z, double other_rho) {
    if (std::hypot(z - other_z, rho - other_rho) < std::hypot(z - at_z, rho - at_rho))
      at_z = other_z, at_rho = other_rho;
  };
  if (z < cone.z_min_mm) prefer(cone.z_min_mm, std::min(rho, cone.bottom_radius_mm));
  if (z > cone.z_max_mm) prefer(cone.z_max_mm, std::min(rho, cone.top_radius_mm));
  return cone.base_mm + at_z * cone.axis + (rho > 0.0 ? Vec3(square * (at_rho / rho)) : Vec3::Zero().eval());
}

/// Lowers `best` to a lower bound on the distance of cone and triangle: of the ball round it, of parallel planes
/// between them, or of its quarters.
void lower_bound_mm(const AxialCone& cone, const Piece& t, int halvings, double& best) {
  const Vec3 centre = (t.a + t.b + t.c) / 3.0;
  const double radius =
      std::sqrt(std::max({(t.a - centre).squaredNorm(), (t.b - centre).squaredNorm(), (t.c - centre).squaredNorm()}));
  const double to_centre = distance_bound_mm(cone, centre);
  if (to_centre - radius >= best) return;
  const double bound = std::max(to_centre - radius, walk::parted_mm(cone, t));
  if (bound >= best) return;
  const double corner =
      std::min({distance_bound_mm(cone, t.a), distance_bound_mm(cone, t.b), distance_bound_mm(cone, t.c)});
  if (to_centre <= 0.0 || halvings == 0 || corner - bound <= leaf_error_share * radius) {
    best = std::min(best, bound);
    return;
  }
  const Vec3 ab = 0.5 * (t.a + t.b), bc = 0.5 * (t.b + t.c), ca = 0.5 * (t.c + t.a);
  for (const Piece& quarter : {Piece{ab, bc, ca}, Piece{t.a, ab, ca}, Piece{ab, t.b, bc}, Piece{ca, bc, t.c}})
    lower_bound_mm(cone, quarter, halvings - 1, best);
}

double to_segment_mm(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-300), 0.0, 1.0);
  return (p - a - t * ab).norm();
}

bool ray_crosses(const Vec3& from, const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 e1 = b - a, e2 = c - a, h = direction.cross(e2);
  const double det = e1.dot(h);
  if (det == 0.0) return false;
  const Vec3 s = from - a, q = s.cross(e1);
  const double u = s.dot(h) / det, v = direction.dot(q) / det;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && e2.dot(q) / det > 0.0;
}

}  // namespace

double walk::parted_mm(const AxialCone& cone, const Piece& t) {
  double most = -std::numeric_limits<double>::infinity();
  const auto part_along = [&](Vec3 direction) {
    const double length = direction.norm();
    if (length < 1e-12) return;
    direction /= length;
    const double least = std::min({direction.dot(t.a), direction.dot(t.b), direction.dot(t.c)});
    most = std::max(most, least - support_mm(cone, direction));
  };
  const Vec3 centre = (t.a + t.b + t.c) / 3.0, normal = (t.b - t.a).cross(t.c - t.a);
  part_along(normal);
  part_along(-normal);
  part_along(centre - nearest_in_cone(cone, centre));
  return most;
}

double distance_bound_mm(const AxialCone& cone, const Vec3& point_mm) {
  const Vec3 d = point_mm - cone.base_mm;
  const double z = d.dot(cone.axis);
  const double rho = std::sqrt(std::max(d.squaredNorm() - z * z, 0.0));
  const double dz = std::max({cone.z_min_mm - z, z - cone.z_max_mm, 0.0});
  const double dr = std::max(rho - std::max(cone.bottom_radius_mm, cone.top_radius_mm), 0.0);
  const double round_it = std::sqrt(dz * dz + dr * dr);
  if (cone.bottom_radius_mm == cone.top_radius_mm) return round_it;
  // The slanted side bounds too: the whole cone lies on one side of it.
  const double slope = (cone.top_radius_mm - cone.bottom_radius_mm) / (cone.z_max_mm - cone.z_min_mm);
  const double outside = (rho - cone.bottom_radius_mm - slope * (z - cone.z_min_mm)) / std::sqrt(1.0 + slope * slope);
  return std::max(round_it, outside);
}

double distance_mm(const Vec3& point_mm, const Vec3& a_mm, const Vec3& b_mm, const Vec3& c_mm) {
  const Vec3 n = (b_mm - a_mm).cross(c_mm - a_mm);
  const auto left_of = [&](const Vec3& from, const Vec3& to) {
    return n.dot((to - from).cross(point_mm - from)) >= 0.0;
  };
  const double length = n.norm();
  if (length > 0.0 && left_of(a_mm, b_mm) && left_of(b_mm, c_mm) && left_of(c_mm, a_mm)) {
    return std::abs(n.dot(point_mm - a_mm)) / length;
  }
  return std::min(
      {to_segment_mm(point_mm, a_mm, b_mm), to_segment_mm(point_mm, b_mm, c_mm), to_segment_mm(point_mm, c_mm, a_mm)});
}

SphereTree::SphereTree(const geometry::TriangleMesh& mesh) {
  std::vector<Piece> pieces;
  pieces.reserve(mesh.triangles.size());
  const double most_mm = longest_wanted_mm(mesh);
  for (const geometry::Triangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) { return mesh.vertices_mm[static_cast<std::size_t>(t[k])]; };
    cut_up({corner(0), corner(1), corner(2)}, most_mm, pieces);
  }
  std::vector<Corners> all;
  all.reserve(pieces.size());
  for (const Piece& p : pieces) all.push_back({p.a, p.b, p.c});
  if (all.empty()) return;
  std::vector<int> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(all.size());
  nodes_.emplace_back();
  fill(0, order, 0, all);
  corners_.reserve(all.size());
  least_mm_ = greatest_mm_ = all.front().a;
  for (const int t : order) {
    const Corners& k = all[static_cast<std::size_t>(t)];
    corners_.push_back(k);
    const Vec3 centroid = (k.a + k.b + k.c) / 3.0;
    balls_.push_back({centroid, std::sqrt(std::max({(k.a - centroid).squaredNorm(), (k.b - centroid).squaredNorm(),
                                                    (k.c - centroid).squaredNorm()}))});
    least_mm_ = least_mm_.cwiseMin(k.a).cwiseMin(k.b).cwiseMin(k.c);
    greatest_mm_ = greatest_mm_.cwiseMax(k.a).cwiseMax(k.b).cwiseMax(k.c);
  }
}

void SphereTree::fill(std::size_t node, std::span<int> order, int first, const std::vector<Corners>& all) {
  Vec3 least = all[static_cast<std::size_t>(order.front())].a, greatest = least;
  for (const int t : order) {
    const Corners& k = all[static_cast<std::size_t>(t)];
    least = least.cwiseMin(k.a).cwiseMin(k.b).cwiseMin(k.c);
    greatest = greatest.cwiseMax(k.a).cwiseMax(k.b).cwiseMax(k.c);
  }
  const Vec3 centre = 0.5 * (least + greatest);
  double radius_sq = 0.0;
  for (const int t : order) {
    const Corners& k = all[static_cast<std::size_t>(t)];
    radius_sq =
        std::max({radius_sq, (k.a - centre).squaredNorm(), (k.b - centre).squaredNorm(), (k.c - centre).squaredNorm()});
  }
  nodes_[node] = {centre, std::sqrt(radius_sq), first, static_cast<int>(order.size())};
  if (order.size() <= static_cast<std::size_t>(leaf_triangles)) return;
  Eigen::Index split = 0;
  (greatest - least).maxCoeff(&split);
  const std::size_t half = order.size() / 2;
  const auto key = [&](int t) {
    const Corners& k = all[static_cast<std::size_t>(t)];
    return k.a[split] + k.b[split] + k.c[split];
  };
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(), [&](int s, int t) {
    const double ks = key(s), kt = key(t);
    return ks != kt ? ks < kt : s < t;
  });
  const std::size_t child = nodes_.size();
  nodes_.resize(child + 2);
  nodes_[node].first = static_cast<int>(child);
  nodes_[node].count = 0;
  fill(child, order.first(half), first, all);
  fill(child + 1, order.subspan(half), first + static_cast<int>(half), all);
}

double SphereTree::clearance_mm(const AxialCone& cone, double cap_mm) const {
  double best = cap_mm;
  if (nodes_.empty() || cone_gap_mm(cone) >= cap_mm) return best;
  const auto bound = [&](int n) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    return distance_bound_mm(cone, node.centre_mm) - node.radius_mm;
  };
  Stack stack;
  stack.push(0, bound(0));
  while (!stack.empty() && best > 0.0) {
    const Entry top = stack.pop();
    if (top.bound >= best) continue;
    const Node& node = nodes_[static_cast<std::size_t>(top.node)];
    for (int k = 0; k < node.count; ++k) {
      const Corners& t = corners_[static_cast<std::size_t>(node.first + k)];
      lower_bound_mm(cone, {t.a, t.b, t.c}, leaf_halvings, best);
    }
    if (node.count > 0) continue;
    const double left = bound(node.first), right = bound(node.first + 1);
    stack.push(left <= right ? node.first + 1 : node.first, std::max(left, right));
    stack.push(left <= right ? node.first : node.first + 1, std::min(left, right));
  }
  return best;
}

bool SphereTree::triangle_is_clear(const AxialCone& cone, std::size_t triangle, double by_mm) const {
  const Corners& t = corners_[triangle];
  // A corner that is too near decides at once.
  if (std::min({distance_bound_mm(cone, t.a), distance_bound_mm(cone, t.b), distance_bound_mm(cone, t.c)}) < by_mm)
    return false;
  double clear = by_mm;
  lower_bound_mm(cone, {t.a, t.b, t.c}, leaf_halvings, clear);
  return clear >= by_mm;
}

bool SphereTree::any_meets(const AxialCone& cone, bool cone_is_shape, const TriangleTest& meets) const {
  if (nodes_.empty() || cone_gap_mm(cone) > clear_rounding_mm) return false;
  const auto bound = [&](int n) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    return distance_bound_mm(cone, node.centre_mm) - node.radius_mm;
  };
  const auto leaf_meets = [&](int k) {
    const Ball& ball = balls_[static_cast<std::size_t>(k)];
    const double to_centre = distance_bound_mm(cone, ball.centre_mm);
    if (to_centre - ball.radius_mm > clear_rounding_mm) return false;
    if (to_centre <= 0.0 && cone_is_shape) return true;
    const Corners& t = corners_[static_cast<std::size_t>(k)];
    const double least =
        std::min({distance_bound_mm(cone, t.a), distance_bound_mm(cone, t.b), distance_bound_mm(cone, t.c)});
    if (least <= 0.0 && cone_is_shape) return true;
    const bool clear = least > 0.0 && triangle_is_clear(cone, static_cast<std::size_t>(k), clear_rounding_mm);
    return !clear && meets(t.a, t.b, t.c);
  };
  Stack stack;
  stack.push(0, bound(0));
  while (!stack.empty()) {
    const Entry top = stack.pop();
    if (top.bound > clear_rounding_mm) continue;
    const Node& node = nodes_[static_cast<std::size_t>(top.node)];
    for (int k = 0; k < node.count; ++k) {
      if (leaf_meets(node.first + k)) return true;
    }
    if (node.count > 0) continue;
    const double left = bound(node.first), right = bound(node.first + 1);
    stack.push(left <= right ? node.first + 1 : node.first, std::max(left, right));
    stack.push(left <= right ? node.first : node.first + 1, std::min(left, right));
  }
  return false;
}

double SphereTree::point_distance_mm(const Vec3& point_mm, double cap_mm) const {
  double best = cap_mm;
  if (nodes_.empty()) return best;
  const auto bound = [&](int n) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    return (point_mm - node.centre_mm).norm() - node.radius_mm;
  };
  Stack stack;
  stack.push(0, bound(0));
  while (!stack.empty()) {
    const Entry top = stack.pop();
    if (top.bound >= best) continue;
    const Node& node = nodes_[static_cast<std::size_t>(top.node)];
    for (int k = 0; k < node.count; ++k) {
      const Corners& t = corners_[static_cast<std::size_t>(node.first + k)];
      best = std::min(best, distance_mm(point_mm, t.a, t.b, t.c));
    }
    if (node.count > 0) continue;
    const double left = bound(node.first), right = bound(node.first + 1);
    stack.push(left <= right ? node.first + 1 : node.first, std::max(left, right));
    stack.push(left <= right ? node.first : node.first + 1, std::min(left, right));
  }
  return best;
}

int SphereTree::crossings(const Vec3& from, const Vec3& direction) const {
  if (nodes_.empty()) return 0;
  int count = 0;
  Stack stack;
  stack.push(0, 0.0);
  while (!stack.empty()) {
    const Node& node = nodes_[static_cast<std::size_t>(stack.pop().node)];
    const Vec3 d = node.centre_mm - from;
    const double along = d.dot(direction);
    if (along < -node.radius_mm || d.squaredNorm() - along * along > node.radius_mm * node.radius_mm * (1.0 + 1e-12))
      continue;
    for (int k = 0; k < node.count; ++k) {
      const Corners& t = corners_[static_cast<std::size_t>(node.first + k)];
      count += ray_crosses(from, direction, t.a, t.b, t.c) ? 1 : 0;
    }
    if (node.count > 0) continue;
    stack.push(node.first, 0.0);
    stack.push(node.first + 1, 0.0);
  }
  return count;
}

bool SphereTree::contains(const Vec3& point_mm) const {
  if ((point_mm.array() < least_mm_.array()).any() || (point_mm.array() > greatest_mm_.array()).any()) return false;
  // Directions that no edge of a made part is likely to follow.
  static const std::array<Vec3, 3> rays = {Vec3(0.5377, 0.1834, 0.8229).normalized(),
                                           Vec3(-0.3419, 0.8622, 0.3737).normalized(),
                                           Vec3(-0.4336, -0.5768, 0.6924).normalized()};
  int odd = 0;
  for (const Vec3& ray : rays) odd += crossings(point_mm, ray) % 2;
  return odd >= 2;
}

}  // namespace volute::planner
