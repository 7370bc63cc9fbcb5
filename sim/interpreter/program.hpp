// A program's text as motions: the simulator's own lexer and modal interpreter.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/result.hpp"
#include "geometry/vector.hpp"
#include "kinematics/model/control.hpp"
#include "kinematics/model/machine.hpp"

namespace volute::sim {

using geometry::Result;
using geometry::Vec3;

enum class MotionKind : std::uint8_t { rapid, line, arc, dwell, stop };
enum class FeedMode : std::uint8_t { per_minute, inverse_time, per_revolution };
enum class PathMode : std::uint8_t { exact_path, exact_stop, continuous };

/// One motion as the text says it: units mm, rad, s; modal words resolved; offsets applied to program coordinates.
struct MotionBlock {
  MotionKind kind = MotionKind::line;
  std::int64_t line = 0;  ///< 1-based line of the text
  bool tcp = false;       ///< xyz is the tool tip in the work frame; else linear axis words (machine: + program zero)
  bool machine_coordinates = false;      ///< G53, SUPA, M91: xyz and rotaries are machine coordinates
  Vec3 xyz_mm = Vec3::Zero();            ///< end point
  std::array<bool, 3> xyz_programmed{};  ///< which of X Y Z the block itself names (machine-coordinate moves need it)
  /// false: the text does not tell where this axis (under TCP: this coordinate of the tip) stands: at the start, after
  /// a machine-coordinate move, after TCP or tool length switched. Not programmed and not known means: it stays where
  /// it is; xyz_mm is meaningless there.
  std::array<bool, 3> xyz_known{};
  std::array<bool, 3> xyz_relative{};  ///< xyz_mm is a distance from where the axis (or tip) stands: an incremental
                                       ///< word while not known
  std::array<double, 2> rotary_rad{};  ///< end positions of axes[3], axes[4] (when !axis_vector)
  std::array<bool, 2> rotary_programmed{};
  std::array<bool, 2> rotary_known{};     ///< as xyz_known
  std::array<bool, 2> rotary_relative{};  ///< as xyz_relative
  bool rotary_shortest = false;           ///< absolute rotary words count modulo one turn, the short way
  std::optional<Vec3> axis_vector;        ///< unit tool axis at the end, in the work frame
  /// What the program itself asks for (ORIAXES, ORIVECT, PATHCTRL); empty: the control's own way.
  std::optional<kinematics::OrientationInterpolation> orientation_interpolation;
  // arc: centre and turns in program coordinates
  Vec3 centre_mm = Vec3::Zero();
  Vec3 plane_normal = Vec3::UnitZ();
  double sweep_rad = 0.0;  ///< signed about plane_normal, |sweep| may exceed one turn
  FeedMode feed_mode = FeedMode::per_minute;
  double feed = 0.0;         ///< mm/s (or rad/s for rotary-only); inverse_time: 1/s; per_revolution: mm
  bool rotary_only = false;  ///< the words move no linear axis (under TCP: not the tip): per_minute feed is rad/s
  PathMode path_mode = PathMode::continuous;
  double path_tolerance_mm = -1.0;  ///< < 0: none given in the program
  double rotary_tolerance_rad = -1.0;
  double naive_cam_tolerance_mm = -1.0;
  double dwell_s = 0.0;
  bool spindle_on = false;
  double spindle_rad_s = 0.0;     ///< programmed speed, never negative
  bool spindle_reversed = false;  ///< M4: counter-clockwise
  int tool_number = 0;
  bool tool_length_active = false;  ///< G43, G43.4, TRAORI with D, TOOL CALL
};

/// What the text leaves to the machine; every field may stay empty.
struct ReaderOptions {
  /// What X Y Z show in machine coordinates at the setup's program zero without tool length (kinematics::program_zero
  /// with length 0). With it G10 L2, which gives a work offset in machine coordinates, can be read; without it such a
  /// block is refused.
  std::optional<Vec3> work_zero_machine_mm;
  /// The length of the job's tool, gauge line to tip. With it LinuxCNC's G43.1, which names a length, can be read.
  std::optional<double> tool_length_mm;
  /// Machine coordinates of X Y Z and the two rotaries where the run begins. With it G92 can give a value to an axis
  /// that the program has not moved yet.
  std::optional<kinematics::AxisVector> start;
};

/// Reads a program block by block; memory does not grow with the program (subprograms and loops hold the text).
class ProgramReader {
 public:
  /// `control.family` chooses the dialect. `text` must outlive the reader.
  /// `file_name` is used in messages.
  ProgramReader(std::string_view text, std::string file_name, const kinematics::Machine& machine,
                const kinematics::Control& control, const ReaderOptions& options = {});
  ~ProgramReader();
  ProgramReader(ProgramReader&&) noexcept;

  /// The next motion, nothing at the program's end, or an error (bad_input): program-syntax, program-unknown-word,
  /// program-unknown-code, program-no-feed, program-arc, program-ended-early ... each naming file, line and column.
  Result<std::optional<MotionBlock>> next();

  /// What was seen so far that a person should know (options ignored on purpose: coolant, comments are not listed).
  [[nodiscard]] const std::vector<std::string>& warnings() const;
  [[nodiscard]] std::int64_t lines_read() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace volute::sim
