// The tool assembly as convex pieces that FCL knows, grown or shrunk by a clearance.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fcl/geometry/collision_geometry.h>

#include "kinematics/model/tool.hpp"

namespace volute::planner {

/// One convex piece of revolution in the tool frame T (z along the axis from the tip).
struct ToolPiece {
  enum class Kind { ball, frustum, corner };
  std::string part;  ///< "cutter" "shank" "holder"
  Kind kind = Kind::frustum;
  double z_min_mm = 0.0, z_max_mm = 0.0;  ///< ball: the centre stands in the middle
  double bottom_radius_mm = 0.0, top_radius_mm = 0.0;
  double corner_radius_mm = 0.0;  ///< corner: of the arc from the flat bottom to the side
};

/// Cutter (ball first), shank, holder: from the tip upwards.
std::vector<ToolPiece> tool_pieces(const kinematics::Tool& tool);

/// An FCL shape with its centre on the tool axis, and the truncated cone round it (for a ball or a cylinder: a
/// cylinder).
struct PlacedShape {
  std::shared_ptr<const fcl::CollisionGeometryd> shape;
  bool is_ball = false;
  double centre_z_mm = 0.0;
  double z_min_mm = 0.0, z_max_mm = 0.0;
  double bottom_radius_mm = 0.0, top_radius_mm = 0.0;
  [[nodiscard]] double radius_mm() const { return bottom_radius_mm > top_radius_mm ? bottom_radius_mm : top_radius_mm; }
  /// The cone is the shape itself: a point inside the cone is inside the shape.
  bool is_cone = false;
  /// The cone with its radii times this lies inside the shape; 0: none is known.
  double inner_share = 0.0;
  /// A bull cutter's corner lies within the balls of outer_arc_mm about the points of a disc, and holds those of
  /// inner_arc_mm. Other shapes: has_disc is false.
  bool has_disc = false;
  double disc_z_mm = 0.0, disc_radius_mm = 0.0, outer_arc_mm = 0.0, inner_arc_mm = 0.0;
  /// Farthest point of the cone round it from the tip.
  [[nodiscard]] double reach_mm() const {
    return std::hypot(std::max(std::abs(z_min_mm), std::abs(z_max_mm)), radius_mm());
  }
};

/// The piece grown by `growth_mm` on all sides (shrunk when negative). Cylinders and balls are exact but for the flat
/// ends' rims, which are kept square (outside); cones and arcs are polyhedra: outside the true shape by at most 1 % of
/// the radius when grown, inside by at most a quarter of the shrinkage when shrunk.
PlacedShape placed_shape(const ToolPiece& piece, double growth_mm);

/// Does the shape, its centre brought to `X`, meet the triangle? FCL's narrow phase (libccd). Requires: not a ball.
bool meets_triangle(const PlacedShape& shape, const fcl::Transform3d& X, const fcl::Vector3d& a_mm,
                    const fcl::Vector3d& b_mm, const fcl::Vector3d& c_mm);

}  // namespace volute::planner
