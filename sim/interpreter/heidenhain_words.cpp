// The words of Heidenhain's blocks.
#include <algorithm>
#include <cmath>

#include "geometry/number_text.hpp"
#include "sim/interpreter/arithmetic.hpp"
#include "sim/interpreter/expression.hpp"
#include "sim/interpreter/heidenhain_program.hpp"

namespace volute::sim {

void HeidenhainProgram::skip_blanks() {
  while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t')) ++at_;
}

bool HeidenhainProgram::at_end() {
  skip_blanks();
  return at_ >= line_.size() || line_[at_] == ';';
}

std::string HeidenhainProgram::name() {
  std::string out;
  while (at_ < line_.size() && is_letter(line_[at_])) out += upper_case(line_[at_++]);
  return out;
}

bool HeidenhainProgram::accept(std::string_view text) {
  skip_blanks();
  std::size_t i = 0;
  while (i < text.size() && at_ + i < line_.size() && upper_case(line_[at_ + i]) == text[i]) ++i;
  if (i < text.size()) return false;
  const bool goes_on = at_ + i < line_.size() && is_letter(text.back()) && is_letter(line_[at_ + i]);
  if (!goes_on) at_ += i;
  return !goes_on;
}

bool HeidenhainProgram::number(double& out) {
  skip_blanks();
  bool point = false;
  if (const auto plain = read_plain_number(line_, at_, point)) {
    out = *plain;
    return true;
  }
  Formula formula(line_, at_, 'Q', variables_, reading_.diagnosis);
  const bool ok = formula.factor(out);
  at_ = formula.at();
  return ok;
}

bool HeidenhainProgram::integer(std::int64_t& out, std::int64_t least, std::int64_t most) {
  skip_blanks();
  const std::size_t column = at_;
  double value = 0.0;
  if (!number(value)) return false;
  if (value != std::floor(value) || value < static_cast<double>(least) || value > static_cast<double>(most))
    return fault(column, "program-word-range",
                 "a whole number from " + std::to_string(least) + " to " + std::to_string(most) + " belongs here");
  out = static_cast<std::int64_t>(value);
  return true;
}

bool HeidenhainProgram::expect_end() {
  return at_end() || fault(at_, "program-unknown-word", in_quotes(line_.substr(at_)) + " has no meaning here");
}

bool HeidenhainProgram::words(bool straight) {
  while (!at_end())
    if (!word(straight)) return false;
  return true;
}

bool HeidenhainProgram::word(bool straight) {
  const std::size_t column = at_;
  if (!is_letter(line_[at_]))
    return fault(column, "program-syntax",
                 in_quotes(line_.substr(at_, 1)) + " does not begin a word; a word is a letter with a number");
  // One letter with a number behind it is by far the most frequent word.
  const char first = upper_case(line_[at_]);
  if (at_ + 1 < line_.size() && !is_letter(line_[at_ + 1])) {
    ++at_;
    if (first == 'F') return feed(column);
    if (first == 'M') return m_function(column);
    if (first == 'R') {
      if (straight && accept("0")) return true;
      if (straight) return unknown(column, "R", "R0 belongs here; radius compensation is not read");
      if (words_.radius) return fault(column, "program-syntax", "R stands twice in this block");
      return number(words_.radius.emplace());
    }
    return coordinate(std::string(1, first), column);
  }
  const std::string text = name();
  if (text == "FMAX") return words_.rapid = true;
  if (text == "F") return feed(column);
  if (text == "RL" || text == "RR")
    return unknown(column, text, "radius compensation is not read: let the CAM system compensate");
  if (text == "DR") {
    skip_blanks();
    if (at_ >= line_.size() || (line_[at_] != '+' && line_[at_] != '-'))
      return fault(column, "program-syntax", "DR+ or DR- belongs here");
    words_.clockwise = line_[at_++] == '-';
    return true;
  }
  return coordinate(text, column);
}

bool HeidenhainProgram::coordinate(const std::string& text, std::size_t column) {
  const char last = text.back();
  if (text.size() == 2 && (text[0] == 'N' || text[0] == 'T') && last >= 'X' && last <= 'Z') {
    auto& vector = text[0] == 'N' ? words_.normal : words_.tool;
    words_.vector_column = column;
    return number(vector[static_cast<std::size_t>(last - 'X')].emplace());
  }
  const bool incremental = text.size() == 2 && text[0] == 'I';
  if (text.size() > 1 && !incremental) return unknown(column, text, "this word is not known in a positioning block");
  int axis = last >= 'X' && last <= 'Z' ? last - 'X' : -1;
  if (const int rotary = state_.rotary_of(last); rotary >= 0) axis = 3 + rotary;
  if (axis < 0)
    return unknown(column, text,
                   last >= 'A' && last <= 'C'
                       ? "this machine has no such axis; choose the machine that the program was written for"
                       : "this word is not known in a positioning block");
  Coordinate& word = words_.axes[static_cast<std::size_t>(axis)];
  if (word.given) return fault(column, "program-syntax", "the word " + text + " stands twice in this block");
  word = {0.0, true, incremental, column};
  return number(word.value);
}

bool HeidenhainProgram::feed(std::size_t column) {
  words_.feed_column = column;
  if (accept("MAX")) return words_.rapid = true;
  if (at_ < line_.size() && is_letter(line_[at_]) && upper_case(line_[at_]) != 'Q')
    return unknown(column, "F" + name(), "the feed is written as F with a number, or FMAX");
  double value = 0.0;
  if (!number(value)) return false;
  if (value < 0.0) return fault(column, "program-word-range", "F is negative");
  words_.feed = value;
  return true;
}

bool HeidenhainProgram::m_function(std::size_t column) {
  std::int64_t number = 0;
  return integer(number, 0, 9999) && m_mode(static_cast<int>(number), column);
}

bool HeidenhainProgram::m_mode(int number, std::size_t column) {
  MotionBlock& standing = state_.standing;
  switch (number) {
    case 0:
    case 2:
    case 5:
    case 30:
      words_.after.push_back(number);
      return true;
    case 3:
    case 4:
    case 13:
    case 14:
      standing.spindle_on = true;
      standing.spindle_reversed = number == 4 || number == 14;
      return true;
    case 1:
    case 8:
    case 9:
    case 107:  // overrides the message of an oversize in the tool call
    case 108:
      return true;
    case 91:
      return words_.machine = true;
    case 94:
      return words_.reduce_turns = true;
    case 126:
      return shortest_way_ = true;
    case 127:
      shortest_way_ = false;
      return true;
    case 128:
      words_.tcp_here = true;
      return set_tcp(true, column);
    case 129:
      return set_tcp(false, column);
    case 140:
      return fault(column, "program-unknown-code",
                   "M140: where this retraction ends depends on the axes' travel; write L Z+0 R0 FMAX M91 instead");
    case 92:
      return fault(column, "program-unknown-code", "M92: the machine's own reference point is not known; write M91");
    default:
      break;
  }
  return fault(column, "program-unknown-code",
               "M" + std::to_string(number) + ": this M function is not known to the simulator's Heidenhain dialect");
}

}  // namespace volute::sim
