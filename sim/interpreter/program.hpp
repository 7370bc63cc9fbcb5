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

namespace volute::sim {

using geometry::Result;
using geometry::Vec3;

enum class MotionKind : std::uint8_t { rapid, line, arc, dwell, stop };
enum class FeedMode : std::uint8_t { per_minute, inverse_time, per_revolution };
enum class PathMode : std::uint8_t { exact_path, exact_stop, continuous };

/// One motion as the text says it: units mm, rad, s; modal words resolved; offsets applied to program coordinates.
struct MotionBlock {
  MotionKind kind = MotionKind::line;
  std::int64_t line = 0;              ///< 1-based line of the text
  bool tcp = false;                   ///< xyz is the tool tip in the work frame; else linear axis words (machine: + program zero)
  bool machine_coordinates = false;   ///< G53, SUPA, M91: xyz and rotaries are machine coordinates
  Vec3 xyz_mm = Vec3::Zero();         ///< end point
  std::array<bool, 3> xyz_programmed{};  ///< which of X Y Z the block itself names (machine-coordinate moves need it)
  std::array<double, 2> rotary_rad{}; ///< end positions of axes[3], axes[4] (when !axis_vector)
  std::array<bool, 2> rotary_programmed{};
  bool rotary_shortest = false;       ///< modulo one turn, the short way
  std::optional<Vec3> axis_vector;    ///< unit tool axis at the end, in the work frame
  // arc: centre and turns in program coordinates
  Vec3 centre_mm = Vec3::Zero();
  Vec3 plane_normal = Vec3::UnitZ();
  double sweep_rad = 0.0;             ///< signed about plane_normal, |sweep| may exceed one turn
  FeedMode feed_mode = FeedMode::per_minute;
  double feed = 0.0;                  ///< mm/s (or rad/s for rotary-only); inverse_time: 1/s; per_revolution: mm
  PathMode path_mode = PathMode::continuous;
  double path_tolerance_mm = -1.0;    ///< < 0: none given in the program
  double rotary_tolerance_rad = -1.0;
  double naive_cam_tolerance_mm = -1.0;
  double dwell_s = 0.0;
  bool spindle_on = false;
  double spindle_rad_s = 0.0;
  int tool_number = 0;
  bool tool_length_active = false;    ///< G43, G43.4, TRAORI with D, TOOL CALL
};

/// Reads a program block by block; memory does not grow with the program (subprograms and loops hold the text).
class ProgramReader {
 public:
  /// `control.family` chooses the dialect. `text` must outlive the reader.
  /// `file_name` is used in messages.
  ProgramReader(std::string_view text, std::string file_name, const kinematics::Machine& machine, const kinematics::Control& control);
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
