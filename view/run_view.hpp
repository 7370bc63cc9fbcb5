// All that pictures and the report need of a run, and the functions that draw it. view knows no planner.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/angle.hpp"
#include "geometry/mesh.hpp"
#include "geometry/result.hpp"
#include "kinematics/model/control.hpp"
#include "kinematics/model/tool_path.hpp"
#include "sim/finding.hpp"
#include "sim/machining/cut_surface.hpp"
#include "sim/verify.hpp"

namespace volute::view {

using geometry::Result;

/// What the tool was allowed to do, beside the bodies: enough to ask again which orientations are free at a point.
struct OrientationRule {
  geometry::Angle tilt, yaw;           ///< planned, from the normal and about it
  geometry::Angle tilt_min, tilt_max;  ///< limits from the normal
  double clearance_mm = 0.0, gouge_tolerance_mm = 0.0;
  std::size_t fixtures = 0;                         ///< the last so many of the obstacles are fixtures
  std::vector<std::array<double, 2>> rotaries_rad;  ///< (axes[3], axes[4]) at the cutting points, in order
};

/// A run as it is drawn. Empty members leave their picture out. Part frame P throughout.
struct RunView {
  std::string title;  ///< "mouse on ac-head-fanuc"
  geometry::TriangleMesh surface_P;
  std::vector<geometry::TriangleMesh> obstacles_P;
  std::vector<std::string> obstacle_names;
  kinematics::Tool tool;
  kinematics::Setup setup;
  std::optional<kinematics::Profile> profile;
  kinematics::ToolPath tool_path;  ///< what was planned (or read from CL data); may be empty for foreign programs
  std::optional<OrientationRule> orientation;  ///< of what was planned
  sim::TraceView trace;                        ///< what the axes did
  std::optional<sim::CutSurfaceReport> cut;
  std::vector<sim::Finding> findings;
  std::string report_json;  ///< report.json as text: the numbers that the page shows
  std::string program_name, program_text;
  // the map, when the method has one
  std::vector<geometry::Vec2> map_vertices;
  std::vector<geometry::Triangle> map_triangles;
  std::vector<std::vector<geometry::Vec2>> map_guide_lines;
};

/// Keeps a run's view in `folder` (view.cbor.z) so that `volute render` can draw it again.
Result<void> save_view(const RunView& view, const std::filesystem::path& folder);
/// Errors (bad_input): view-missing: the folder is not a run's.
Result<RunView> load_view(const std::filesystem::path& folder);

/// Every picture and plot that the view has data for, into `folder`; returns the file names written, in order:
/// path.png (path on the part, coloured by turn), orientation.png, machined.png (deviation with legend), map.png,
/// machine.png, rotary-axes.svg (A and C over time with limits), feed.svg, loads.svg ... Property: a view that was
/// saved and loaded gives the same bytes.
Result<std::vector<std::string>> write_pictures(const RunView& view, const std::filesystem::path& folder);

/// One self-contained page, no network: verdict, numbers, findings, 3D playback, axis plots.
Result<void> write_report_html(const RunView& view, const std::filesystem::path& file);

}  // namespace volute::view
