// Heidenhain's functions, cycles, labels and Q parameters.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/number_text.hpp"
#include "sim/interpreter/arithmetic.hpp"
#include "sim/interpreter/heidenhain_program.hpp"

namespace volute::sim {

namespace {
constexpr std::size_t heidenhain_calls_most = 20;
constexpr std::int64_t heidenhain_jumps_most = 1'000'000;
}  // namespace

bool HeidenhainProgram::set_tcp(bool on, std::size_t column) {
  if (on && !reading_.control.tcp)
    return fault(column, "program-no-tcp",
                 "the program switches TCP on, but this control has none; choose a profile whose control has it");
  if (!on) state_.standing.orientation_interpolation.reset();
  state_.set_tcp(on);
  return true;
}

bool HeidenhainProgram::function() {
  const std::size_t column = at_;
  if (accept("RESET"))
    return (accept("TCPM") || unknown(at_, "FUNCTION RESET", "only TCPM is known")) && set_tcp(false, column) &&
           expect_end();
  if (accept("TCPM")) return tcpm();
  if (accept("MODE")) return accept("MILL") ? expect_end() : unknown(at_, "FUNCTION MODE", "only MILL is known");
  return unknown(column, "FUNCTION", "only TCPM and MODE MILL are known");
}

bool HeidenhainProgram::tcpm() {
  using kinematics::OrientationInterpolation;
  const std::size_t start = at_;
  while (!at_end()) {
    const std::size_t column = at_;
    if (accept("F")) {
      if (accept("TCP")) continue;
      if (accept("CONT")) return unknown(column, "F CONT", "feed along the axes' contour is not read; write F TCP");
      double limit = 0.0;
      if (!number(limit)) return false;
      reading_.diagnosis.warn_once(
          "TCPM F", "F with TCPM limits the compensating moves; the virtual control keeps its axis limits instead");
    } else if (accept("AXIS")) {
      if (accept("POS")) continue;
      return unknown(column, "AXIS", "only AXIS POS is read: the rotary words are axis positions");
    } else if (accept("PATHCTRL")) {
      const bool vector = accept("VECTOR");
      if (!vector && !accept("AXIS")) return unknown(column, "PATHCTRL", "AXIS or VECTOR belongs here");
      state_.standing.orientation_interpolation =
          vector ? OrientationInterpolation::great_circle : OrientationInterpolation::axes;
    } else if (accept("REFPNT")) {
      if (accept("TIP-TIP")) continue;
      return unknown(column, "REFPNT", "only TIP-TIP is read: X Y Z are those of the tool tip");
    } else {
      return unknown(column, in_quotes(line_.substr(column)),
                     "FUNCTION TCPM takes F TCP, AXIS POS, PATHCTRL and REFPNT");
    }
  }
  return set_tcp(true, start);
}

bool HeidenhainProgram::plane() {
  if (accept("RESET") && (accept("STAY") || at_end())) return expect_end();
  return unknown(at_, "PLANE", "tilted planes are not read; post M128 or FUNCTION TCPM");
}

bool HeidenhainProgram::cycle_definition() {
  const std::size_t column = at_;
  if (!accept("DEF"))
    return unknown(column, "CYCL", "only CYCL DEF 7, 9, 32 and 247 are known; post the motions themselves");
  skip_blanks();
  const std::size_t number_column = at_;
  double value = 0.0;
  if (!number(value)) return false;
  const auto cycle = static_cast<std::int64_t>(std::floor(std::min(std::abs(value), 1e6) + 1e-9));
  const auto part =
      static_cast<std::int64_t>(std::llround((std::min(std::abs(value), 1e6) - static_cast<double>(cycle)) * 10.0));
  switch (cycle) {
    case 7:
      return datum_shift(part);
    case 32:
      return tolerance(part);
    case 9:
      if (part == 0) return true;
      if (!accept("DWELL") && !accept("V.ZEIT"))
        return fault(at_, "program-syntax", "CYCL DEF 9.1 DWELL is followed by seconds");
      if (!number(dwell_s_)) return false;
      if (dwell_s_ < 0.0) return fault(number_column, "program-word-range", "the dwell is negative");
      reading_.queue.push_back(state_.dwell(dwell_s_));
      return expect_end();
    case 247:
      reading_.diagnosis.warn_once("247",
                                   "CYCL DEF 247: no table of datums is known; the setup's program zero is taken");
      return true;
    default:
      return unknown(number_column, "CYCL DEF " + std::to_string(cycle),
                     "this cycle is not read; post the motions themselves");
  }
}

bool HeidenhainProgram::tolerance(std::int64_t part) {
  MotionBlock& standing = state_.standing;
  if (part == 0) return true;  // the name
  if (part == 1) {
    standing.path_tolerance_mm = standing.rotary_tolerance_rad = -1.0;
    if (at_end() || accept("NO ENT")) return expect_end();
    if (!accept("T")) return fault(at_, "program-syntax", "CYCL DEF 32.1 takes T, the contour tolerance");
    double value = 0.0;
    const std::size_t column = at_;
    if (!number(value)) return false;
    if (value < 0.0) return fault(column, "program-word-range", "the tolerance is negative");
    standing.path_tolerance_mm = value;
    return expect_end();
  }
  while (!at_end()) {
    double value = 0.0;
    const std::size_t column = at_;
    if (accept("HSC-MODE:")) {
      if (!number(value)) return false;
    } else if (accept("TA")) {
      if (!number(value)) return false;
      if (value < 0.0) return fault(column, "program-word-range", "the rotary tolerance is negative");
      standing.rotary_tolerance_rad = value * rad_per_deg;
    } else {
      return fault(column, "program-unknown-word", "CYCL DEF 32.2 takes HSC-MODE and TA");
    }
  }
  return true;
}

bool HeidenhainProgram::datum_shift(std::int64_t part) {
  if (part == 0) {
    state_.shift = {};
    return true;
  }
  if (!words(true)) return false;
  for (std::size_t i = 0; i < 5; ++i) {
    const Coordinate& word = words_.axes[i];
    if (!word.given) continue;
    double& shift = i < 3 ? state_.shift.linear_mm[static_cast<Eigen::Index>(i)] : state_.shift.rotary_rad[i - 3];
    const double value = i < 3 ? word.value : word.value * rad_per_deg;
    shift = word.incremental ? shift + value : value;
  }
  return true;
}

bool HeidenhainProgram::label_name(std::string& out) {
  skip_blanks();
  if (at_ < line_.size() && line_[at_] == '"') {
    const std::size_t close = line_.find('"', at_ + 1);
    if (close == std::string_view::npos) return fault(at_, "program-syntax", "the label has no closing quote");
    out = std::string(line_.substr(at_, close + 1 - at_));
    at_ = close + 1;
    return true;
  }
  std::int64_t number = 0;
  if (!integer(number, 0, 65535)) return false;
  out = std::to_string(number);
  return true;
}

bool HeidenhainProgram::label() {
  std::string name;
  if (!label_name(name) || !expect_end()) return false;
  if (name != "0" || calls_.empty()) return true;
  reading_.source.go_to(calls_.back().back);
  calls_.pop_back();
  return true;
}

bool HeidenhainProgram::go_to_label(const std::string& wanted, LineMark& out) {
  if (!labels_indexed_) {
    labels_indexed_ = true;
    Source all(reading_.source.text(), reading_.source.file_name());
    while (const auto line = all.next_line()) {
      std::size_t at = line->find_first_not_of(" \t0123456789");
      if (at == std::string_view::npos || !line->substr(at).starts_with("LBL")) continue;
      at = line->find_first_not_of(" \t", at + 3);
      if (at == std::string_view::npos) continue;
      std::size_t end = at;
      if ((*line)[at] == '"') {
        end = line->find('"', at + 1);
        end = end == std::string_view::npos ? line->size() : end + 1;
      } else {
        while (end < line->size() && (*line)[end] >= '0' && (*line)[end] <= '9') ++end;
      }
      labels_.emplace(std::string(line->substr(at, end - at)), all.after());
    }
  }
  const auto found = labels_.find(wanted);
  if (found == labels_.end()) return fault(at_, "program-subprogram", "LBL " + wanted + " is not in this program");
  out = found->second;
  return true;
}

bool HeidenhainProgram::jump(LineMark mark) {
  if (++jumps_ > heidenhain_jumps_most) return fault(0, "program-endless", "labels were called a million times");
  reading_.source.go_to(mark);
  return true;
}

bool HeidenhainProgram::call() {
  const std::size_t column = at_;
  if (!accept("LBL")) return unknown(column, "CALL", "programs in other files are not read; copy the motions in");
  std::string name;
  LineMark mark;
  if (!label_name(name) || !go_to_label(name, mark)) return false;
  if (accept("REP")) {
    std::int64_t times = 0;
    if (!integer(times, 1, 65535) || !expect_end()) return false;
    std::int64_t& left = repeats_.try_emplace(reading_.source.line(), times).first->second;
    if (left == 0) {
      repeats_.erase(reading_.source.line());
      return true;
    }
    --left;
    return jump(mark);
  }
  if (!expect_end()) return false;
  if (calls_.size() == heidenhain_calls_most)
    return fault(column, "program-subprogram", "subprograms call each other more than 20 deep");
  calls_.push_back({reading_.source.after()});
  return jump(mark);
}

bool HeidenhainProgram::q_assignment() {
  Formula left(line_, at_, 'Q', variables_, reading_.diagnosis);
  int index = 0;
  if (!left.variable_index(index)) return false;
  at_ = left.at();
  skip_blanks();
  if (at_ >= line_.size() || line_[at_] != '=') return fault(at_, "program-syntax", "\"=\" is missing here");
  Formula right(line_, at_ + 1, 'Q', variables_, reading_.diagnosis);
  double value = 0.0;
  if (!right.sum(value)) return false;
  at_ = right.at();
  variables_.set(index, value);
  return expect_end();
}

bool HeidenhainProgram::q_function() {
  std::int64_t which = 0;
  if (!integer(which, 0, 99)) return false;
  if (!accept(":")) return fault(at_, "program-syntax", "\":\" is missing here");
  if (which >= 9 && which <= 12) return q_jump(which);
  if (which > 7) return unknown(at_, "FN " + std::to_string(which), "FN 0 to 7 and 9 to 12 are known");
  skip_blanks();
  Formula left(line_, at_, 'Q', variables_, reading_.diagnosis);
  int index = 0;
  if (left.peek() != 'Q' && left.peek() != 'q') return fault(at_, "program-syntax", "a Q parameter belongs here");
  if (!left.variable_index(index)) return false;
  at_ = left.at();
  if (!accept("=")) return fault(at_, "program-syntax", "\"=\" is missing here");
  double a = 0.0, b = 0.0;
  const std::size_t column = at_;
  if (which == 5 && !accept("SQRT")) return fault(at_, "program-syntax", "SQRT belongs here");
  if (which == 6 && !accept("SIN")) return fault(at_, "program-syntax", "SIN belongs here");
  if (which == 7 && !accept("COS")) return fault(at_, "program-syntax", "COS belongs here");
  if (!number(a)) return false;
  if (which >= 1 && which <= 4) {
    static constexpr std::array<std::string_view, 4> signs{"+", "-", "*", "DIV"};
    const auto sign = static_cast<std::size_t>(which - 1);
    if (!accept(signs[sign]) && !(which == 4 && accept("/")))
      return fault(at_, "program-syntax",
                   "FN " + std::to_string(which) + ": " + std::string(signs[sign]) + " belongs here");
    if (!number(b)) return false;
  }
  const std::array<double, 8> results{
      a, a + b, a - b, a * b, a / b, std::sqrt(a), std::sin(a * rad_per_deg), std::cos(a * rad_per_deg)};
  const double value = results[static_cast<std::size_t>(which)];
  if (!std::isfinite(value)) return fault(column, "program-expression", "the result is not a finite number");
  variables_.set(index, value);
  return expect_end();
}

bool HeidenhainProgram::q_jump(std::int64_t which) {
  static constexpr std::array<std::string_view, 4> relations{"EQU", "NE", "GT", "LT"};
  double a = 0.0, b = 0.0;
  if (!accept("IF") || !number(a)) return fault(at_, "program-syntax", "IF and a number belong here");
  const auto relation = static_cast<std::size_t>(which - 9);
  if (!accept(relations[relation]))
    return fault(at_, "program-syntax", std::string(relations[relation]) + " belongs here");
  if (!number(b)) return false;
  if (!accept("GOTO") || !accept("LBL")) return fault(at_, "program-syntax", "GOTO LBL belongs here");
  std::string name;
  if (!label_name(name) || !expect_end()) return false;
  const std::array<bool, 4> truth{a == b, a != b, a > b, a < b};
  if (!truth[relation]) return true;
  LineMark mark;
  return go_to_label(name, mark) && jump(mark);
}

}  // namespace volute::sim
