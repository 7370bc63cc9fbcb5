// The planner's table of contents: surface -> CC path -> oriented tool path with leads and rapids.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "planner/interference.hpp"
#include "planner/options.hpp"
#include "planner/orientation/orient.hpp"
#include "planner/path/cc_path.hpp"

namespace volute::planner {

struct PlanRequest {
  geometry::TriangleMesh surface;  ///< from geometry::machinable_surface
  kinematics::Tool tool;
  Scene scene;                                    ///< scene.part is normally the surface
  std::optional<geometry::TriangleMesh> stock_P;  ///< a closed mesh that rapids keep the safe distance from
  PathOptions path;
  OrientationOptions orientation;
  ProcessOptions process;
  kinematics::Machine machine;
  kinematics::Setup setup;
  /// Called with a stage's name and the share done (0 to 1); may be empty. From one thread.
  std::function<void(std::string_view stage, double done)> progress;
};

struct PlanResult {
  kinematics::ToolPath tool_path;  ///< complete: approach, cut, links, retract
  CcPathResult cc;
  OrientationReport orientation;
  std::vector<std::array<double, 2>> rotaries_rad;  ///< for cut points in order
  std::map<std::string, double> timing_s;           ///< stage -> seconds
};

Result<PlanResult> plan(const PlanRequest& request);

}  // namespace volute::planner
