// Where the tool tip is when the cutter touches the surface at a CC point with a given axis.
#pragma once

#include "geometry/angle.hpp"
#include "kinematics/model/tool.hpp"
#include "kinematics/model/tool_path.hpp"

namespace volute::planner {

using geometry::Vec3;

/// Frame of [Sun2016] eq. 23 at a CC point: T feed direction, N outward normal, B = N x T (right-handed; departs from
/// the source, whose T x N is left-handed).
struct FeedFrame {
  Vec3 feed_P, across_P, normal_P;
};
/// Requires: feed not parallel to normal.
FeedFrame feed_frame(const Vec3& feed_P, const Vec3& normal_P);
/// Tool axis for tilt alpha (from N) and yaw beta (about N, from T towards B): eq. 23.
Vec3 tool_axis(const FeedFrame& frame, geometry::Angle tilt, geometry::Angle yaw);

/// Tool pose whose cutter touches the surface at `contact_P_mm` with outward normal `normal_P`.
/// Ball: CL = CC + r N - r axis ([Huang2016] eq. 13). Flat, bull: the torus's circle nearest the contact; where the
/// axis is the normal the contact is the centre of the flat bottom. Requires axis . normal > 0 (equal 0 for taper-ball
/// flank).
kinematics::ToolPose contact_pose(const kinematics::Cutter& cutter, const Vec3& contact_P_mm, const Vec3& normal_P,
                                  const Vec3& axis_P);

/// Radius of curvature, at the contact, of the outline that the cutter shows along the feed: ball r; flat and bull by
/// tilt and yaw; infinite for a flat bottom that lies on the surface. mm
double effective_radius_mm(const kinematics::Cutter& cutter, geometry::Angle tilt, geometry::Angle yaw);

/// Width that a straight pass over a plane clears up to `height_mm` above it: of the outline seen along the feed, exact
/// for ball, flat and bull; above a taper-ball's ball the cone counts as a cylinder, which is narrower. mm
/// Requires: height_mm > 0, tilt below 90 degrees. Property: passes so far apart leave scallops of that height.
double cleared_width_mm(const kinematics::Cutter& cutter, geometry::Angle tilt, geometry::Angle yaw, double height_mm);

/// Radius of the ball that clears as much up to `height_mm`: a ball's own radius, for others what takes its place in
/// the interval formula. Between effective_radius_mm (small heights) and what the whole cutter allows. mm
double clearing_radius_mm(const kinematics::Cutter& cutter, geometry::Angle tilt, geometry::Angle yaw,
                          double height_mm);

}  // namespace volute::planner
