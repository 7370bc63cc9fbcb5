// What a program has said so far that still holds, and where its words put the axes: shared by every dialect.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/machine.hpp"
#include "sim/interpreter/program.hpp"
#include "sim/interpreter/source.hpp"

namespace volute::sim {

enum class Plane : std::uint8_t { xy, zx, yz };

/// The axis words of one block, units resolved (mm, rad); masks have one bit per axis.
struct MoveWords {
  std::array<double, 3> linear_mm{};
  std::array<double, 2> rotary_rad{};
  unsigned linear = 0, linear_incremental = 0;
  unsigned rotary = 0, rotary_incremental = 0;
  bool machine_coordinates = false;
  bool rotary_shortest = false;
  std::optional<Vec3> axis_vector;

  [[nodiscard]] bool any() const { return linear != 0 || rotary != 0 || axis_vector.has_value(); }
};

/// An arc as its words say it; offsets and radius in mm.
struct ArcWords {
  bool clockwise = false;
  std::array<double, 3> centre_mm{};
  unsigned centre = 0;           ///< which of I J K are given
  unsigned centre_absolute = 0;  ///< which of them are positions instead of distances from the start
  std::optional<double> radius_mm;
  std::optional<double> opening_rad;  ///< Siemens AR: the angle that the arc sweeps
  int turns = 1;                      ///< LinuxCNC P: passes through the end point; Siemens TURN + 1
  std::size_t column = 0;             ///< of the word that a fault should point to
};

/// The zero of the program's coordinates relative to the setup's program zero: setup = program + shift.
struct Shift {
  Vec3 linear_mm = Vec3::Zero();
  std::array<double, 2> rotary_rad{};
};

/// Modal words and positions. Positions are in the setup's program coordinates.
class MotionState {
 public:
  MotionState(const kinematics::Machine& machine, const kinematics::Control& control, Diagnosis& diagnosis);

  // modal words
  bool inches = false;
  bool incremental = false;
  Plane plane = Plane::xy;
  double feed_number = 0.0;   ///< as written: mm/min, inch/min, 1/min, mm/rev ...
  double feed_unit_mm = 1.0;  ///< 25.4 when written under inches
  /// Spindle, tool, path mode, TCP, feed mode: what every motion carries along.
  MotionBlock standing;
  Shift shift;
  std::optional<Vec3> work_zero_machine_mm;  ///< as in ReaderOptions

  [[nodiscard]] double unit_mm() const { return inches ? 25.4 : 1.0; }
  void set_feed_mode(FeedMode mode);
  void set_tcp(bool on);
  void set_tool_length(bool active);
  /// The axes stand here (machine coordinates) before the first block; of use while the text says nothing of an axis.
  void begin_at(const kinematics::AxisVector& machine);
  /// Forgets where the linear axes stand in the program's coordinates.
  void forget_linear();
  void forget_rotary();

  /// A rapid or a line. False: a fault (no feed, axis that is unknown ...).
  bool line(MotionKind kind, const MoveWords& words, std::size_t column, MotionBlock& out);
  bool arc(const MoveWords& words, const ArcWords& arc, MotionBlock& out);
  MotionBlock dwell(double seconds);
  MotionBlock stop();

  /// Where the axes stand in the setup's program coordinates, when the text tells.
  [[nodiscard]] std::optional<double> linear_mm(int axis) const;
  [[nodiscard]] std::optional<double> rotary_rad(int axis) const;
  /// Where an axis (0 to 4, setup's program coordinates) stands that no block has moved: nothing when one has, when the
  /// coordinates have changed since, or when the start is not known.
  [[nodiscard]] std::optional<double> start_of(int axis) const { return start_[static_cast<std::size_t>(axis)]; }
  /// linear_mm and rotary_rad in the program's own coordinates.
  [[nodiscard]] std::optional<double> program_linear_mm(int axis) const;
  [[nodiscard]] std::optional<double> program_rotary_rad(int axis) const;
  /// True when the way to `target_rad` (program coordinates) is at most half a turn from wherever the axis may stand:
  /// from its known position, or from anywhere in its travel. Then the short way is the plain way.
  [[nodiscard]] bool plain_way_is_short(int axis, double target_rad) const;
  [[nodiscard]] int rotary_of(char letter) const;  ///< 0 or 1; -1: the machine has none of that letter
  [[nodiscard]] char rotary_letter(int rotary) const;

 private:
  [[nodiscard]] MotionBlock begin(MotionKind kind) const;
  /// True when the words move a linear axis, or may.
  bool place_linear(const MoveWords& words, MotionBlock& out);
  void place_machine(const MoveWords& words, MotionBlock& out);
  void place_rotary(const MoveWords& words, MotionBlock& out);
  /// Refuses an end that no machine can reach.
  bool in_reach(std::size_t column, const MotionBlock& out);
  bool place_feed(std::size_t column, MotionBlock& out);
  bool arc_geometry(const ArcWords& arc, const Vec3& start, MotionBlock& out);

  Diagnosis& diagnosis_;
  std::array<char, 2> rotary_letters_{};
  std::array<std::optional<double>, 2> travel_min_rad_, travel_max_rad_;
  bool shortest_way_ = false;
  Vec3 position_mm_ = Vec3::Zero();
  std::array<bool, 3> known_{};
  std::array<double, 2> rotary_{};
  std::array<bool, 2> rotary_known_{};
  std::array<std::optional<double>, 5> start_;  ///< as start_of
};

}  // namespace volute::sim
