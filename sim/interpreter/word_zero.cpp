// Where the zero of the words stands: work offsets, G92, G52, G10, and the tool's offset of G43.1.
#include <cmath>

#include "geometry/number_text.hpp"
#include "sim/interpreter/word_program.hpp"

namespace volute::sim {

void WordProgram::update_shift() {
  static const Shift none;
  const Shift& work =
      work_system_ < static_cast<int>(work_.size()) ? work_[static_cast<std::size_t>(work_system_)] : none;
  state_.shift.linear_mm = work.linear_mm + position_shift_.linear_mm + tool_offset_mm_;
  for (std::size_t i = 0; i < 2; ++i) state_.shift.rotary_rad[i] = work.rotary_rad[i] + position_shift_.rotary_rad[i];
}

/// Where an axis (0 to 4) stands for a code that gives this place a value; nothing: a fault.
std::optional<double> WordProgram::stands_at(int axis, const char* code) {
  const auto told = axis < 3 ? state_.linear_mm(axis) : state_.rotary_rad(axis - 3);
  if (told) return told;
  const std::string letter(1, axis < 3 ? "XYZ"[axis] : state_.rotary_letter(axis - 3));
  const auto start = state_.start_of(axis);
  if (!start) {
    fault(plan_.column, "program-position-unknown",
          std::string(code) + " gives the present position a value, but where " + letter +
              " stands is not known here; move it to a position first");
    return std::nullopt;
  }
  reading_.diagnosis.warn_once("start of " + letter,
                               std::string(code) + " gives " + letter +
                                   " a value before the program has moved it: it is taken to stand at the machine's "
                                   "zero, where the run begins");
  return start;
}

bool WordProgram::shift_position() {
  const bool local = plan_.one_shot == OneShot::local_shift;
  MoveWords words;
  axis_words(words);
  if (!words.any()) return fault(plan_.column, "program-syntax", "G92 and G52 need at least one axis word");
  for (int axis = 0; axis < 5; ++axis) {
    const bool linear = axis < 3;
    const auto i = static_cast<std::size_t>(linear ? axis : axis - 3);
    if ((((linear ? words.linear : words.rotary) >> i) & 1U) == 0) continue;
    const double word = linear ? words.linear_mm[i] : words.rotary_rad[i];
    double& shift = linear ? position_shift_.linear_mm[axis] : position_shift_.rotary_rad[i];
    if (local) {
      shift = word;
      continue;
    }
    const auto now = stands_at(axis, "G92");
    if (!now) return false;
    shift += *now - (linear ? state_.shift.linear_mm[axis] : state_.shift.rotary_rad[i]) - word;
  }
  saved_shift_ = position_shift_;
  update_shift();
  return true;
}

bool WordProgram::refuse_tcp_with_offset(std::size_t column) {
  if (tool_offset_mm_.isZero(1e-9)) return true;
  return fault(
      column, "program-tool-offset",
      "G43.1 gives the tool another length or place than the job's tool, and under TCP the axes would turn about "
      "that other point; give the tool of the program (--tool-length, or the job's tool), or write G43");
}

// [LinuxCNC] G43.1: the axes that are named take the word as the tool's offset, the others keep theirs; nothing moves.
// The words of later blocks name a point that is so far from the gauge line; our positions are those of the real tip.
bool WordProgram::tool_offset() {
  const auto& length = reading_.options.tool_length_mm;
  if (!length)
    return fault(plan_.column, "program-tool-offset",
                 "G43.1 names a tool length, and the tool is not known here; use G43");
  MoveWords words;
  axis_words(words);
  if (plan_.motion_named)
    return fault(plan_.motion_column, "program-syntax", "G43.1 uses the axis words of its block; move in the next one");
  if (words.linear == 0 || words.rotary != 0)
    return fault(plan_.column, "program-syntax", "G43.1 needs X, Y or Z, the tool's offset, and no rotary axis");
  // Without a length in force the control's offset is 0: the tool stands out by all of its length.
  Vec3 given = tool_offset_mm_;
  if (state_.standing.tool_length_active) given.z() += *length;
  for (int axis = 0; axis < 3; ++axis)
    if (((words.linear >> axis) & 1U) != 0) given[axis] = words.linear_mm[static_cast<std::size_t>(axis)];
  tool_offset_mm_ = given - *length * Vec3::UnitZ();
  if (state_.standing.tcp && !refuse_tcp_with_offset(plan_.column)) return false;
  if (!tool_offset_mm_.isZero(1e-9))
    reading_.diagnosis.warn_once(
        "tool offset", "G43.1 gives the tool the offset X" + geometry::short_text(given.x()) + " Y" +
                           geometry::short_text(given.y()) + " Z" + geometry::short_text(given.z()) +
                           " mm, the job's tool is " + geometry::short_text(*length) +
                           " mm long: its tip runs beside the programmed point by the difference, as it would on the "
                           "machine; if the program's tool is another, give it (--tool-length)");
  update_shift();
  state_.set_tool_length(true);
  return true;
}

bool WordProgram::set_data() {
  const auto refuse = [&](const std::string& text) { return fault(plan_.column, "program-set-data", text); };
  if (!linuxcnc_) return refuse("G10 writes the control's own tables, which the setup gives here; take it out");
  if (!block_.use('L') || !block_.use('P')) return refuse("G10 needs L and P");
  const double kind = block_.value('L'), system = block_.value('P');
  if (kind != 2.0 && kind != 20.0)
    return refuse("G10 L" + geometry::short_text(kind) + " writes the tool table, which the job gives here");
  if (system != std::floor(system) || system < 0.0 || system > 9.0)
    return refuse("P of G10 is a whole number from 0 to 9");
  if (kind == 2.0 && !reading_.options.work_zero_machine_mm)
    return refuse(
        "G10 L2 gives a work offset in machine coordinates; say where the setup stands on the machine, or take it out");
  const auto which = static_cast<std::size_t>(system == 0.0 ? work_system_ : static_cast<int>(system));
  MoveWords words;
  axis_words(words);
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (((words.linear >> i) & 1U) == 0) continue;
    if (kind == 2.0) {
      work_[which].linear_mm[axis] = words.linear_mm[i] - (*reading_.options.work_zero_machine_mm)[axis];
      continue;
    }
    const auto now = stands_at(axis, "G10 L20");
    if (!now) return false;
    work_[which].linear_mm[axis] = *now - position_shift_.linear_mm[axis] - tool_offset_mm_[axis] - words.linear_mm[i];
  }
  for (int axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (((words.rotary >> i) & 1U) == 0) continue;
    if (kind == 2.0) {
      work_[which].rotary_rad[i] = words.rotary_rad[i];
      continue;
    }
    const auto now = stands_at(3 + axis, "G10 L20");
    if (!now) return false;
    work_[which].rotary_rad[i] = *now - position_shift_.rotary_rad[i] - words.rotary_rad[i];
  }
  update_shift();
  return true;
}

}  // namespace volute::sim
