// What the user asks of the planner; the job file's [path], [orientation] and [process] in inside units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/angle.hpp"
#include "geometry/vector.hpp"
#include "planner/field/field_options.hpp"
#include "planner/surface/root_child.hpp"

namespace volute::planner {

using geometry::Angle;
using geometry::Vec3;

enum class Strategy { spiral, contour_parallel, projected_spiral, contour_offset, iso_planar };
enum class Method { even, periodic, paper };
enum class Direction { inward, outward };
enum class CutDirection { any, climb, conventional };

struct PathOptions {
  Strategy strategy = Strategy::spiral;
  Method method = Method::even;             ///< spiral and contour_parallel only
  double scallop_mm = 0.1;                  ///< greatest height left between passes
  double tolerance_mm = 0.01;               ///< chordal tolerance of the path that the tool takes
  Direction direction = Direction::inward;  ///< inward: from the outer boundary to the centre
  CutDirection cut_direction = CutDirection::any;  ///< else one for the whole path, which then never turns back
  double allowance_mm = 0.0;  ///< stock to leave on the surface
  int centre_loop = -1;       ///< boundary loop to end in (by falling length; 0 is the outer one); -1: chosen
  RootChild root_child = RootChild::nearest;  ///< paper, periodic: which hole is joined to the outer boundary
  std::optional<Vec3> start_P_mm;             ///< spiral, contour_parallel: begin at the boundary nearest to this place
  std::optional<double> from_turn, to_turn;   ///< only a part of the surface, between two turns
  double plane_angle_rad = 0.0;               ///< iso_planar: direction of the slicing planes about z
};

enum class Smoothing { none, velocity, acceleration, field, corridor };
enum class Weights { arc_length, as_printed };

/// A tool orientation that the user fixes: at the path's fraction (0 to 1 of its length) or, for fields, at a surface
/// point.
struct KeyOrientation {
  std::optional<double> path_fraction;
  std::optional<Vec3> point_P_mm;
  Vec3 axis_P = Vec3::UnitZ();
};

struct OrientationOptions {
  Angle tilt = Angle::degrees(10.0);                ///< alpha of [Sun2016] eq. 23: from the surface normal
  Angle yaw;                                        ///< beta: about the normal, from the feed direction
  Angle tilt_min, tilt_max = Angle::degrees(60.0);  ///< process limits from the normal
  Smoothing smoothing = Smoothing::acceleration;
  Weights weights = Weights::arc_length;
  std::vector<KeyOrientation> keys;
  FieldOptions field;                ///< smoothing = field: basis and width
  int iterations_max = 40;           ///< of the loop of [Sun2016] Fig. 8
  double clearance_mm = 1.0;         ///< kept by shank and holder
  double gouge_tolerance_mm = 0.01;  ///< the cutter may go this deep
};

/// How the tool comes down to the surface, in the plane of path and normal: a tangent quarter circle, or a straight
/// line at ramp_angle to the surface.
enum class LeadShape { arc, ramp };

struct ProcessOptions {
  double feed_mm_s = 250.0 / 60.0;
  double approach_feed_mm_s = 0.0;  ///< 0: as feed
  double spindle_rad_s = 0.0;
  double clearance_height_mm = 20.0;  ///< rapids run this far above the highest point of part and obstacles
  double safe_distance_mm = 3.0;      ///< rapids down end where the tool comes this near to part, stock or obstacles
  double lead_radius_mm = 0.0;        ///< of the tangent arc that enters and leaves, height of a ramp; 0: cutter radius
  double link_lead_radius_mm = 0.0;   ///< likewise where the tool lifts between near pieces; 0: a fifth of the cutter's
  LeadShape lead_shape = LeadShape::arc;
  Angle ramp_angle = Angle::degrees(15.0);  ///< of a ramp to the surface
};

}  // namespace volute::planner
