// Bounding spheres over the triangles of a mesh: quick lower bounds on distances, before an exact library is asked.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/vector.hpp"

namespace volute::planner {

using geometry::Vec3;

/// A truncated cone on the line through `base_mm` along the unit `axis`, from z_min_mm to z_max_mm along it.
struct AxialCone {
  Vec3 base_mm = Vec3::Zero(), axis = Vec3::UnitZ();
  double z_min_mm = 0.0, z_max_mm = 0.0, bottom_radius_mm = 0.0, top_radius_mm = 0.0;
};

/// How far the points of a body move when it turns about a pivot: one that stands r mm from it by no more than
/// min(slope_mm_per_mm r, offset_mm + far_slope_mm_per_mm r), and to a place that stands r from it too.
struct TurnBound {
  Vec3 pivot_mm = Vec3::Zero();
  double slope_mm_per_mm = 0.0;
  double offset_mm = 0.0, far_slope_mm_per_mm = 0.0;
  /// What of the body (grown as it is) comes as near to the pivot as within_mm lies in this ball, whatever the turn.
  /// within_mm = 0: nothing is known.
  Vec3 ball_centre_mm = Vec3::Zero();
  double ball_radius_mm = 0.0, within_mm = 0.0;
  [[nodiscard]] double moved_mm(double from_pivot_mm) const {
    const double near = slope_mm_per_mm * from_pivot_mm, far = offset_mm + far_slope_mm_per_mm * from_pivot_mm;
    return near < far ? near : far;
  }
};

/// A lower bound on the distance from a point to the solid cone, mm: exact for a cylinder; 0 exactly when the point is
/// inside.
double distance_bound_mm(const AxialCone& cone, const Vec3& point_mm);
/// How deep the point stands in the solid cone, mm: negative outside. Changes by no more than the point moves.
double depth_in_cone_mm(const AxialCone& cone, const Vec3& point_mm);
/// Distance from a point to a triangle, mm (Ericson 2005, 5.1.5).
double distance_mm(const Vec3& point_mm, const Vec3& a_mm, const Vec3& b_mm, const Vec3& c_mm);

/// Built once, then read by any number of threads.
/// Properties, each with a test of that name: 1. ClearanceIsLowerBound. 2. PointDistanceIsExact. 3. ParityTellsInside.
/// 4. MeshDistanceIsExact. 5. DepthIsLowerBound.
/// (What holds for turns is tested by Interference's properties 6 and 7.)
/// Large triangles are cut up first: a sphere round a long sliver bounds nothing.
class SphereTree {
 public:
  /// Keeps its own copy of the corners.
  explicit SphereTree(const geometry::TriangleMesh& mesh);

  /// A lower bound on the distance between the cone and the mesh, at most `cap_mm`; below the truth by at most an
  /// eighth of the size of a triangle. An empty mesh: cap_mm.
  [[nodiscard]] double clearance_mm(const AxialCone& cone, double cap_mm) const;

  /// Is every point of the mesh surely farther from the cone than `by_mm`? As clearance_mm(cone, by_mm) >= by_mm, but
  /// it ends at the first triangle that cannot be told clear.
  [[nodiscard]] bool is_clear(const AxialCone& cone, double by_mm) const;

  /// Does every point of the mesh stay clear of the cone grown by `grown_mm` on all sides, wherever within `turn` it
  /// turns? A shape that turns about a point it touches can be told clear, which no distance alone could. False where
  /// it is not known.
  [[nodiscard]] bool is_clear_of_turn(const AxialCone& cone, double grown_mm, const TurnBound& turn) const;

  /// Is there a point of the mesh that stays inside the cone grown by `grown_mm`, wherever within `turn` it turns?
  /// False where none is known: corners and middles of the triangles are looked at.
  [[nodiscard]] bool is_inside_for_turn(const AxialCone& cone, double grown_mm, const TurnBound& turn) const;

  /// Does any triangle meet a shape that lies within the cone? Triangles that stand clear of the cone do not; where the
  /// cone is the shape itself a triangle with a corner or its middle inside does; `meets` is asked of the others.
  using TriangleTest = std::function<bool(const Vec3& a_mm, const Vec3& b_mm, const Vec3& c_mm)>;
  [[nodiscard]] bool any_meets(const AxialCone& cone, bool cone_is_shape, const TriangleTest& meets) const;

  /// The distance between this mesh and another that stands at `X_this_other`, at most `cap_mm`; 0 where they cross.
  /// Exact up to rounding: FCL's distance of two triangles at the leaves. Either mesh empty: cap_mm.
  [[nodiscard]] double mesh_distance_mm(const SphereTree& other, const geometry::Transform& X_this_other,
                                        double cap_mm) const;

  /// How deep a point of the mesh surely stands in the solid cone, mm; 0 when none is known to be inside. Below the
  /// truth by at most the size of a triangle.
  [[nodiscard]] double depth_mm(const AxialCone& cone) const;

  /// The distance from the point to the mesh, at most `cap_mm`. Exact up to rounding.
  [[nodiscard]] double point_distance_mm(const Vec3& point_mm, double cap_mm) const;

  /// Is the point inside the closed mesh: parity of crossings along three slanted rays, by majority.
  [[nodiscard]] bool contains(const Vec3& point_mm) const;

  [[nodiscard]] const Vec3& least_mm() const { return least_mm_; }
  [[nodiscard]] const Vec3& greatest_mm() const { return greatest_mm_; }
  /// A point of the mesh. Requires: not empty.
  [[nodiscard]] const Vec3& any_point_mm() const { return corners_.front().a; }
  [[nodiscard]] bool is_empty() const { return corners_.empty(); }

 private:
  struct Node {
    Vec3 centre_mm;
    double radius_mm;
    int first, count;  ///< triangles of a leaf; count 0: children are first and first + 1
  };
  struct Corners {
    Vec3 a, b, c;
  };
  struct Ball {
    Vec3 centre_mm;
    double radius_mm;
  };

  void fill(std::size_t node, std::span<int> order, int first, const std::vector<Corners>& all);
  /// A lower bound on the distance of the cone and the box round the mesh; not above 0 when they meet.
  [[nodiscard]] double cone_gap_mm(const AxialCone& cone) const;
  [[nodiscard]] bool triangle_is_clear(const AxialCone& cone, std::size_t triangle, double by_mm) const;
  [[nodiscard]] int crossings(const Vec3& from, const Vec3& direction) const;

  std::vector<Node> nodes_;
  std::vector<Corners> corners_;
  std::vector<Ball> balls_;  ///< round each triangle
  Vec3 least_mm_ = Vec3::Zero(), greatest_mm_ = Vec3::Zero();
};

}  // namespace volute::planner
