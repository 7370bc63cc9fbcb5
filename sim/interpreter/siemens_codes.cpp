// What the codes and names of Siemens programs mean.
#include <algorithm>
#include <cmath>

#include "geometry/number_text.hpp"
#include "sim/interpreter/siemens_program.hpp"

namespace volute::sim {

namespace {
bool in(int number, std::initializer_list<int> list) {
  return std::find(list.begin(), list.end(), number) != list.end();
}
}  // namespace

bool SiemensProgram::g_code(double value, std::size_t column) {
  if (value != std::floor(value) || value < 0.0 || value > 9999.0)
    return fault(column, "program-unknown-code", "G takes a whole number here");
  const auto move = [&](Motion motion) {
    if (words_.motion_named) return fault(column, "program-syntax", "two motion codes in one block");
    mode_ = motion;
    words_.motion_named = true;
    words_.motion_column = column;
    return true;
  };
  const int number = static_cast<int>(value);
  switch (number) {
    case 0:
      return move(Motion::rapid);
    case 1:
      return move(Motion::line);
    case 2:
      return move(Motion::clockwise);
    case 3:
      return move(Motion::counter_clockwise);
    case 4:
      return words_.dwell = true;
    case 9:
      return words_.exact_stop = true;
    case 53:
    case 153:
      return words_.machine = true;
    case 90:
      state_.incremental = false;
      return true;
    case 91:
      state_.incremental = true;
      return true;
    case 93:
      state_.set_feed_mode(FeedMode::inverse_time);
      return true;
    case 94:
      state_.set_feed_mode(FeedMode::per_minute);
      return true;
    case 95:
      state_.set_feed_mode(FeedMode::per_revolution);
      return true;
    default:
      return mode_code(number, column);
  }
}

bool SiemensProgram::mode_code(int number, std::size_t column) {
  MotionBlock& standing = state_.standing;
  const auto inch = [&](bool inches, bool feed) {
    if (inches && !feed)
      reading_.diagnosis.warn_once("G70", "under G70 F stays in mm/min; G700 would make it inch/min");
    state_.inches = inches;
    feed_in_inches_ = feed;
    return true;
  };
  if (number >= 17 && number <= 19) {
    state_.plane = number == 17 ? Plane::xy : number == 18 ? Plane::zx : Plane::yz;
    return true;
  }
  if (number == 70 || number == 700) return inch(true, number == 700);
  if (number == 71 || number == 710) return inch(false, false);
  if (number == 60) return standing.path_mode = PathMode::exact_stop, true;
  if (number == 64 || (number >= 641 && number <= 645)) return standing.path_mode = PathMode::continuous, true;
  if (in(number, {40, 62, 97, 450, 451, 601, 602, 603, 290})) return true;
  if ((number >= 54 && number <= 57) || number == 500 || (number >= 505 && number <= 599)) {
    if (number != 54)
      reading_.diagnosis.warn_once(
          "work offset " + std::to_string(number),
          "G" + std::to_string(number) +
              ": no table of work offsets is known; its zero is taken to be the setup's program zero");
    return true;
  }
  if (number == 41 || number == 42)
    return fault(
        column, "program-unknown-code",
        "G" + std::to_string(number) + ": cutter radius compensation is not read: let the CAM system compensate");
  return fault(column, "program-unknown-code",
               "G" + std::to_string(number) +
                   ": this G code is not known to the simulator's Siemens dialect; take it out, or choose the profile "
                   "that the program was written for");
}

bool SiemensProgram::m_code(double value, std::size_t column) {
  if (value != std::floor(value) || value < 0.0 || value > 9999.0)
    return fault(column, "program-unknown-code", "M takes a whole number");
  const int number = static_cast<int>(value);
  MotionBlock& standing = state_.standing;
  switch (number) {
    case 3:
    case 4:
      standing.spindle_on = true;
      standing.spindle_reversed = number == 4;
      return true;
    case 6:
      if (standing.tcp)
        return fault(column, "program-tool-change", "the tool is changed while TRAORI is on; write TRAFOOF first");
      standing.tool_number = tool_prepared_;
      state_.set_tool_length(true);
      reading_.queue.push_back(state_.stop());
      return true;
    case 0:
    case 2:
    case 5:
    case 17:
    case 30:
      words_.m_after.push_back(number);
      return true;
    default:
      break;
  }
  if (in(number, {1, 7, 8, 9, 19}) || (number >= 40 && number <= 45)) return true;
  return fault(column, "program-unknown-code",
               "M" + std::to_string(number) +
                   ": this M code is not known to the simulator's Siemens dialect; take it out, or choose the profile "
                   "that the program was written for");
}

bool SiemensProgram::tool_number(double number, std::size_t column) {
  if (number < 0.0 || number > 1e8 || number != std::floor(number))
    return fault(column, "program-word-range", "T takes a whole number from 0 to 99999999");
  tool_prepared_ = static_cast<int>(number);
  return true;
}

bool SiemensProgram::transformation(bool on, std::size_t column) {
  if (on && !reading_.control.tcp)
    return fault(column, "program-no-tcp", "TRAORI: this control has no TCP; choose a profile whose control has it");
  state_.set_tcp(on);
  return true;
}

bool SiemensProgram::keyword(const std::string& name, std::size_t column) {
  using kinematics::OrientationInterpolation;
  const auto is = [&](std::initializer_list<std::string_view> list) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  if (name == "TRAORI" || name == "TRAFOOF") return transformation(name == "TRAORI", column);
  if (name == "SUPA") return words_.machine = true;
  if (name == "ORIAXES") return state_.standing.orientation_interpolation = OrientationInterpolation::axes, true;
  if (is({"ORIVECT", "ORIPLANE"}))
    return state_.standing.orientation_interpolation = OrientationInterpolation::great_circle, true;
  if (name == "ORIMKS") return unknown(column, name, "orientation in machine coordinates is not read; write ORIWKS");
  // Words that change how, not where, the axes go: the virtual control has its own dynamics and smoothing.
  if (is({"FFWON", "FFWOF", "SOFT", "BRISK", "DRIVE", "DYNNORM", "DYNPOS", "DYNROUGH", "DYNSEMIFIN", "DYNFINISH",
          "DYNPREC", "COMPON", "COMPCURV", "COMPCAD", "COMPSURF", "COMPOF", "ORISON", "ORISOF"})) {
    reading_.diagnosis.warn_once(name,
                                 name + ": the virtual control keeps the dynamics and smoothing of its control file");
    return true;
  }
  if (is({"ORIWKS", "RTLION", "RTLIOF", "CFC", "CFIN", "CFTCP", "NORM", "KONT", "STOPRE", "DIAMOF", "MCALL", "UPATH",
          "SPATH"}))
    return true;
  if (is({"TRANS", "ATRANS"})) {
    words_.frame = true;
    words_.frame_adds = name == "ATRANS";
    return true;
  }
  if (is({"ROT", "AROT", "SCALE", "ASCALE", "MIRROR", "AMIRROR"})) {
    for (const SiemensAxisWord& axis : words_.axes)
      if (axis.given) return unknown(axis.column, name, "turned, scaled and mirrored frames are not read");
    words_.frame = true;
    words_.column = column;
    return true;
  }
  if (name == "RET") return words_.m_after.push_back(17), true;
  if (is({"IF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "FOR", "ENDFOR", "LOOP", "ENDLOOP", "REPEAT", "UNTIL", "GOTO",
          "GOTOF", "GOTOB", "GOTOS", "PROC", "DEF", "EXTERN", "CALL"}))
    return unknown(column, name, "jumps, loops, definitions and subprograms are not read; post the motions themselves");
  return unknown(column, name,
                 "this word is not known to the simulator's Siemens dialect; take it out, or choose the profile that "
                 "the program was written for");
}

}  // namespace volute::sim
