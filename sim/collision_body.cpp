// Bodies of many convex pieces, and the closest approach of two of them.
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "sim/collision_shapes.hpp"

namespace volute::sim {
namespace {

using geometry::TriangleMesh;

btTransform to_bullet(const Transform& X) {
  const auto& r = X.linear();
  const auto& t = X.translation();
  return btTransform(btMatrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
                     btVector3(t.x(), t.y(), t.z()));
}

/// Bullet's own test of one pair. Touching and meeting give a value <= 0.
double gjk_distance_mm(const btConvexShape& a, const btConvexShape& b, const btTransform& X_BA) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(&a, &b, &simplex, &depth);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = X_BA;
  input.m_transformB.setIdentity();
  btPointCollector out;
  detector.getClosestPoints(input, out, nullptr);
  return out.m_hasResult ? out.m_distance : 0.0;
}

/// Walks B's tree for one piece of A, the nearer child first, and gives up what cannot come below the best.
struct PieceSearch {
  const ConvexPiece& piece;
  const CollisionBody& body;
  Transform X_AB, X_BA;
  btTransform bullet_X_BA;
  std::int64_t& pairs;
  double best;
  double exact_below, any_below;

  [[nodiscard]] double bound(const Vec3& centre_B, double radius) const {
    return piece.distance_bound_mm(X_AB * centre_B) - radius;
  }

  /// What cannot come below this is given up.
  [[nodiscard]] double limit() const {
    constexpr double touching_mm = 1e-9;
    if (best < any_below) return touching_mm;
    return best <= exact_below ? best : std::max(exact_below, (1.0 - far_distance_error) * best);
  }

  /// How far the piece stays on its side of a flat piece's plane: no more than their distance.
  [[nodiscard]] double beside_face_mm(const ConvexPiece::Face& face, const Vec3& centre_B) const {
    const double side = face.normal.dot(centre_B) < face.offset_mm ? -1.0 : 1.0;
    const Vec3 towards = -side * (X_AB.linear() * face.normal);
    return side * (face.normal.dot(X_BA.translation()) - face.offset_mm) - piece.reach_mm(towards);
  }

  void leaf(const CollisionBody::Node& node) {
    const Vec3 centre_B = X_BA * piece.centre_mm;
    for (std::int32_t i = node.first; i < node.first + node.count && best > 0.0; ++i) {
      const ConvexPiece& other = body.piece(i);
      if (bound(other.centre_mm, other.radius_mm) >= limit()) continue;
      if (other.distance_bound_mm(centre_B) - piece.radius_mm >= limit()) continue;
      if (other.face && beside_face_mm(*other.face, centre_B) >= limit()) continue;
      ++pairs;
      best = std::min(best, gjk_distance_mm(piece.shape(), other.shape(), bullet_X_BA));
    }
  }

  void walk(std::int32_t index, double bound_mm) {
    if (best <= 0.0 || bound_mm >= limit()) return;
    const auto& node = body.nodes()[static_cast<std::size_t>(index)];
    if (node.count > 0) return leaf(node);
    const auto& first = body.nodes()[static_cast<std::size_t>(node.first)];
    const auto& right = body.nodes()[static_cast<std::size_t>(node.right)];
    const double first_bound = bound(first.centre_mm, first.radius_mm),
                 right_bound = bound(right.centre_mm, right.radius_mm);
    if (first_bound <= right_bound) {
      walk(node.first, first_bound);
      walk(node.right, right_bound);
    } else {
      walk(node.right, right_bound);
      walk(node.first, first_bound);
    }
  }
};

/// Walks B's tree for one piece of A and keeps the greatest depth of a pair that meets.
struct DepthSearch {
  const ConvexPiece& piece;
  const CollisionBody& body;
  Transform X_AB;
  btTransform X_BA;
  double depth = 0.0;

  void walk(std::int32_t index) {
    const auto& node = body.nodes()[static_cast<std::size_t>(index)];
    if (piece.distance_bound_mm(X_AB * node.centre_mm) > node.radius_mm) return;
    if (node.count == 0) {
      walk(node.first);
      walk(node.right);
      return;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const ConvexPiece& other = body.piece(i);
      if (piece.distance_bound_mm(X_AB * other.centre_mm) > other.radius_mm) continue;
      depth = std::max(depth, -gjk_distance_mm(piece.shape(), other.shape(), X_BA));
    }
  }
};

/// Groups of triangles that share corners, corners compared by position.
std::vector<std::vector<geometry::Index>> components(const TriangleMesh& mesh) {
  std::map<std::array<double, 3>, int> numbers;
  std::vector<int> parent;
  const auto root = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i)
      i = parent[static_cast<std::size_t>(i)] = parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(i)])];
    return i;
  };
  const auto number = [&](geometry::Index vertex) {
    const Vec3& p = mesh.vertices_mm[static_cast<std::size_t>(vertex)];
    const auto [it, added] = numbers.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(parent.size()));
    if (added) parent.push_back(it->second);
    return it->second;
  };
  std::vector<int> first(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    first[t] = number(mesh.triangles[t][0]);
    for (const int k : {1, 2})
      parent[static_cast<std::size_t>(root(number(mesh.triangles[t][static_cast<std::size_t>(k)])))] = root(first[t]);
  }
  std::map<int, std::vector<geometry::Index>> groups;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    groups[root(first[t])].push_back(static_cast<geometry::Index>(t));
  std::vector<std::vector<geometry::Index>> out;
  for (auto& [key, group] : groups) out.push_back(std::move(group));
  return out;
}

std::vector<Vec3> corners(const TriangleMesh& mesh, geometry::Index triangle) {
  std::vector<Vec3> out;
  for (const auto v : mesh.triangles[static_cast<std::size_t>(triangle)])
    out.push_back(mesh.vertices_mm[static_cast<std::size_t>(v)]);
  return out;
}

/// Every corner lies behind or on every face.
bool is_convex(const TriangleMesh& mesh, const std::vector<geometry::Index>& group, const std::vector<Vec3>& points) {
  constexpr double slack_mm = 1e-5;
  for (const auto t : group) {
    const auto c = corners(mesh, t);
    const Vec3 normal = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
    if (std::any_of(points.begin(), points.end(), [&](const Vec3& p) { return (p - c[0]).dot(normal) > slack_mm; }))
      return false;
  }
  return true;
}

}  // namespace

CollisionBody::CollisionBody(std::string name, std::vector<std::unique_ptr<ConvexPiece>> pieces)
    : name_(std::move(name)), pieces_(std::move(pieces)) {
  if (!pieces_.empty()) build(0, static_cast<std::int32_t>(pieces_.size()));
}

CollisionBody CollisionBody::of_triangles(std::string name, const TriangleMesh& mesh) {
  std::vector<std::unique_ptr<ConvexPiece>> pieces;
  pieces.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto c = corners(mesh, static_cast<geometry::Index>(t));
    pieces.push_back(triangle_piece(c[0], c[1], c[2]));
  }
  return {std::move(name), std::move(pieces)};
}

CollisionBody CollisionBody::of_components(std::string name, const TriangleMesh& mesh) {
  constexpr std::size_t hull_triangles_max = 2000;
  std::vector<std::unique_ptr<ConvexPiece>> pieces;
  for (const auto& group : components(mesh)) {
    std::vector<Vec3> points;
    for (const auto t : group) {
      const auto c = corners(mesh, t);
      points.insert(points.end(), c.begin(), c.end());
    }
    if (group.size() <= hull_triangles_max && is_convex(mesh, group, points)) {
      pieces.push_back(hull_piece(points));
    } else {
      for (std::size_t i = 0; i < points.size(); i += 3)
        pieces.push_back(triangle_piece(points[i], points[i + 1], points[i + 2]));
    }
  }
  return {std::move(name), std::move(pieces)};
}

std::int32_t CollisionBody::build(std::int32_t first, std::int32_t count) {
  constexpr std::int32_t leaf_size = 4;
  const auto begin = pieces_.begin() + first, end = begin + count;
  Eigen::AlignedBox3d centres;
  std::for_each(begin, end, [&](const auto& p) { centres.extend(p->centre_mm); });
  Node node{centres.center(), 0.0, first, 0, count};
  std::for_each(begin, end, [&](const auto& p) {
    node.radius_mm = std::max(node.radius_mm, (p->centre_mm - node.centre_mm).norm() + p->radius_mm);
  });
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back(node);
  if (count <= leaf_size) return index;
  Eigen::Index axis = 0;
  centres.sizes().maxCoeff(&axis);
  std::stable_sort(begin, end, [&](const auto& a, const auto& b) { return a->centre_mm[axis] < b->centre_mm[axis]; });
  const std::int32_t left = build(first, count / 2), right = build(first + count / 2, count - count / 2);
  auto& stored = nodes_[static_cast<std::size_t>(index)];
  stored.count = 0;
  stored.first = left;
  stored.right = right;
  return index;
}

double body_distance_mm(const CollisionBody& a, const CollisionBody& b, const Transform& X_BA, double bound_mm,
                        std::int64_t& pairs, double exact_below_mm, double any_below_mm) {
  if (a.empty() || b.empty()) return bound_mm;
  if (a.piece_count() > b.piece_count())
    return body_distance_mm(b, a, X_BA.inverse(), bound_mm, pairs, exact_below_mm, any_below_mm);
  const Transform X_AB = X_BA.inverse();
  const btTransform bullet_X_BA = to_bullet(X_BA);
  double best = bound_mm;
  for (std::size_t i = 0; i < a.piece_count() && best > 0.0; ++i) {
    PieceSearch search{
        a.piece(static_cast<std::int32_t>(i)), b, X_AB, X_BA, bullet_X_BA, pairs, best, exact_below_mm, any_below_mm};
    search.walk(0, search.bound(b.centre_mm(), b.radius_mm()));
    best = search.best;
  }
  return best;
}

double body_depth_mm(const CollisionBody& a, const CollisionBody& b, const Transform& X_BA) {
  if (a.empty() || b.empty()) return 0.0;
  if (a.piece_count() > b.piece_count()) return body_depth_mm(b, a, X_BA.inverse());
  double depth = 0.0;
  for (std::size_t i = 0; i < a.piece_count(); ++i) {
    DepthSearch search{a.piece(static_cast<std::int32_t>(i)), b, X_BA.inverse(), to_bullet(X_BA)};
    search.walk(0);
    depth = std::max(depth, search.depth);
  }
  return depth;
}

}  // namespace volute::sim
