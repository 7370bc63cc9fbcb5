#include "sim/interpreter/word_lexer.hpp"

#include <cmath>
#include <string>

#include "sim/interpreter/arithmetic.hpp"

namespace volute::sim {

namespace {
bool blank(char c) { return c == ' ' || c == '\t'; }
}  // namespace

bool WordLexer::skip_comments(std::string_view line, std::size_t& at) {
  while (at < line.size()) {
    const char c = line[at];
    if (blank(c)) {
      ++at;
    } else if (c == '(') {
      const std::size_t close = line.find(')', at);
      if (close == std::string_view::npos) return fault(at, "the comment has no \")\"; close it on its line");
      if (style_.linuxcnc && line.substr(at + 1, close - at - 1).find('(') != std::string_view::npos)
        return fault(at, "a comment in a comment");
      at = close + 1;
    } else if (c == ';') {
      // LinuxCNC: a comment up to the end of the line; elsewhere the sign for the end of a block.
      if (!style_.linuxcnc && line.find_first_not_of(" \t;", at) != std::string_view::npos)
        return fault(at, "text behind the end-of-block sign \";\"");
      at = line.size();
    } else {
      return true;
    }
  }
  return true;
}

bool WordLexer::skip_prefix(std::string_view line, std::size_t& at) {
  if (!skip_comments(line, at)) return false;
  // Block delete: the switch is taken as off, so the block runs.
  if (at < line.size() && line[at] == '/') {
    ++at;
    if (at < line.size() && is_digit(line[at])) ++at;
    if (!skip_comments(line, at)) return false;
  }
  if (at >= line.size() || (line[at] != 'N' && line[at] != 'n')) return true;
  const std::size_t column = at++;
  while (at < line.size() && blank(line[at])) ++at;
  const std::size_t first = at;
  while (at < line.size() && (is_digit(line[at]) || line[at] == '.')) ++at;
  if (at == first) return fault(column, "the block number is missing behind N");
  return skip_comments(line, at);
}

bool WordLexer::read(std::string_view line, std::size_t at, Block& block) {
  block.clear();
  assignments_.clear();
  while (true) {
    if (at < line.size() && (blank(line[at]) || line[at] == '(' || line[at] == ';') && !skip_comments(line, at))
      return false;
    if (at >= line.size()) break;
    if (line[at] == '#' ? !assignment(line, at) : !word(line, at, block)) return false;
  }
  // All values of a line are read before any of its parameters is set.
  for (const Assignment& set : assignments_) {
    if (set.name.empty())
      parameters_.set_number(set.index, set.value);
    else
      parameters_.set_named(set.name, set.value);
  }
  return true;
}

bool WordLexer::word(std::string_view line, std::size_t& at, Block& block) {
  const std::size_t column = at;
  char c = line[at];
  if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  if (c < 'A' || c > 'Z')
    return fault(column, in_quotes(line.substr(at, 1)) + " does not begin a word; a word is a letter with a number");
  ++at;
  while (at < line.size() && blank(line[at])) ++at;
  bool point = false;
  double value = 0.0;
  if (const auto number = read_plain_number(line, at, point)) {
    value = *number;
    std::size_t next = at;
    while (next < line.size() && blank(line[next])) ++next;
    if (next < line.size() && (is_digit(line[next]) || line[next] == '.'))
      return fault(next, "the number of " + in_quotes(line.substr(column, next + 1 - column)) + " is broken");
  } else if (at < line.size() && (line[at] == '#' || line[at] == '[' || line[at] == '-' || line[at] == '+' ||
                                  (style_.linuxcnc && line[at] != '(' && line[at] != ';'))) {
    ValueReader reader = values(line, at);
    if (!reader.value(value)) return false;
    at = reader.at();
    point = true;
  } else {
    return fault(column, "the number is missing behind " + in_quotes(line.substr(column, 1)) +
                             "; write it, or take the letter out");
  }
  if (c == 'G' || c == 'M') return code({0, static_cast<std::uint32_t>(column)}, value, c == 'G', block);
  const std::size_t i = Block::index(c);
  if (block.has(c)) return fault(column, std::string("the word ") + c + " stands twice in this block");
  block.present |= 1U << i;
  if (point) block.point |= 1U << i;
  block.values[i] = value;
  block.columns[i] = static_cast<std::uint32_t>(column);
  return true;
}

bool WordLexer::code(Code code, double value, bool is_g, Block& block) {
  const double tenths = std::round(value * 10.0);
  if (std::abs(value * 10.0 - tenths) > 1e-6 || tenths < 0.0 || tenths > 99999.0)
    return diagnosis_.fault(code.column, "program-unknown-code",
                            std::string(is_g ? "G" : "M") + " takes a number with at most one decimal, from 0 to 9999");
  code.tenths = static_cast<int>(tenths);
  auto& list = is_g ? block.g : block.m;
  auto& count = is_g ? block.g_count : block.m_count;
  if (count == Block::codes_most)
    return fault(code.column, std::string("more than 16 ") + (is_g ? "G" : "M") + " codes in one block");
  list[count++] = code;
  return true;
}

bool WordLexer::assignment(std::string_view line, std::size_t& at) {
  const std::size_t column = at;
  ValueReader reader = values(line, at + 1);
  Assignment set;
  reader.skip_blanks();
  if (reader.peek() == '<' ? !reader.name(set.name) : !reader.parameter_index(set.index)) return false;
  reader.skip_blanks();
  if (reader.peek() != '=') return fault(column, "a parameter that stands alone needs \"= value\"");
  ValueReader right = values(line, reader.at() + 1);
  if (!right.value(set.value)) return false;
  at = right.at();
  assignments_.push_back(set);
  return true;
}

}  // namespace volute::sim
