#include "sim/interpreter/heidenhain_program.hpp"

#include <cmath>
#include <numbers>

#include "sim/interpreter/arithmetic.hpp"

namespace volute::sim {

std::unique_ptr<Dialect> make_heidenhain_dialect(Reading& reading) {
  return std::make_unique<HeidenhainProgram>(reading);
}

bool HeidenhainProgram::advance() {
  const auto line = reading_.source.next_line();
  if (!line) return fault(0, "program-ended-early", "the text ends without END PGM");
  line_ = *line;
  at_ = 0;
  skip_blanks();
  if (at_ < line_.size() && line_[at_] == '/') ++at_;  // block skip: the switch is taken as off
  skip_blanks();
  while (at_ < line_.size() && line_[at_] >= '0' && line_[at_] <= '9') ++at_;
  // "* - text" structures the listing.
  if (at_end() || line_[at_] == '*') return true;
  words_ = {};
  state_.standing.line = reading_.source.line();
  return statement();
}

bool HeidenhainProgram::statement() {
  // The frequent ones first.
  if (accept("L") || accept("LN")) return straight_line();
  if (accept("CC")) return circle_centre();
  if (accept("CR")) return circle(true);
  if (accept("C")) return circle(false);
  if (accept("BEGIN")) return begin_program();
  if (accept("END")) return end_program();
  if (accept("TOOL")) return tool_call();
  if (accept("CYCL")) return cycle_definition();
  if (accept("FUNCTION")) return function();
  if (accept("PLANE")) return plane();
  if (accept("LBL")) return label();
  if (accept("CALL")) return call();
  if (accept("FN")) return q_function();
  if (accept("STOP")) return stop();
  if (accept("BLK"))
    return accept("FORM") || fault(at_, "program-syntax", "BLK is followed by FORM");  // the blank: moves nothing
  const char first = line_[at_];
  const char next = at_ + 1 < line_.size() ? line_[at_ + 1] : '\0';
  if ((first == 'Q' || first == 'q') && next >= '0' && next <= '9') return q_assignment();
  if ((first == 'M' || first == 'm') && next >= '0' && next <= '9') return words(true) && finish_block();
  const std::size_t column = at_;
  const std::string text = name();
  return unknown(column, text.empty() ? in_quotes(line_.substr(column, 1)) : text,
                 "this block is not known to the simulator's Heidenhain dialect; take it out, or choose the profile "
                 "that the program was written for");
}

bool HeidenhainProgram::begin_program() {
  const std::size_t column = at_;
  if (!accept("PGM")) return fault(at_, "program-syntax", "BEGIN is followed by PGM");
  const std::string_view rest = line_.substr(at_);
  if (rest.find(" INCH") != std::string_view::npos)
    return fault(column, "program-unknown-word", "INCH: programs in inches are not read in this dialect; post in MM");
  if (rest.find(" MM") == std::string_view::npos)
    return fault(column, "program-syntax", "BEGIN PGM needs a name and MM");
  if (begun_) return fault(column, "program-ended-early", "another program begins before the one above has ended");
  begun_ = true;
  return true;
}

bool HeidenhainProgram::end_program() {
  if (!accept("PGM")) return fault(at_, "program-syntax", "END is followed by PGM");
  if (!calls_.empty())
    return fault(at_, "program-ended-early", "the program ends inside a subprogram; LBL 0 is missing");
  reading_.finished = true;
  return true;
}

bool HeidenhainProgram::straight_line() { return words(true) && finish_block(); }

bool HeidenhainProgram::stop() {
  words_.after.push_back(0);
  return words(true) && finish_block();
}

bool HeidenhainProgram::tool_axis(MoveWords& out) {
  const auto& parts = words_.tool;
  if (!parts[0] && !parts[1] && !parts[2]) return true;
  const std::size_t column = words_.vector_column;
  if (!state_.standing.tcp)
    return fault(column, "program-vector", "TX TY TZ need M128 or FUNCTION TCPM; write it before this block");
  if (out.rotary != 0)
    return fault(column, "program-vector", "the tool axis is given by TX TY TZ and by a rotary axis in the same block");
  if (!parts[0] || !parts[1] || !parts[2]) return fault(column, "program-vector", "TX, TY and TZ stand together");
  const Vec3 axis(*parts[0], *parts[1], *parts[2]);
  if (!(axis.norm() > 1e-9)) return fault(column, "program-vector", "the tool axis TX TY TZ has no length");
  out.axis_vector = axis.normalized();
  return true;
}

bool HeidenhainProgram::move_words(MoveWords& out) {
  for (std::size_t i = 0; i < 5; ++i) {
    const Coordinate& word = words_.axes[i];
    if (!word.given) continue;
    const unsigned bit = 1U << (i < 3 ? i : i - 3);
    if (i < 3) {
      out.linear |= bit;
      out.linear_mm[i] = word.value;
      if (word.incremental) out.linear_incremental |= bit;
    } else {
      out.rotary |= bit;
      out.rotary_rad[i - 3] = word.value * rad_per_deg;
      if (word.incremental) out.rotary_incremental |= bit;
    }
  }
  out.rotary_shortest = shortest_way_;
  out.machine_coordinates = words_.machine;
  return tool_axis(out);
}

void HeidenhainProgram::reduce_turns() {
  // M94: the axes keep standing, their values drop below one turn.
  for (int rotary = 0; rotary < 2; ++rotary) {
    const auto now = state_.program_rotary_rad(rotary);
    if (now)
      state_.shift.rotary_rad[static_cast<std::size_t>(rotary)] += turn_rad * std::floor(*now / turn_rad + 1e-12);
  }
}

bool HeidenhainProgram::finish_block() {
  const bool moves_axes = [&] {
    for (const Coordinate& word : words_.axes)
      if (word.given) return true;
    return words_.tool[0] || words_.tool[1] || words_.tool[2];
  }();
  if (words_.radius || words_.clockwise)
    return fault(words_.feed_column, "program-unknown-word", "R and DR belong to circles");
  if (words_.feed && words_.tcp_here && !moves_axes) {
    reading_.diagnosis.warn_once(
        "M128 F", "F with M128 limits the compensating moves; the virtual control keeps its axis limits instead");
    words_.feed.reset();
  }
  if (words_.feed) state_.feed_number = *words_.feed;
  if (words_.reduce_turns) reduce_turns();
  if (moves_axes) {
    MoveWords moves;
    if (!move_words(moves)) return false;
    if (words_.machine && (moves.linear_incremental != 0 || moves.rotary_incremental != 0))
      return fault(0, "program-syntax", "M91 gives positions; incremental words have no meaning with it");
    if (words_.machine && state_.standing.tcp)
      return fault(0, "program-machine-tcp", "machine coordinates (M91) while M128 is on; write M129 first");
    MotionBlock block;
    if (!state_.line(words_.rapid ? MotionKind::rapid : MotionKind::line, moves, 0, block)) return false;
    reading_.queue.push_back(block);
  }
  for (const int code : words_.after) {
    if (code == 0) reading_.queue.push_back(state_.stop());
    if (code == 5) state_.standing.spindle_on = false;
    if (code == 2 || code == 30) reading_.finished = true;
  }
  return true;
}

bool HeidenhainProgram::circle_centre() {
  if (!words(false)) return false;
  for (std::size_t i = 0; i < 2; ++i) {
    const Coordinate& word = words_.axes[i];
    if (!word.given) continue;
    const auto now = state_.program_linear_mm(static_cast<int>(i));
    if (word.incremental && !now)
      return fault(word.column, "program-position-unknown",
                   "the circle's centre is given from a position that is not known here");
    pole_mm_[i] = word.value + (word.incremental ? *now : 0.0);
  }
  if (words_.axes[2].given)
    return fault(words_.axes[2].column, "program-unknown-word", "circles are read in the plane of X and Y");
  return true;
}

bool HeidenhainProgram::circle(bool by_radius) {
  const std::size_t column = at_ > 0 ? at_ - 1 : 0;
  if (!words(false)) return false;
  if (!words_.clockwise) return fault(column, "program-arc", "a circle needs its direction, DR+ or DR-");
  if (words_.machine) return fault(column, "program-arc", "a circle has no machine coordinates");
  if (words_.feed) state_.feed_number = *words_.feed;
  MoveWords moves;
  if (!move_words(moves)) return false;
  ArcWords arc;
  arc.clockwise = *words_.clockwise;
  arc.column = column;
  if (by_radius) {
    if (!words_.radius) return fault(column, "program-arc", "CR needs the radius R");
    arc.radius_mm = words_.radius;
  } else {
    if (!pole_mm_[0] || !pole_mm_[1])
      return fault(column, "program-arc", "C needs a centre; write CC with X and Y before it");
    arc.centre = arc.centre_absolute = 3U;
    arc.centre_mm = {*pole_mm_[0], *pole_mm_[1], 0.0};
  }
  MotionBlock block;
  if (!state_.arc(moves, arc, block)) return false;
  reading_.queue.push_back(block);
  words_.axes = {};
  words_.feed.reset();
  words_.radius.reset();
  words_.clockwise.reset();
  return finish_block();
}

bool HeidenhainProgram::tool_call() {
  if (accept("DEF")) {
    std::int64_t number = 0;
    return integer(number, 0, 99'999'999) && expect_end();  // fetches the next tool: moves nothing
  }
  if (!accept("CALL")) return fault(at_, "program-syntax", "TOOL is followed by CALL or DEF");
  const std::size_t column = at_;
  if (state_.standing.tcp)
    return fault(column, "program-tool-change", "the tool is changed while M128 is on; write M129 first");
  bool changed = false;
  std::int64_t tool = state_.standing.tool_number;
  skip_blanks();
  if (at_ < line_.size() && line_[at_] == '"') {
    const std::size_t close = line_.find('"', at_ + 1);
    if (close == std::string_view::npos) return fault(at_, "program-syntax", "the name has no closing quote");
    at_ = close + 1;
    tool = 0;
    changed = true;
    reading_.diagnosis.warn_once("tool name", "tools are called by name; the job's tool stands for all of them");
  } else if (at_ < line_.size() && line_[at_] >= '0' && line_[at_] <= '9') {
    if (!integer(tool, 0, 99'999'999)) return false;
    changed = true;
  }
  while (!at_end()) {
    const std::size_t word_column = at_;
    const std::string text = name();
    if (text == "Z") continue;
    double value = 0.0;
    if (text != "S" && text != "F" && text != "DL" && text != "DR")
      return unknown(word_column, text.empty() ? in_quotes(line_.substr(word_column, 1)) : text,
                     "TOOL CALL takes the tool, Z, S, F, DL and DR");
    if (!number(value)) return false;
    if ((text == "DL" || text == "DR") && value != 0.0)
      return unknown(word_column, text, "an oversize of the tool is not read; give the tool its true size in the job");
    if (value < 0.0) return fault(word_column, "program-word-range", text + " is negative");
    if (text == "S") state_.standing.spindle_rad_s = value * rad_s_per_rpm;
    if (text == "F") state_.feed_number = value;
  }
  if (!changed) return true;
  state_.standing.tool_number = static_cast<int>(tool);
  state_.set_tool_length(true);
  reading_.queue.push_back(state_.stop());
  return true;
}

}  // namespace volute::sim
