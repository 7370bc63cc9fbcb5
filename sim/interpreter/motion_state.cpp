#include "sim/interpreter/motion_state.hpp"

#include <cmath>
#include <numbers>

#include "geometry/number_text.hpp"
#include "sim/interpreter/arithmetic.hpp"

namespace volute::sim {

namespace {
constexpr double seconds_per_minute = 60.0;
/// Words that differ by less name the same position: far below the last digit of any control (1e-6 mm).
constexpr double same_position_mm = 1e-9;

/// No word may lead farther: a kilometre, or 10,000 turns.
constexpr double farthest_mm = 1e6, farthest_rad = 2e4 * std::numbers::pi;

bool has(unsigned mask, std::size_t bit) { return ((mask >> bit) & 1U) != 0; }
}  // namespace

MotionState::MotionState(const kinematics::Machine& machine, const kinematics::Control& control, Diagnosis& diagnosis)
    : diagnosis_(diagnosis), shortest_way_(control.rotary_shortest_way) {
  for (std::size_t i = 0; i < 2; ++i) {
    const kinematics::Axis& axis = machine.axes[3 + i];
    rotary_letters_[i] = axis.letter;
    travel_min_rad_[i] = axis.travel_min;
    travel_max_rad_[i] = axis.travel_max;
  }
}

void MotionState::begin_at(const kinematics::AxisVector& machine) {
  for (std::size_t i = 0; i < start_.size(); ++i) start_[i] = machine[static_cast<Eigen::Index>(i)];
  for (std::size_t i = 0; i < 3; ++i)
    start_[i] = work_zero_machine_mm ? std::optional(*start_[i] - (*work_zero_machine_mm)[static_cast<Eigen::Index>(i)])
                                     : std::nullopt;
}

void MotionState::forget_linear() {
  known_ = {};
  for (std::size_t i = 0; i < 3; ++i) start_[i].reset();
}

void MotionState::forget_rotary() {
  rotary_known_ = {};
  start_[3].reset();
  start_[4].reset();
}

bool MotionState::plain_way_is_short(int axis, double target_rad) const {
  const auto i = static_cast<std::size_t>(axis);
  const double target = target_rad + shift.rotary_rad[i];
  const auto near = [target](double from) { return std::abs(target - from) < std::numbers::pi - 1e-9; };
  if (rotary_known_[i]) return near(rotary_[i]);
  return travel_min_rad_[i] && travel_max_rad_[i] && near(*travel_min_rad_[i]) && near(*travel_max_rad_[i]);
}

int MotionState::rotary_of(char letter) const {
  if (letter == rotary_letters_[0]) return 0;
  return letter == rotary_letters_[1] ? 1 : -1;
}

char MotionState::rotary_letter(int rotary) const { return rotary_letters_[static_cast<std::size_t>(rotary)]; }

void MotionState::set_feed_mode(FeedMode mode) {
  // Every control wants a new F after the meaning of F has changed.
  if (mode != standing.feed_mode) feed_number = 0.0;
  standing.feed_mode = mode;
}

void MotionState::set_tcp(bool on) {
  // The same axes have other coordinates now; words that follow start from where the machine really stands.
  if (standing.tcp != on) forget_linear();
  standing.tcp = on;
}

void MotionState::set_tool_length(bool active) {
  if (standing.tool_length_active != active) forget_linear();
  standing.tool_length_active = active;
}

std::optional<double> MotionState::linear_mm(int axis) const {
  const auto i = static_cast<std::size_t>(axis);
  return known_[i] ? std::optional<double>(position_mm_[axis]) : std::nullopt;
}

std::optional<double> MotionState::rotary_rad(int axis) const {
  const auto i = static_cast<std::size_t>(axis);
  return rotary_known_[i] ? std::optional<double>(rotary_[i]) : std::nullopt;
}

std::optional<double> MotionState::program_linear_mm(int axis) const {
  const auto setup = linear_mm(axis);
  return setup ? std::optional<double>(*setup - shift.linear_mm[axis]) : std::nullopt;
}

std::optional<double> MotionState::program_rotary_rad(int axis) const {
  const auto setup = rotary_rad(axis);
  return setup ? std::optional<double>(*setup - shift.rotary_rad[static_cast<std::size_t>(axis)]) : std::nullopt;
}

MotionBlock MotionState::begin(MotionKind kind) const {
  MotionBlock out = standing;
  out.kind = kind;
  return out;
}

void MotionState::place_machine(const MoveWords& words, MotionBlock& out) {
  for (std::size_t i = 0; i < 3; ++i) {
    out.xyz_programmed[i] = has(words.linear, i);
    if (!out.xyz_programmed[i]) continue;
    start_[i].reset();
    out.xyz_mm[static_cast<Eigen::Index>(i)] = words.linear_mm[i];
    out.xyz_known[i] = true;
    known_[i] = work_zero_machine_mm && !standing.tool_length_active;
    if (known_[i])
      position_mm_[static_cast<Eigen::Index>(i)] =
          words.linear_mm[i] - (*work_zero_machine_mm)[static_cast<Eigen::Index>(i)];
  }
  if (standing.tcp) forget_linear();
}

bool MotionState::place_linear(const MoveWords& words, MotionBlock& out) {
  bool moves = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (has(words.linear, i)) {
      out.xyz_programmed[i] = true;
      start_[i].reset();
      const double value = words.linear_mm[i];
      if (!has(words.linear_incremental, i)) {
        const double target = value + shift.linear_mm[axis];
        moves = moves || !known_[i] || std::abs(target - position_mm_[axis]) > same_position_mm;
        position_mm_[axis] = target;
        known_[i] = true;
      } else {
        moves = moves || std::abs(value) > same_position_mm;
        position_mm_[axis] += value;
        out.xyz_relative[i] = !known_[i];
      }
      out.xyz_mm[axis] = out.xyz_relative[i] ? value : position_mm_[axis];
    } else {
      out.xyz_mm[axis] = position_mm_[axis];
    }
    out.xyz_known[i] = known_[i];
  }
  return moves;
}

void MotionState::place_rotary(const MoveWords& words, MotionBlock& out) {
  if (words.axis_vector) {
    out.axis_vector = words.axis_vector;
    forget_rotary();
    return;
  }
  const bool shortest = (shortest_way_ || words.rotary_shortest) && !words.machine_coordinates;
  for (std::size_t i = 0; i < 2; ++i) {
    if (has(words.rotary, i)) {
      out.rotary_programmed[i] = true;
      start_[3 + i].reset();
      if (!has(words.rotary_incremental, i)) {
        // By the short way the turn that is reached depends on where the axis stood.
        const bool turn_known = !shortest || plain_way_is_short(static_cast<int>(i), words.rotary_rad[i]);
        rotary_[i] = words.rotary_rad[i] + (words.machine_coordinates ? 0.0 : shift.rotary_rad[i]);
        out.rotary_rad[i] = rotary_[i];
        out.rotary_known[i] = true;
        rotary_known_[i] = turn_known;
        out.rotary_shortest = shortest;
        continue;
      }
      rotary_[i] += words.rotary_rad[i];
      out.rotary_relative[i] = !rotary_known_[i];
      out.rotary_rad[i] = out.rotary_relative[i] ? words.rotary_rad[i] : rotary_[i];
    } else {
      out.rotary_rad[i] = rotary_[i];
    }
    out.rotary_known[i] = rotary_known_[i];
  }
}

bool MotionState::in_reach(std::size_t column, const MotionBlock& out) {
  const auto too_far = [&](char letter, double value, const char* unit) {
    return diagnosis_.fault(
        column, "program-word-range",
        std::string(1, letter) + " leads to " + geometry::short_text(value) + unit +
            ", farther than any machine goes; correct the word, or the unit (G20, G21) it stands in");
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = out.xyz_mm[static_cast<Eigen::Index>(i)];
    if (out.xyz_programmed[i] && !(std::abs(value) <= farthest_mm)) return too_far("XYZ"[i], value, " mm");
  }
  for (std::size_t i = 0; i < 2; ++i)
    if (out.rotary_programmed[i] && !(std::abs(out.rotary_rad[i]) <= farthest_rad))
      return too_far(rotary_letters_[i], out.rotary_rad[i] / rad_per_deg, " deg");
  return true;
}

bool MotionState::place_feed(std::size_t column, MotionBlock& out) {
  if (out.kind == MotionKind::rapid) return true;
  if (feed_number <= 0.0)
    return diagnosis_.fault(
        column, "program-no-feed",
        out.feed_mode == FeedMode::inverse_time
            ? "a feed motion under inverse time (G93) needs its own F; write F = 1/minutes in this block"
            : "a feed motion while the feed is 0; write F in this block or before it");
  switch (out.feed_mode) {
    case FeedMode::per_minute:
      out.feed = feed_number / seconds_per_minute * (out.rotary_only ? rad_per_deg : feed_unit_mm);
      break;
    case FeedMode::inverse_time:
      out.feed = feed_number / seconds_per_minute;
      break;
    case FeedMode::per_revolution:
      out.feed = feed_number * feed_unit_mm;
      break;
  }
  return true;
}

bool MotionState::line(MotionKind kind, const MoveWords& words, std::size_t column, MotionBlock& out) {
  out = begin(kind);
  bool moves_linear = words.linear != 0;
  if (words.machine_coordinates) {
    out.machine_coordinates = true;
    out.tcp = false;
    place_machine(words, out);
  } else {
    moves_linear = place_linear(words, out);
  }
  place_rotary(words, out);
  out.rotary_only = !moves_linear && (words.rotary != 0 || words.axis_vector);
  return in_reach(column, out) && place_feed(column, out);
}

bool MotionState::arc(const MoveWords& words, const ArcWords& arc, MotionBlock& out) {
  out = begin(MotionKind::arc);
  const Vec3 start = position_mm_;
  const int normal = plane == Plane::xy ? 2 : plane == Plane::zx ? 1 : 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != normal && !known_[static_cast<std::size_t>(axis)])
      return diagnosis_.fault(
          arc.column, "program-position-unknown",
          std::string("an arc needs to know where it starts, and the program has not said it for ") + "XYZ"[axis] +
              "; move that axis to a position first");
  }
  place_linear(words, out);
  place_rotary(words, out);
  return in_reach(arc.column, out) && arc_geometry(arc, start, out) && place_feed(arc.column, out);
}

MotionBlock MotionState::dwell(double seconds) {
  MotionBlock out = stop();
  out.kind = MotionKind::dwell;
  out.dwell_s = seconds;
  return out;
}

MotionBlock MotionState::stop() {
  MotionBlock out = begin(MotionKind::stop);
  place_linear({}, out);
  place_rotary({}, out);
  return out;
}

}  // namespace volute::sim
