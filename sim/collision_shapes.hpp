// Convex pieces for Bullet in double precision, and bodies made of many of them.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "kinematics/model/tool.hpp"

class btConvexShape;

namespace volute::sim {

using geometry::Transform;
using geometry::Vec3;

/// One convex piece in its body's frame. The bound is quick and never greater than the true distance.
class ConvexPiece {
 public:
  virtual ~ConvexPiece() = default;
  [[nodiscard]] virtual const btConvexShape& shape() const = 0;
  /// A lower bound of the distance from a point (body frame) to the piece; 0 inside.
  [[nodiscard]] virtual double distance_bound_mm(const Vec3& point_mm) const = 0;
  /// The greatest of direction . p over the piece's points p. Requires: a unit vector.
  [[nodiscard]] double reach_mm(const Vec3& direction) const;
  Vec3 centre_mm = Vec3::Zero();  ///< of a ball that holds the piece
  double radius_mm = 0.0;
  struct Face {
    Vec3 normal;
    double offset_mm;
  };
  std::optional<Face> face;  ///< the plane normal . p = offset that a flat piece lies in
};

/// A frustum about the z axis (a cylinder when the radii are equal), exact.
std::unique_ptr<ConvexPiece> frustum_piece(const kinematics::ConeSegment& segment);
/// The cutter's envelope about the z axis from the tip, taken in by `inset_mm` on all sides, exact. Requires: inset_mm
/// < radius.
std::unique_ptr<ConvexPiece> cutter_piece(const kinematics::Cutter& cutter, double inset_mm);
/// The convex hull of points.
std::unique_ptr<ConvexPiece> hull_piece(const std::vector<Vec3>& points_mm);
std::unique_ptr<ConvexPiece> triangle_piece(const Vec3& a, const Vec3& b, const Vec3& c);

/// Pieces that move together, in a tree of balls.
class CollisionBody {
 public:
  CollisionBody(std::string name, std::vector<std::unique_ptr<ConvexPiece>> pieces);
  /// Every triangle a piece.
  static CollisionBody of_triangles(std::string name, const geometry::TriangleMesh& mesh);
  /// Convex components of the mesh become hulls, all others stay triangles.
  static CollisionBody of_components(std::string name, const geometry::TriangleMesh& mesh);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  [[nodiscard]] std::size_t piece_count() const { return pieces_.size(); }
  [[nodiscard]] const Vec3& centre_mm() const { return nodes_.front().centre_mm; }
  [[nodiscard]] double radius_mm() const { return nodes_.front().radius_mm; }

  struct Node {
    Vec3 centre_mm = Vec3::Zero();
    double radius_mm = 0.0;
    std::int32_t first = 0, right = 0, count = 0;
  };
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const ConvexPiece& piece(std::int32_t i) const { return *pieces_[static_cast<std::size_t>(i)]; }

 private:
  std::int32_t build(std::int32_t first, std::int32_t count);
  std::string name_;
  std::vector<std::unique_ptr<ConvexPiece>> pieces_;
  std::vector<Node> nodes_;
};

/// Distances above `exact_below_mm` may be told this share too great.
constexpr double far_distance_error = 0.05;

/// Distance between two bodies when it is below `bound_mm`, else bound_mm. Zero or negative: they meet, and the value
/// is minus the depth in the first pair of pieces found to meet. `X_BA` takes A's frame to B's. `pairs` counts Bullet's
/// own tests. Accuracy: 1e-5 mm (Bullet's GJK with margins 0) up to `exact_below_mm`; above it the value is never too
/// small. A distance above zero and below `any_below_mm` need not be the least one: then only whether the bodies meet
/// is looked for further.
double body_distance_mm(const CollisionBody& a, const CollisionBody& b, const Transform& X_BA, double bound_mm,
                        std::int64_t& pairs, double exact_below_mm = std::numeric_limits<double>::infinity(),
                        double any_below_mm = 0.0);

/// How deep two bodies that meet lie in each other: over all pairs of pieces that meet, the greatest of the shortest
/// ways that part the two pieces; 0 when none meet. Exact for two convex bodies of one piece (Bullet's EPA); with a
/// mesh, whose pieces are triangles, a lower bound. `X_BA` takes A's frame to B's.
double body_depth_mm(const CollisionBody& a, const CollisionBody& b, const Transform& X_BA);

}  // namespace volute::sim
