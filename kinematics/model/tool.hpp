// The tool assembly: cutter, shank and holder as one body of revolution about the tool axis.
#pragma once

#include <string>
#include <vector>

#include "geometry/angle.hpp"
#include "geometry/result.hpp"

namespace volute::kinematics {

enum class CutterShape { ball, bull, flat, taper_ball };

/// The cutting part. Frame T: origin at the tool tip (lowest point on the axis), z along the axis from tip to holder.
struct Cutter {
  CutterShape shape = CutterShape::ball;
  double radius_mm = 3.0;         ///< ball, bull, flat: outer radius; taper-ball: radius of the tip's ball
  double corner_radius_mm = 3.0;  ///< ball: = radius_mm; flat: 0; bull: between; taper-ball: = radius_mm
  geometry::Angle taper;          ///< taper-ball: half angle of the cone above the ball
  double length_mm = 20.0;        ///< from the tip to the end of the flutes
  int flutes = 2;
};

/// A cone or cylinder on the axis, from z_mm to z_mm + length_mm in T.
struct ConeSegment {
  double bottom_radius_mm = 0.0, top_radius_mm = 0.0, z_mm = 0.0, length_mm = 0.0;
};

struct Tool {
  std::string name = "tool";
  int number = 1;
  Cutter cutter;
  double shank_radius_mm = 3.0;     ///< from the end of the flutes to the holder
  double stick_out_mm = 40.0;       ///< tip to holder face
  std::vector<ConeSegment> holder;  ///< stacked, the first one starts at stick_out_mm
  double gauge_length_mm = 100.0;   ///< tip to the spindle's gauge line: what the control calls the tool length
};

/// Errors (bad_input), naming the TOML key: tool-radius, tool-corner-radius, tool-length, tool-stick-out, tool-holder.
geometry::Result<void> validate(const Tool& tool);
/// "ball,3" "flat,5" "bull,6,1" "taper-ball,1,5" (radius mm, corner radius mm or half angle deg). Error: cutter-spec.
geometry::Result<Cutter> parse_cutter(std::string_view spec);

/// The half section of cutter, shank and holder: points (z, radius) with z rising from the tip, exact for cones and
/// inscribed-free for arcs (the polyline never lies inside the true profile and is at most `tolerance_mm` outside it).
/// The first point is the tip (0, 0), the last one lies on the rim of the top, which is left open. Requires:
/// tolerance_mm > 0.
struct ProfilePoint {
  double z_mm = 0.0, radius_mm = 0.0;
};
std::vector<ProfilePoint> cutter_profile(const Cutter& cutter, double tolerance_mm);
std::vector<ProfilePoint> assembly_profile(const Tool& tool, double tolerance_mm);

/// Radius of the cutter's envelope at height z above the tip (exact); 0 outside [0, length], where there is no cutter.
double cutter_radius_at(const Cutter& cutter, double z_mm);

}  // namespace volute::kinematics
