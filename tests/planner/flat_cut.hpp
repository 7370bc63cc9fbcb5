// A straight cut over a flat plate, for tests of what goes before and after it.
#pragma once

#include <algorithm>

#include "planner/leads.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner::testing {

using kinematics::ToolPath;
using kinematics::ToolPathPoint;

constexpr double clearance_z_mm = 25.0, lead_radius_mm = 4.0;

/// A straight cut along x over a flat plate at z = 0, the axis leaning by `tilt` backwards (against the feed).
struct FlatCut {
  Scene scene;
  kinematics::Tool tool = ball_tool();
  ProcessOptions process;
  double tilt_rad = 0.0;
  std::optional<geometry::TriangleMesh> stock_P;

  FlatCut() {
    scene.part = sheet(-40, 40, -20, 20, 2.0, [](double, double) { return 0.0; });
    process.lead_radius_mm = lead_radius_mm;
  }
  [[nodiscard]] ToolPathPoint at(double x, double y = 0.0) const {
    ToolPathPoint p;
    p.contact_P_mm = Vec3(x, y, 0.0);
    p.normal_P = Vec3::UnitZ();
    p.pose.axis_P = Vec3(-std::sin(tilt_rad), 0.0, std::cos(tilt_rad));
    p.pose.tip_P_mm = p.contact_P_mm + 3.0 * p.normal_P - 3.0 * p.pose.axis_P;
    p.feed_mm_s = 10.0;
    return p;
  }
  [[nodiscard]] ToolPath cut(double y = 0.0) const {
    ToolPath path;
    for (double x = -20.0; x <= 20.0; x += 1.0) path.points.push_back(at(x, y));
    return path;
  }
  [[nodiscard]] geometry::Result<ToolPath> planned() const {
    const Interference interference(scene, tool, nullptr, nullptr);
    const Interference beyond(rapid_scene(scene, stock_P, process.safe_distance_mm), tool, nullptr, nullptr);
    return Leads(tool, interference, beyond, process, clearance_z_mm).with_leads(cut(), 7);
  }
};

/// Least height of any point of the assembly above z = 0, from its rings: an independent measure of "clear".
inline double lowest_z_mm(const kinematics::Tool& tool, const kinematics::ToolPose& pose) {
  const double across = std::sqrt(std::max(0.0, 1.0 - pose.axis_P.z() * pose.axis_P.z()));
  const auto ring = [&](double z, double radius) { return pose.tip_P_mm.z() + z * pose.axis_P.z() - radius * across; };
  double low = (pose.tip_P_mm + 3.0 * pose.axis_P).z() - 3.0;  // the ball
  low = std::min({low, ring(20.0, 3.0), ring(tool.stick_out_mm, tool.shank_radius_mm)});
  for (const auto& cone : tool.holder)
    low = std::min({low, ring(cone.z_mm, cone.bottom_radius_mm), ring(cone.z_mm + cone.length_mm, cone.top_radius_mm)});
  return low;
}

}  // namespace volute::planner::testing
