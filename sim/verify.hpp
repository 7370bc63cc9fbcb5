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
#include "sim/machining/cut_picture.hpp"
#include "sim/machining/cut_surface.hpp"
#include "sim/machining/stock_run.hpp"
#include "sim/machining/stock_setup.hpp"

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
  /// Corners of the coloured mesh of the cut surface, at most; 0: none is made.
  std::size_t picture_vertices_max = 0;
  std::optional<StockSetup> stock;  ///< nothing: no material is cut
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

/// The material: what the run took, what it met, what is left.
struct StockOutcome {
  StockReport report;
  geometry::TriangleMesh skin_P;  ///< of what is left
  Eigen::AlignedBox3d box_P_mm;   ///< about the first stock
  double grid_mm = 0.0;
  bool assumed = false;
};

/// The same program on the same axes where no jerk is limited (profile trapezoid): the least time that their
/// accelerations leave. The S-curve of the virtual control keeps jerk by an average, which uses less acceleration than
/// a control that plans jerk along the path: such a control lies between the two.
struct UnlimitedJerkRun {
  double cycle_time_s = 0.0;
  double feed_loss_percent = 0.0;
  std::optional<double> machining_time_s;
};

struct VerifyResult {
  RunReport run;
  std::optional<UnlimitedJerkRun> unlimited_jerk;  ///< nothing where the control limits no jerk by itself
  std::optional<CutSurfaceReport> cut;
  std::optional<CutPicture> picture;
  std::optional<StockOutcome> stock;
  std::optional<CollisionReport> collision;
  LoadsReport loads;
  std::vector<Finding> findings;           ///< sorted by severity, then line; none: the program passed
  std::vector<Finding> warnings;           ///< what rests on assumed numbers or an assumed stock: told, not judged
  std::optional<double> machining_time_s;  ///< first to last feed move with the spindle on, rapids between included
  std::int64_t commanded_points = 0;  ///< feed points read back from the text for the comparison with `expected_poses`
  TraceView trace;
  std::map<std::string, double> timing_s;
};

/// Reads, runs, measures and judges. Memory: bounded by the moves of the thinned run (chords within 0.5 micrometres),
/// not by its time. The surface is also the part for collisions. Errors: those of the interpreter, of the control and
/// of make_stock.
Result<VerifyResult> verify(const VerifyRequest& request);

}  // namespace volute::sim
