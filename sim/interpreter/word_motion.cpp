// Where the axis words of a block lead.
#include <cmath>
#include <numbers>

#include "geometry/number_text.hpp"
#include "sim/interpreter/arithmetic.hpp"
#include "sim/interpreter/word_program.hpp"

namespace volute::sim {

namespace {
constexpr std::uint32_t bits(std::string_view letters) {
  std::uint32_t out = 0;
  for (const char c : letters) out |= 1U << (c - 'A');
  return out;
}
}  // namespace

bool WordProgram::decimal_point(char letter) {
  if (linuxcnc_ || block_.has_point(letter) || block_.value(letter) == 0.0) return true;
  reading_.diagnosis.warn_once("decimal point",
                               std::string("the word ") + letter + geometry::short_text(block_.value(letter)) +
                                   " has no decimal point: read as whole units; a control set to least "
                                   "increments moves a thousandth of it");
  return true;
}

bool WordProgram::axis_words(MoveWords& out) {
  for (unsigned i = 0; i < 3; ++i) {
    const char letter = "XYZ"[i];
    if (!block_.has(letter)) continue;
    block_.use(letter);
    decimal_point(letter);
    out.linear_mm[i] = block_.value(letter) * state_.unit_mm();
    out.linear |= 1U << i;
  }
  for (unsigned i = 0; i < 2; ++i) {
    const char letter = state_.rotary_letter(static_cast<int>(i));
    if (!block_.has(letter)) continue;
    block_.use(letter);
    decimal_point(letter);
    out.rotary_rad[i] = block_.value(letter) * rad_per_deg;
    out.rotary |= 1U << i;
  }
  if (state_.incremental) {
    out.linear_incremental = out.linear;
    out.rotary_incremental = out.rotary;
  }
  return true;
}

bool WordProgram::tool_axis(MoveWords& out) {
  if (!vector_words_ || (block_.present & bits("IJK")) == 0) return true;
  const std::size_t column = block_.column(block_.has('I') ? 'I' : block_.has('J') ? 'J' : 'K');
  // [F-15i]: of I J K the ones that are missing are 0.
  const auto part = [&](char letter) { return block_.use(letter) ? block_.value(letter) : 0.0; };
  const Vec3 axis(part('I'), part('J'), part('K'));
  if (!(axis.norm() > 1e-9)) return fault(column, "program-vector", "the tool axis I J K has no length");
  if (out.rotary != 0)
    return fault(column, "program-vector", "the tool axis is given by I J K and by a rotary axis in the same block");
  out.axis_vector = axis.normalized();
  return true;
}

bool WordProgram::emit(bool ok, MotionBlock& block) {
  if (!ok) return false;
  if (plan_.exact_stop) block.path_mode = PathMode::exact_stop;
  reading_.queue.push_back(block);
  return true;
}

bool WordProgram::motion() {
  const bool machine = plan_.one_shot == OneShot::machine_coordinates;
  switch (mode_) {
    case MotionMode::rapid:
      return straight(MotionKind::rapid);
    case MotionMode::line:
      return straight(MotionKind::line);
    case MotionMode::clockwise:
    case MotionMode::counter_clockwise:
      if (machine) return fault(plan_.column, "program-syntax", "G53 needs G0 or G1");
      return arc(mode_ == MotionMode::clockwise);
    case MotionMode::cycle:
      if (machine) return fault(plan_.column, "program-syntax", "G53 needs G0 or G1");
      return drill();
    default:
      break;
  }
  MoveWords words;
  if (machine || ((block_.present & ~block_.used) & bits("XYZABC")) != 0) {
    const std::size_t column = machine ? plan_.column
                                       : block_.column(block_.has('X')   ? 'X'
                                                       : block_.has('Y') ? 'Y'
                                                                         : 'Z');
    axis_words(words);
    if (words.any() || machine)
      return fault(column, "program-no-motion",
                   "axis words without a motion code in force; write G0 or G1 before them");
  }
  return true;
}

bool WordProgram::straight(MotionKind kind) {
  MoveWords words;
  if (!axis_words(words) || !tool_axis(words)) return false;
  const bool machine = plan_.one_shot == OneShot::machine_coordinates;
  if (machine) {
    if (!words.any()) return fault(plan_.column, "program-syntax", "G53 needs the axes that it moves");
    if (state_.incremental)
      return fault(plan_.column, "program-syntax", "G53 gives positions and has no meaning under G91; write G90 first");
    if (linuxcnc_ && state_.standing.tcp)
      return fault(
          plan_.column, "program-machine-tcp",
          "G53 under TCP moves in a frame that depends on the kinematics' own configuration; switch TCP off first");
    words.machine_coordinates = true;
  }
  if (!words.any()) return true;
  const std::size_t column = plan_.motion_named ? plan_.motion_column : 0;
  MotionBlock block;
  return emit(state_.line(kind, words, column, block), block);
}

bool WordProgram::arc(bool clockwise) {
  MoveWords words;
  ArcWords arc;
  axis_words(words);
  arc.clockwise = clockwise;
  arc.column = plan_.motion_named ? plan_.motion_column : 0;
  for (unsigned i = 0; i < 3; ++i) {
    const char letter = "IJK"[i];
    if (!block_.use(letter)) continue;
    decimal_point(letter);
    arc.centre |= 1U << i;
    arc.centre_mm[i] = block_.value(letter) * state_.unit_mm();
    if (arc_centre_absolute_) arc.centre_absolute |= 1U << i;
  }
  if (block_.use('R')) arc.radius_mm = block_.value('R') * state_.unit_mm();
  if (!words.any() && arc.centre == 0 && !arc.radius_mm) {
    if (!plan_.motion_named) return true;
    return fault(arc.column, "program-arc", "an arc needs an end point or a centre");
  }
  if (linuxcnc_ && block_.use('P')) {
    const double turns = block_.value('P');
    if (turns < 1.0 || turns > 1e6 || turns != std::floor(turns))
      return fault(block_.column('P'), "program-arc", "P of an arc is a whole number of turns, at least 1");
    arc.turns = static_cast<int>(turns);
  }
  MotionBlock block;
  return emit(state_.arc(words, arc, block), block);
}

bool WordProgram::run_one_shot() {
  switch (plan_.one_shot) {
    case OneShot::dwell:
      return dwell();
    case OneShot::reference:
      return reference(false);
    case OneShot::second_reference:
      return reference(true);
    case OneShot::clear_shift:
      saved_shift_ = position_shift_ = {};
      update_shift();
      return true;
    case OneShot::suspend_shift:
      position_shift_ = {};
      update_shift();
      return true;
    case OneShot::restore_shift:
      position_shift_ = saved_shift_;
      update_shift();
      return true;
    case OneShot::tool_offset:
      return tool_offset();
    case OneShot::set_data:
      return set_data();
    case OneShot::shift_position:
    case OneShot::local_shift:
      return shift_position();
    default:
      return true;
  }
}

bool WordProgram::dwell() {
  double seconds = 0.0;
  if (block_.use('P')) {
    // LinuxCNC: seconds. Fanuc and its relatives: milliseconds when written without a point.
    const bool milliseconds = !linuxcnc_ && !block_.has_point('P');
    seconds = milliseconds ? block_.value('P') / 1000.0 : block_.value('P');
  } else if (!linuxcnc_ && (block_.has('X') || block_.has('U'))) {
    const char letter = block_.has('X') ? 'X' : 'U';
    block_.use(letter);
    seconds = block_.value(letter);
  } else {
    return fault(plan_.column, "program-syntax", "G4 needs P, how long to wait");
  }
  if (seconds < 0.0) return fault(plan_.column, "program-word-range", "G4 waits a negative time");
  reading_.queue.push_back(state_.dwell(seconds));
  return true;
}

bool WordProgram::reference(bool second) {
  if (second)
    reading_.diagnosis.warn_once("G30", "G30: the second reference point is not known; the machine's zero is taken");
  if (!linuxcnc_ && second) block_.use('P');
  MoveWords by;
  axis_words(by);
  if (!by.any() && family_ == kinematics::DialectFamily::fanuc)
    return fault(plan_.column, "program-syntax", "G28 and G30 need the axes that they move");
  bool stays = true;
  for (unsigned i = 0; i < 3; ++i) stays = stays && ((by.linear >> i) & 1U) * by.linear_mm[i] == 0.0;
  for (unsigned i = 0; i < 2; ++i) stays = stays && ((by.rotary >> i) & 1U) * by.rotary_rad[i] == 0.0;
  MotionBlock block;
  if (by.any() && !(state_.incremental && stays) &&
      !emit(state_.line(MotionKind::rapid, by, plan_.column, block), block))
    return false;
  MoveWords home;
  home.linear = by.any() ? by.linear : 7U;
  home.rotary = by.any() ? by.rotary : 3U;
  home.machine_coordinates = true;
  return emit(state_.line(MotionKind::rapid, home, plan_.column, block), block);
}

}  // namespace volute::sim
