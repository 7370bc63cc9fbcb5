// The judge: reads a program's text, runs it, and says what really happens.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/control.hpp"
#include "sim/collision.hpp"
#include "sim/controller/control_run.hpp"
#include "sim/loads.hpp"
#include "sim/machining/cut_surface.hpp"

namespace volute::sim {

struct VerifyRequest {
  std::string text;
  std::string file_name;
  kinematics::Profile profile;
  kinematics::Setup setup;
  kinematics::Tool tool;
  std::optional<geometry::TriangleMesh> surface_P;  ///< the design surface: cut surface and gouges
  std::vector<geometry::TriangleMesh> obstacles_P;
  std::vector<std::string> obstacle_names;
  CutSurfaceOptions cut;
  double collision_step_mm = 0.5;
  double clearance_mm = 0.0;
  /// Reference to compare with (invariant 2): tip and axis per cutting point of the tool path, in order; empty:
  /// skipped.
  std::vector<kinematics::ToolPose> expected_poses;
  double expected_tolerance_mm = 0.0, expected_tolerance_rad = 0.0;
  std::function<void(std::string_view stage, double done)> progress;
};

/// The run thinned for drawing and playback: never more than `samples_max` samples, peaks kept.
struct TraceView {
  std::vector<AxisSample> samples;
  std::vector<kinematics::ToolPose> poses_P;
};

struct VerifyResult {
  RunReport run;
  std::optional<CutSurfaceReport> cut;
  std::optional<CollisionReport> collision;
  LoadsReport loads;
  std::vector<Finding> findings;      ///< sorted by severity, then line
  std::int64_t commanded_points = 0;  ///< feed points read back from the text for the comparison with `expected_poses`
  TraceView trace;
  std::map<std::string, double> timing_s;
};

/// Reads, runs, measures and judges. Memory: bounded by the moves of the thinned run (chords within 0.5 micrometres),
/// not by its time. The surface is also the part for collisions. Errors: those of the interpreter and the control.
Result<VerifyResult> verify(const VerifyRequest& request);

}  // namespace volute::sim
