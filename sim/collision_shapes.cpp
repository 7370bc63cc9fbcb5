#include "sim/collision_shapes.hpp"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "sim/machining/cutter_profile.hpp"

namespace volute::sim {
namespace {

btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// std::hypot guards against lengths near the ends of the number range, which there are none of here, at ten times the
/// price.
double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// A convex solid of revolution about z told by its support function: Bullet's own cylinder and cone cannot be a
/// frustum.
class RevolvedShape : public btConvexInternalShape {
 public:
  RevolvedShape() {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    btConvexInternalShape::setMargin(0.0);
  }
  /// (radius, z) of the outline's farthest point in the direction (away from the axis, along it).
  [[nodiscard]] virtual Vec2 outline(double away, double along) const = 0;

  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& d) const override {
    const double away = length_of(d.x(), d.y());
    const Vec2 p = outline(away, d.z());
    if (away > 0.0) return {p.x() * d.x() / away, p.x() * d.y() / away, p.y()};
    return {p.x(), 0.0, p.y()};
  }
  btVector3 localGetSupportingVertex(const btVector3& d) const override {
    return localGetSupportingVertexWithoutMargin(d);
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* d, btVector3* out, int count) const override {
    for (int i = 0; i < count; ++i) out[i] = localGetSupportingVertexWithoutMargin(d[i]);
  }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
  [[nodiscard]] const char* getName() const override { return "revolved"; }
};

class FrustumShape final : public RevolvedShape {
 public:
  explicit FrustumShape(const kinematics::ConeSegment& s) : s_(s) {}
  [[nodiscard]] Vec2 outline(double away, double along) const override {
    const Vec2 bottom(s_.bottom_radius_mm, s_.z_mm), top(s_.top_radius_mm, s_.z_mm + s_.length_mm);
    const Vec2 d(away, along);
    return d.dot(top) > d.dot(bottom) ? top : bottom;
  }

 private:
  kinematics::ConeSegment s_;
};

class CutterShape final : public RevolvedShape {
 public:
  CutterShape(const CutterProfile& profile, double lift_mm) : profile_(profile), lift_(0.0, lift_mm) {}
  [[nodiscard]] Vec2 outline(double away, double along) const override {
    const double length = length_of(away, along);
    return profile_.support(length > 0.0 ? along / length : -1.0) + lift_;
  }

 private:
  CutterProfile profile_;
  Vec2 lift_;
};

class FrustumPiece final : public ConvexPiece {
 public:
  explicit FrustumPiece(const kinematics::ConeSegment& s) : s_(s), shape_(s) {
    centre_mm = Vec3(0.0, 0.0, s.z_mm + 0.5 * s.length_mm);
    radius_mm = std::hypot(0.5 * s.length_mm, std::max(s.bottom_radius_mm, s.top_radius_mm));
  }
  [[nodiscard]] const btConvexShape& shape() const override { return shape_; }
  [[nodiscard]] double distance_bound_mm(const Vec3& p) const override {
    const double radius = length_of(p.x(), p.y());
    const double below = std::max({s_.z_mm - p.z(), p.z() - s_.z_mm - s_.length_mm, 0.0});
    const double slope = s_.length_mm > 0.0 ? (s_.top_radius_mm - s_.bottom_radius_mm) / s_.length_mm : 0.0;
    const double wall = s_.bottom_radius_mm + slope * (p.z() - s_.z_mm);
    const double beside = std::max(0.0, (radius - wall) / std::sqrt(1.0 + slope * slope));
    const double outside = std::max(0.0, radius - std::max(s_.bottom_radius_mm, s_.top_radius_mm));
    return std::max(beside, length_of(below, outside));
  }

 private:
  kinematics::ConeSegment s_;
  FrustumShape shape_;
};

class CutterPiece final : public ConvexPiece {
 public:
  CutterPiece(const CutterProfile& profile, double lift_mm)
      : profile_(profile), lift_mm_(lift_mm), shape_(profile, lift_mm) {
    centre_mm = Vec3(0.0, 0.0, lift_mm + 0.5 * profile.length_mm());
    radius_mm = std::hypot(0.5 * profile.length_mm(), profile.greatest_radius_mm());
  }
  [[nodiscard]] const btConvexShape& shape() const override { return shape_; }
  [[nodiscard]] double distance_bound_mm(const Vec3& p) const override {
    return std::max(0.0, profile_.distance(length_of(p.x(), p.y()), p.z() - lift_mm_).value_mm);
  }

 private:
  CutterProfile profile_;
  double lift_mm_;
  CutterShape shape_;
};

/// A piece given by points: bounded by the box about them.
class PointsPiece : public ConvexPiece {
 public:
  explicit PointsPiece(const std::vector<Vec3>& points_mm) {
    for (const Vec3& p : points_mm) box_.extend(p);
    centre_mm = box_.center();
    for (const Vec3& p : points_mm) radius_mm = std::max(radius_mm, (p - centre_mm).norm());
  }
  [[nodiscard]] double distance_bound_mm(const Vec3& p) const override { return box_.exteriorDistance(p); }

 private:
  Eigen::AlignedBox3d box_;
};

class HullPiece final : public PointsPiece {
 public:
  explicit HullPiece(const std::vector<Vec3>& points_mm) : PointsPiece(points_mm) {
    for (const Vec3& p : points_mm) shape_.addPoint(to_bullet(p), false);
    shape_.recalcLocalAabb();
    shape_.setMargin(0.0);
  }
  [[nodiscard]] const btConvexShape& shape() const override { return shape_; }

 private:
  btConvexHullShape shape_;
};

class TrianglePiece final : public PointsPiece {
 public:
  TrianglePiece(const Vec3& a, const Vec3& b, const Vec3& c)
      : PointsPiece({a, b, c}), shape_(to_bullet(a), to_bullet(b), to_bullet(c)) {
    shape_.setMargin(0.0);
    const Vec3 normal = (b - a).cross(c - a);
    if (normal.norm() > 0.0) face = Face{normal.normalized(), normal.normalized().dot(a)};
  }
  [[nodiscard]] const btConvexShape& shape() const override { return shape_; }

 private:
  btTriangleShape shape_;
};

}  // namespace

double ConvexPiece::reach_mm(const Vec3& direction) const {
  const btVector3 d = to_bullet(direction);
  return shape().localGetSupportVertexWithoutMarginNonVirtual(d).dot(d);
}

std::unique_ptr<ConvexPiece> frustum_piece(const kinematics::ConeSegment& segment) {
  return std::make_unique<FrustumPiece>(segment);
}

std::unique_ptr<ConvexPiece> cutter_piece(const kinematics::Cutter& cutter, double inset_mm) {
  VOLUTE_CHECK(inset_mm >= 0.0 && inset_mm < cutter.radius_mm && 2.0 * inset_mm < cutter.length_mm, inset_mm,
               cutter.radius_mm);
  kinematics::Cutter inner = cutter;
  inner.radius_mm -= inset_mm;
  inner.corner_radius_mm = std::max(0.0, inner.corner_radius_mm - inset_mm);
  inner.length_mm -= 2.0 * inset_mm;
  return std::make_unique<CutterPiece>(CutterProfile(inner), inset_mm);
}

std::unique_ptr<ConvexPiece> hull_piece(const std::vector<Vec3>& points_mm) {
  return std::make_unique<HullPiece>(points_mm);
}

std::unique_ptr<ConvexPiece> triangle_piece(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::make_unique<TrianglePiece>(a, b, c);
}

}  // namespace volute::sim
