// Tool axes along a path: from CC points to a tool path that is free of interference and smooth in the machine's axes.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "geometry/result.hpp"
#include "kinematics/model/tool_path.hpp"
#include "planner/interference.hpp"
#include "planner/options.hpp"
#include "planner/orientation/rotary_chart.hpp"
#include "planner/orientation/turn_means.hpp"
#include "planner/path/cc_path.hpp"

namespace volute::planner {

/// Peaks at programmed feed, before the control; rad/s, rad/s^2, rad/s^3.
struct AxisMotionPeaks {
  double velocity_max = 0.0, acceleration_max = 0.0, jerk_max = 0.0, velocity_rms = 0.0, acceleration_rms = 0.0,
         jerk_rms = 0.0;
};

struct OrientationReport {
  std::string smoothing;
  int pins = 0, iterations = 0;
  double solve_s = 0.0;                                   ///< the smoothing's linear algebra alone
  int interferences_before = 0, interferences_after = 0;  ///< CC points (with the motion to the next) that touch
  double neighbour_turn_max_rad = 0.0;                    ///< largest turn of the axis between neighbouring passes
  char first_letter = 'A', second_letter = 'C';
  AxisMotionPeaks first, second;
  std::vector<std::string> notes;
};

struct OrientedPath {
  kinematics::ToolPath tool_path;  ///< cutting and links only; leads and rapids are added by plan()
  OrientationReport report;
  std::vector<std::array<double, 2>> rotaries_rad;  ///< (axes[3], axes[4]) at every point, unwrapped
  std::vector<int> pins;                            ///< indices of pinned points
};

/// Feed directions are chords this far to both sides: longer than a facet, shorter than a pass.
constexpr double feed_window_mm = 1.0;

/// What a piece knows of the others. A path of one piece: nothing.
struct AmongPieces {
  const TurnMeans* turns = nullptr;  ///< of the whole path: the calm directions of all pieces then agree
  /// The rotaries at the end of the piece before, and where it ends: the rapid from there turns as little as may be.
  std::optional<Rotaries> rotaries_before_rad;
  Vec3 point_before_P_mm = Vec3::Zero();
};

/// Orients one piece. Errors (bad_input): orientation-none (names the CC points where no orientation is allowed and
/// what blocks them), orientation-not-converged.
Result<OrientedPath> orient(const CcPiece& piece, const kinematics::Tool& tool, const kinematics::Machine& machine,
                            const kinematics::Setup& setup, const Interference& interference,
                            const OrientationOptions& options, double feed_mm_s, const AmongPieces& among = {});

}  // namespace volute::planner
