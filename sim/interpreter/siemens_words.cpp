// A line of a Siemens program as words.
#include <cctype>
#include <cmath>
#include <numbers>

#include "geometry/number_text.hpp"
#include "sim/interpreter/arithmetic.hpp"
#include "sim/interpreter/expression.hpp"
#include "sim/interpreter/siemens_program.hpp"

namespace volute::sim {

namespace {
bool in_name(char c) { return is_letter(c) || c == '_'; }
void skip_blanks(std::string_view line, std::size_t& at) {
  while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) ++at;
}
}  // namespace

int SiemensProgram::axis_of(char name) const {
  if (name >= 'X' && name <= 'Z') return name - 'X';
  const int rotary = state_.rotary_of(name);
  return rotary < 0 ? -1 : 3 + rotary;
}

bool SiemensProgram::words(std::string_view line, std::size_t at) {
  while (true) {
    skip_blanks(line, at);
    if (at >= line.size() || line[at] == ';') return true;
    if (!word(line, at)) return false;
  }
}

bool SiemensProgram::word(std::string_view line, std::size_t& at) {
  const std::size_t column = at;
  if (!in_name(line[at]))
    return fault(column, "program-syntax", in_quotes(line.substr(at, 1)) + " does not begin a word; take it out");
  // A single letter with a number (X10, G1, R1 = ...), or a name (TRAORI, CR=, CYCLE832(...), A3=).
  std::size_t end = at + 1;
  const bool short_address = end >= line.size() || !in_name(line[end]);
  if (short_address) {
    while (end < line.size() && is_digit(line[end])) ++end;
  } else {
    while (end < line.size() && (in_name(line[end]) || is_digit(line[end]))) ++end;
  }
  std::size_t next = end;
  skip_blanks(line, next);
  const char follows = next < line.size() ? line[next] : '\0';
  if (short_address && follows != '=' && !(follows == '[' && end == at + 1)) {
    std::size_t number_at = at + 1;
    skip_blanks(line, number_at);
    bool point = false;
    const auto value = read_plain_number(line, number_at, point);
    if (!value)
      return fault(column, "program-syntax", "the number is missing behind " + in_quotes(line.substr(column, 1)));
    at = number_at;
    return address(upper_case(line[column]), *value, column);
  }
  std::string name;
  for (std::size_t i = at; i < end; ++i) name += upper_case(line[i]);
  at = next;
  if (follows == '=') return assignment(line, ++at, name, column);
  if (follows == '[') return indexed(name, column);
  if (follows == '(') return call(line, at, name, column);
  if (follows == ':') {
    ++at;  // a label: only jumps look for it, and they are refused
    return true;
  }
  at = end;
  return keyword(name, column);
}

bool SiemensProgram::address(char name, double value, std::size_t column) {
  const auto twice = [&](const auto& word) {
    return word ? fault(column, "program-syntax", std::string("the word ") + name + " stands twice in this block")
                : true;
  };
  if (const int axis = axis_of(name); axis >= 0) {
    SiemensAxisWord& word = words_.axes[static_cast<std::size_t>(axis)];
    if (word.given)
      return fault(column, "program-syntax", std::string("the word ") + name + " stands twice in this block");
    word = {value, SiemensValue::modal, column, true};
    return true;
  }
  switch (name) {
    case 'G':
      return g_code(value, column);
    case 'M':
      return m_code(value, column);
    case 'F':
      words_.feed_column = column;
      if (!twice(words_.feed)) return false;
      words_.feed = value;
      return true;
    case 'S':
      if (!twice(words_.speed)) return false;
      words_.speed = value;
      return true;
    case 'T':
      return tool_number(value, column);
    case 'D':
      state_.set_tool_length(value != 0.0);
      return true;
    case 'I':
    case 'J':
    case 'K':
      words_.centre[static_cast<std::size_t>(name - 'I')] = {value, SiemensValue::modal, column, true};
      return true;
    case 'N':
      return fault(column, "program-syntax", "a block number stands only at the beginning of its block");
    case 'L':
      return unknown(column, "L", "subprograms in other files are not read; copy the motions in");
    case 'A':
    case 'B':
    case 'C':
      return unknown(column, std::string(1, name),
                     "this machine has no such axis; choose the machine that the program was written for");
    default:
      return unknown(column, std::string(1, name), "this word has no meaning here");
  }
}

bool SiemensProgram::axis_value(std::string_view line, std::size_t& at, SiemensAxisWord& out) {
  skip_blanks(line, at);
  struct Mode {
    std::string_view name;
    SiemensValue mode;
  };
  static constexpr std::array<Mode, 5> modes{{{"ACP(", SiemensValue::positive},
                                              {"ACN(", SiemensValue::negative},
                                              {"AC(", SiemensValue::absolute},
                                              {"IC(", SiemensValue::incremental},
                                              {"DC(", SiemensValue::direct}}};
  bool bracket = false;
  for (const Mode& mode : modes) {
    std::size_t i = 0;
    while (i < mode.name.size() && at + i < line.size() && upper_case(line[at + i]) == mode.name[i]) ++i;
    if (i < mode.name.size()) continue;
    out.mode = mode.mode;
    at += i;
    bracket = true;
    break;
  }
  Formula formula(line, at, 'R', variables_, reading_.diagnosis);
  if (!formula.sum(out.value)) return false;
  at = formula.at();
  skip_blanks(line, at);
  if (!bracket) return true;
  if (at >= line.size() || line[at] != ')') return fault(at, "program-syntax", "\")\" is missing here");
  ++at;
  return true;
}

bool SiemensProgram::string_value(std::string_view line, std::size_t& at, std::string& out) {
  skip_blanks(line, at);
  if (at >= line.size() || line[at] != '"') return true;
  const std::size_t close = line.find('"', at + 1);
  if (close == std::string_view::npos) return fault(at, "program-syntax", "the text has no closing quote");
  out = line.substr(at + 1, close - at - 1);
  at = close + 1;
  return true;
}

bool SiemensProgram::assignment(std::string_view line, std::size_t& at, const std::string& name, std::size_t column) {
  if (name == "T") {
    std::string tool;
    if (!string_value(line, at, tool)) return false;
    if (!tool.empty()) {
      reading_.diagnosis.warn_once("tool name", "tools are called by name; the job's tool stands for all of them");
      return tool_number(0.0, column);
    }
  }
  SiemensAxisWord word{0.0, SiemensValue::modal, column, true};
  if (!axis_value(line, at, word)) return false;
  if (name.size() == 1) {
    if (const int axis = axis_of(name[0]); axis >= 0) {
      if (words_.axes[static_cast<std::size_t>(axis)].given)
        return fault(column, "program-syntax", "the word " + name + " stands twice in this block");
      words_.axes[static_cast<std::size_t>(axis)] = word;
      return true;
    }
    if (name[0] >= 'I' && name[0] <= 'K') {
      words_.centre[static_cast<std::size_t>(name[0] - 'I')] = word;
      return true;
    }
    return address(name[0], word.value, column);
  }
  const double value = word.value;
  if (name[0] == 'R' && name.size() > 1 && is_digit(name[1])) {
    const auto index = geometry::parse_integer(std::string_view(name).substr(1));
    if (!index || *index > Variables::highest) return unknown(column, name, "R parameters are R0 to R1999");
    variables_.set(static_cast<int>(*index), value);
    return true;
  }
  if (name == "A3" || name == "B3" || name == "C3") {
    words_.vector[static_cast<std::size_t>(name[0] - 'A')] = value;
    words_.vector_column = column;
    return true;
  }
  if (name == "CR") return words_.radius = value, true;
  if (name == "AR") return words_.opening = value * rad_per_deg, true;
  if (name == "TURN") return words_.turn = value, true;
  if (name == "S1") return words_.speed = value, true;
  if (name == "CTOL") return state_.standing.path_tolerance_mm = value < 0.0 ? -1.0 : value * state_.unit_mm(), true;
  if (name == "OTOL") return state_.standing.rotary_tolerance_rad = value < 0.0 ? -1.0 : value * rad_per_deg, true;
  if (name == "ADIS" || name == "ADISPOS") {
    if (name == "ADIS") state_.standing.path_tolerance_mm = value * state_.unit_mm();
    return true;
  }
  if (name == "A2" || name == "B2" || name == "C2")
    return unknown(column, name, "Euler and RPY angles are not read; post A3 B3 C3 or axis positions");
  return unknown(column, name,
                 "this word is not known to the simulator's Siemens dialect; take it out, or choose the profile that "
                 "the program was written for");
}

bool SiemensProgram::indexed(const std::string& name, std::size_t column) {
  if (name == "FGREF")
    return unknown(column, name, "the radius by which rotary feed counts is the control file's; take it out");
  return unknown(column, name, "words with an index are not read");
}

bool SiemensProgram::arguments(std::string_view line, std::size_t& at, std::vector<std::string_view>& out) {
  const std::size_t open = at++;
  std::size_t begin = at;
  bool text = false;
  int depth = 0;
  for (; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '"') text = !text;
    if (text) continue;
    if (c == '(') ++depth;
    if ((c == ',' && depth == 0) || (c == ')' && depth == 0)) {
      std::string_view item = line.substr(begin, at - begin);
      while (!item.empty() && (item.front() == ' ' || item.front() == '\t')) item.remove_prefix(1);
      while (!item.empty() && (item.back() == ' ' || item.back() == '\t')) item.remove_suffix(1);
      out.push_back(item);
      begin = at + 1;
      if (c == ')') {
        ++at;
        if (out.size() == 1 && out[0].empty()) out.clear();
        return true;
      }
    }
    if (c == ')') --depth;
  }
  return fault(open, "program-syntax", "\")\" is missing behind the arguments");
}

bool SiemensProgram::call(std::string_view line, std::size_t& at, const std::string& name, std::size_t column) {
  std::vector<std::string_view> list;
  if (!arguments(line, at, list)) return false;
  if (name == "CYCLE832") return tolerance_cycle(list, column);
  if (name == "TRAORI") return transformation(true, column);
  if (name == "MSG") return true;
  if (name == "CYCLE800") {
    if (list.empty()) return true;
    return unknown(column, name, "swivelled planes are not read; post TRAORI");
  }
  if (name == "FGROUP") {
    if (list.empty() || (list.size() == 3 && list[0] == "X" && list[1] == "Y" && list[2] == "Z")) return true;
    return unknown(column, name, "only FGROUP(X,Y,Z) is read");
  }
  return unknown(column, name, "this cycle is not known to the simulator; post the motions themselves");
}

bool SiemensProgram::tolerance_cycle(const std::vector<std::string_view>& list, std::size_t column) {
  MotionBlock& standing = state_.standing;
  standing.path_tolerance_mm = -1.0;
  standing.rotary_tolerance_rad = -1.0;
  if (list.empty()) return true;
  if (list.size() > 3)
    return fault(column, "program-syntax", "CYCLE832 takes (tolerance, mode, orientation tolerance)");
  const auto tolerance = geometry::parse_number(list[0]);
  if (!tolerance || *tolerance < 0.0)
    return fault(column, "program-syntax", "the first argument of CYCLE832 is the contour tolerance, at least 0");
  if (list.size() > 1) {
    const auto mode = geometry::parse_integer(list[1]);
    const bool named = !list[1].empty() && list[1].front() == '_';
    if (!mode && !named)
      return fault(column, "program-syntax", "the second argument of CYCLE832 is a number or a name like _FINISH");
    if (list[1] == "_OFF" || (mode && *mode % 10 == 0)) return true;
  }
  standing.path_tolerance_mm = *tolerance * state_.unit_mm();
  if (list.size() == 3) {
    const auto orientation = geometry::parse_number(list[2]);
    if (!orientation || *orientation < 0.0)
      return fault(column, "program-syntax",
                   "the third argument of CYCLE832 is the orientation tolerance in degrees, at least 0");
    standing.rotary_tolerance_rad = *orientation * rad_per_deg;
  }
  return true;
}

}  // namespace volute::sim
