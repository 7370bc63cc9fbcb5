#include "planner/interference_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include "geometry/check.hpp"

namespace volute::planner {

using kinematics::Cutter;
using kinematics::CutterShape;
using kinematics::ProfilePoint;

namespace {

constexpr int cone_sides = 32, cone_sides_max = 360;
constexpr int corner_sides = 96;        // inscribed or circumscribed: 0.05 %
constexpr double least_ring_mm = 1e-4;  // a ring of no radius would make faces without area

/// A polyhedron of revolution from rings that rise in z.
std::shared_ptr<const fcl::CollisionGeometryd> polyhedron(const std::vector<ProfilePoint>& rings, int sides) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  auto faces = std::make_shared<std::vector<int>>();
  for (const ProfilePoint& ring : rings) {
    for (int k = 0; k < sides; ++k) {
      const double a = 2.0 * std::numbers::pi * k / sides;
      vertices->emplace_back(ring.radius_mm * std::cos(a), ring.radius_mm * std::sin(a), ring.z_mm);
    }
  }
  const int last = static_cast<int>(rings.size()) - 1;
  faces->push_back(sides);
  for (int k = sides - 1; k >= 0; --k) faces->push_back(k);
  faces->push_back(sides);
  for (int k = 0; k < sides; ++k) faces->push_back(last * sides + k);
  for (int r = 0; r < last; ++r) {
    for (int k = 0; k < sides; ++k) {
      const int next = (k + 1) % sides;
      faces->insert(faces->end(), {4, r * sides + k, r * sides + next, (r + 1) * sides + next, (r + 1) * sides + k});
    }
  }
  return std::make_shared<const fcl::Convexd>(vertices, 2 + last * sides, faces);
}

double circumscribed(double radius_mm, int sides) { return radius_mm / std::cos(std::numbers::pi / sides); }

/// Grown cones may stand 0.48 % outside; shrunk ones no more than a quarter of the shrinkage inside.
int sides_of_cone(double radius_mm, double growth_mm) {
  if (growth_mm >= 0.0) return cone_sides;
  const double half_side = std::acos(std::max(1.0 + 0.25 * growth_mm / radius_mm, 0.0));
  return std::clamp(static_cast<int>(std::ceil(std::numbers::pi / half_side)), cone_sides, cone_sides_max);
}

PlacedShape grown_ball(const ToolPiece& piece, double growth_mm) {
  PlacedShape placed;
  placed.is_ball = true;
  placed.centre_z_mm = 0.5 * (piece.z_min_mm + piece.z_max_mm);
  const double radius = std::max(piece.bottom_radius_mm + growth_mm, least_ring_mm);
  placed.bottom_radius_mm = placed.top_radius_mm = radius;
  placed.z_min_mm = placed.centre_z_mm - radius;
  placed.z_max_mm = placed.centre_z_mm + radius;
  placed.shape = std::make_shared<const fcl::Sphered>(radius);
  return placed;
}

PlacedShape grown_frustum(const ToolPiece& piece, double growth_mm) {
  PlacedShape placed;
  const double slope = (piece.top_radius_mm - piece.bottom_radius_mm) / (piece.z_max_mm - piece.z_min_mm);
  // The side moves out by growth along its normal; the ends are cut where the ends move to.
  const double out = growth_mm * std::sqrt(1.0 + slope * slope);
  const double end =
      std::min(std::max(growth_mm, -0.45 * (piece.z_max_mm - piece.z_min_mm)), growth_mm < 0.0 ? 0.0 : growth_mm);
  placed.z_min_mm = piece.z_min_mm - end;
  placed.z_max_mm = piece.z_max_mm + end;
  const double bottom = std::max(piece.bottom_radius_mm + out - slope * end, least_ring_mm);
  const double top = std::max(piece.top_radius_mm + out + slope * end, least_ring_mm);
  placed.is_cone = true;
  placed.bottom_radius_mm = bottom;
  placed.top_radius_mm = top;
  const int sides = sides_of_cone(std::max(bottom, top), growth_mm);
  placed.inner_share = slope == 0.0 ? 1.0 : std::cos(std::numbers::pi / sides);
  if (slope == 0.0) {
    placed.centre_z_mm = 0.5 * (placed.z_min_mm + placed.z_max_mm);
    placed.shape = std::make_shared<const fcl::Cylinderd>(bottom, placed.z_max_mm - placed.z_min_mm);
    return placed;
  }
  const bool grow = growth_mm >= 0.0;
  const double b = grow ? circumscribed(bottom, sides) : bottom, t = grow ? circumscribed(top, sides) : top;
  placed.bottom_radius_mm = b;
  placed.top_radius_mm = t;
  // The polyhedron's flats lie inside the cone through its corners, so what is inside this cone is not surely inside
  // the shape.
  placed.is_cone = false;
  placed.shape = polyhedron({{placed.z_min_mm, b}, {placed.z_max_mm, t}}, sides);
  return placed;
}

/// Disc of the bottom grown by an arc: the corner of a bull cutter.
PlacedShape grown_corner(const ToolPiece& piece, double growth_mm) {
  const double arc = std::max(piece.corner_radius_mm + growth_mm, least_ring_mm);
  const double circle = piece.top_radius_mm - piece.corner_radius_mm;
  const bool grow = growth_mm >= 0.0;
  const double sagitta = grow ? 0.01 * arc : std::max(0.25 * -growth_mm, 1e-4);
  const double step = 2.0 * std::acos(std::max(1.0 - sagitta / arc, 0.5));
  const int pieces = std::clamp(static_cast<int>(std::ceil(0.5 * std::numbers::pi / step)), 3, 24);
  const double reach = grow ? arc / std::cos(0.25 * std::numbers::pi / pieces) : arc;
  std::vector<ProfilePoint> rings;
  PlacedShape placed;
  for (int k = 0; k <= pieces; ++k) {
    const double a = 0.5 * std::numbers::pi * k / pieces;
    const double radius = circle + reach * std::sin(a);
    rings.push_back(
        {piece.corner_radius_mm - reach * std::cos(a), grow ? circumscribed(radius, corner_sides) : radius});
  }
  placed.z_min_mm = rings.front().z_mm;
  placed.z_max_mm = rings.back().z_mm;
  placed.bottom_radius_mm = placed.top_radius_mm = rings.back().radius_mm;
  placed.shape = polyhedron(rings, corner_sides);
  placed.has_disc = true;
  placed.disc_z_mm = piece.corner_radius_mm;
  placed.disc_radius_mm = grow ? circumscribed(circle, corner_sides) : circle;
  placed.outer_arc_mm = grow ? circumscribed(reach, corner_sides) : arc;
  // Grown, the polyhedron holds the true shape; shrunk, its flats cut into it between the corners.
  const double flats = arc * (1.0 - std::cos(0.25 * std::numbers::pi / pieces)) +
                       (circle + arc) * (1.0 - std::cos(std::numbers::pi / corner_sides));
  placed.inner_arc_mm = grow ? arc - (placed.disc_radius_mm - circle) : std::max(arc - flats, 0.0);
  return placed;
}

void add_cutter(const Cutter& cutter, std::vector<ToolPiece>& pieces) {
  const double r = cutter.radius_mm;
  using Kind = ToolPiece::Kind;
  switch (cutter.shape) {
    case CutterShape::ball:
      pieces.push_back({"cutter", Kind::ball, 0.0, 2.0 * r, r, r, r});
      if (cutter.length_mm > r) pieces.push_back({"cutter", Kind::frustum, r, cutter.length_mm, r, r, 0.0});
      break;
    case CutterShape::taper_ball: {
      const double z = r * (1.0 - sin(cutter.taper)), at_z = r * cos(cutter.taper);
      pieces.push_back({"cutter", Kind::ball, 0.0, 2.0 * r, r, r, r});
      if (cutter.length_mm > z)
        pieces.push_back({"cutter", Kind::frustum, z, cutter.length_mm, at_z,
                          at_z + (cutter.length_mm - z) * tan(cutter.taper), 0.0});
      break;
    }
    case CutterShape::flat:
      pieces.push_back({"cutter", Kind::frustum, 0.0, cutter.length_mm, r, r, 0.0});
      break;
    case CutterShape::bull:
      pieces.push_back({"cutter", Kind::corner, 0.0, cutter.corner_radius_mm, r - cutter.corner_radius_mm, r,
                        cutter.corner_radius_mm});
      if (cutter.length_mm > cutter.corner_radius_mm)
        pieces.push_back({"cutter", Kind::frustum, cutter.corner_radius_mm, cutter.length_mm, r, r, 0.0});
      break;
  }
}

}  // namespace

std::vector<ToolPiece> tool_pieces(const kinematics::Tool& tool) {
  std::vector<ToolPiece> pieces;
  add_cutter(tool.cutter, pieces);
  if (tool.stick_out_mm > tool.cutter.length_mm && tool.shank_radius_mm > 0.0) {
    pieces.push_back({"shank", ToolPiece::Kind::frustum, tool.cutter.length_mm, tool.stick_out_mm, tool.shank_radius_mm,
                      tool.shank_radius_mm, 0.0});
  }
  for (const kinematics::ConeSegment& cone : tool.holder) {
    if (cone.length_mm <= 0.0) continue;
    pieces.push_back({"holder", ToolPiece::Kind::frustum, cone.z_mm, cone.z_mm + cone.length_mm, cone.bottom_radius_mm,
                      cone.top_radius_mm, 0.0});
  }
  return pieces;
}

PlacedShape placed_shape(const ToolPiece& piece, double growth_mm) {
  switch (piece.kind) {
    case ToolPiece::Kind::ball:
      return grown_ball(piece, growth_mm);
    case ToolPiece::Kind::corner:
      return grown_corner(piece, growth_mm);
    case ToolPiece::Kind::frustum:
      break;
  }
  return grown_frustum(piece, growth_mm);
}

bool meets_triangle(const PlacedShape& shape, const fcl::Transform3d& X, const fcl::Vector3d& a_mm,
                    const fcl::Vector3d& b_mm, const fcl::Vector3d& c_mm) {
  VOLUTE_CHECK(!shape.is_ball, shape.radius_mm());
  const fcl::detail::GJKSolver_libccdd solver;
  const auto meets = [&](const auto& body) {
    return solver.shapeTriangleIntersect(body, X, a_mm, b_mm, c_mm, nullptr, nullptr, nullptr);
  };
  return shape.shape->getNodeType() == fcl::GEOM_CYLINDER ? meets(static_cast<const fcl::Cylinderd&>(*shape.shape))
                                                          : meets(static_cast<const fcl::Convexd&>(*shape.shape));
}

}  // namespace volute::planner
