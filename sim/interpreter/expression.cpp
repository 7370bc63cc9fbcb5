#include "sim/interpreter/expression.hpp"

#include <array>
#include <cmath>
#include <string>

#include "geometry/number_text.hpp"
#include "sim/interpreter/arithmetic.hpp"

namespace volute::sim {

namespace {

/// LinuxCNC's EQ and NE take numbers that differ by less as equal.
constexpr double equal_within = 1e-4;

struct Operator {
  std::string_view name;
  int precedence;
};
/// Longer names first where one begins another.
constexpr std::array<Operator, 15> operators{{{"**", 5},
                                              {"*", 4},
                                              {"/", 4},
                                              {"MOD", 4},
                                              {"+", 3},
                                              {"-", 3},
                                              {"EQ", 2},
                                              {"NE", 2},
                                              {"GT", 2},
                                              {"GE", 2},
                                              {"LT", 2},
                                              {"LE", 2},
                                              {"AND", 1},
                                              {"OR", 1},
                                              {"XOR", 1}}};

double remainder_of(double a, double b) {
  const double rest = std::fmod(a, b);
  return rest < 0.0 ? rest + std::abs(b) : rest;
}

double truth(bool value) { return value ? 1.0 : 0.0; }

double combine(std::string_view name, double a, double b) {
  if (name == "**") return std::pow(a, b);
  if (name == "*") return a * b;
  if (name == "/") return a / b;
  if (name == "MOD") return remainder_of(a, b);
  if (name == "+") return a + b;
  if (name == "-") return a - b;
  if (name == "EQ") return truth(std::abs(a - b) < equal_within);
  if (name == "NE") return truth(std::abs(a - b) >= equal_within);
  if (name == "GT") return truth(a > b);
  if (name == "GE") return truth(a >= b);
  if (name == "LT") return truth(a < b);
  if (name == "LE") return truth(a <= b);
  if (name == "AND") return truth(a != 0.0 && b != 0.0);
  if (name == "OR") return truth(a != 0.0 || b != 0.0);
  return truth((a != 0.0) != (b != 0.0));
}

}  // namespace

std::optional<double> read_plain_number(std::string_view line, std::size_t& at, bool& point) {
  std::size_t end = at;
  if (end < line.size() && (line[end] == '+' || line[end] == '-')) ++end;
  bool digits = false;
  point = false;
  for (; end < line.size(); ++end) {
    if (is_digit(line[end]))
      digits = true;
    else if (line[end] == '.' && !point)
      point = true;
    else
      break;
  }
  if (!digits) return std::nullopt;
  const auto value = geometry::parse_number(line.substr(at, end - at));
  if (value) at = end;
  return value;
}

void ValueReader::skip_blanks() {
  while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t')) ++at_;
}

bool ValueReader::value(double& out) {
  skip_blanks();
  bool point = false;
  if (const auto number = read_plain_number(line_, at_, point)) {
    out = *number;
    return true;
  }
  if (++depth_ > nesting_most) return fault(at_, "the expression is nested too deeply");
  const char c = peek();
  bool ok = false;
  if (c == '[') {
    ok = bracketed(out);
  } else if (c == '#') {
    ok = parameter(out);
  } else if (c == '-' || c == '+') {
    ++at_;
    ok = value(out);
    if (c == '-') out = -out;
  } else if (is_letter(c)) {
    ok = function(out);
  } else {
    ok = fault(at_, "a number is missing here");
  }
  --depth_;
  return ok;
}

bool ValueReader::bracketed(double& out) {
  skip_blanks();
  if (peek() != '[') return fault(at_, "\"[\" is missing here");
  ++at_;
  if (!binary(1, out)) return false;
  skip_blanks();
  if (peek() != ']') return fault(at_, "\"]\" or an operator is missing here");
  ++at_;
  return true;
}

int ValueReader::operator_here(std::string_view& name) const {
  for (const Operator& candidate : operators) {
    std::size_t i = 0;
    while (i < candidate.name.size() && at_ + i < line_.size() && upper_case(line_[at_ + i]) == candidate.name[i]) ++i;
    if (i < candidate.name.size()) continue;
    name = candidate.name;
    return candidate.precedence;
  }
  return 0;
}

bool ValueReader::binary(int least_precedence, double& out) {
  if (!value(out)) return false;
  while (true) {
    skip_blanks();
    std::string_view name;
    const int precedence = operator_here(name);
    if (precedence == 0 || precedence < least_precedence) return true;
    const std::size_t column = at_;
    at_ += name.size();
    double right = 0.0;
    if (++depth_ > nesting_most) return fault(at_, "the expression is nested too deeply");
    if (!binary(precedence + 1, right)) return false;
    --depth_;
    out = combine(name, out, right);
    if (!std::isfinite(out)) return fault(column, "the result of " + std::string(name) + " is not a finite number");
  }
}

bool ValueReader::name(std::string_view& out) {
  const std::size_t close = line_.find('>', at_);
  if (close == std::string_view::npos) return fault(at_, "\">\" is missing behind the name");
  out = line_.substr(at_ + 1, close - at_ - 1);
  at_ = close + 1;
  if (plain_name(out).empty()) return fault(at_, "the name is empty");
  return true;
}

bool ValueReader::parameter_index(int& out) {
  const std::size_t column = at_;
  double index = 0.0;
  if (!value(index)) return false;
  const double whole = std::round(index);
  if (std::abs(index - whole) > 1e-6 || whole < 1.0 || whole > Parameters::highest)
    return diagnosis_.fault(column, "program-parameter",
                            "parameter number " + geometry::short_text(index) + " is not a whole number from 1 to " +
                                std::to_string(Parameters::highest));
  out = static_cast<int>(whole);
  return true;
}

namespace {
/// LinuxCNC's named parameters that read a pin or an INI entry.
bool system_name(std::string_view name) {
  const std::string plain = plain_name(name);
  return plain.starts_with("_hal[") || plain.starts_with("_ini[");
}
}  // namespace

bool ValueReader::parameter(double& out) {
  const std::size_t column = at_++;
  skip_blanks();
  if (peek() == '<') {
    std::string_view text;
    if (!name(text)) return false;
    const auto found = parameters_.named(text);
    if (!found)
      return diagnosis_.fault(
          column, "program-parameter",
          "parameter " + in_quotes(text) + " has no value here: " +
              (system_name(text) ? "only a running control has it; write the number in its place"
                                 : "it was not set; set it above, or write the number in its place"));
    out = *found;
    return true;
  }
  int index = 0;
  if (!parameter_index(index)) return false;
  auto found = parameters_.number(index);
  if (!found && system_) found = system_(index);
  if (!found && unset_is_zero_ && index < 5000) found = 0.0;
  if (!found)
    return diagnosis_.fault(
        column, "program-parameter",
        "parameter #" + std::to_string(index) +
            " has no value here: it was not set, or it belongs to the machine; set it in the program");
  out = *found;
  return true;
}

bool ValueReader::exists(double& out) {
  skip_blanks();
  if (peek() != '[') return fault(at_, "\"[\" is missing here");
  ++at_;
  skip_blanks();
  if (peek() != '#') return fault(at_, "EXISTS takes a parameter: EXISTS[#<name>]");
  ++at_;
  skip_blanks();
  if (peek() == '<') {
    std::string_view text;
    if (!name(text)) return false;
    out = truth(parameters_.named(text).has_value());
  } else {
    int index = 0;
    if (!parameter_index(index)) return false;
    out = truth(parameters_.number(index).has_value());
  }
  skip_blanks();
  if (peek() != ']') return fault(at_, "\"]\" is missing here");
  ++at_;
  return true;
}

bool ValueReader::arc_tangent(double& out) {
  double y = 0.0, x = 0.0;
  if (!bracketed(y)) return false;
  skip_blanks();
  if (peek() != '/') return fault(at_, "ATAN takes two values: ATAN[y]/[x]");
  ++at_;
  if (!bracketed(x)) return false;
  out = std::atan2(y, x) / rad_per_deg;
  return true;
}

bool ValueReader::function(double& out) {
  const std::size_t column = at_;
  std::string name;
  while (is_letter(peek())) name += upper_case(line_[at_++]);
  if (name == "EXISTS") return exists(out);
  if (name == "ATAN") return arc_tangent(out);
  double argument = 0.0;
  return bracketed(argument) && apply(name, column, argument, out);
}

bool ValueReader::apply(std::string_view name, std::size_t column, double argument, double& out) {
  if (const auto common = common_function(name, argument))
    out = *common;
  else if (name == "EXP")
    out = std::exp(argument);
  else if (name == "FIX")
    out = std::floor(argument);
  else if (name == "FUP")
    out = std::ceil(argument);
  else if (name == "LN")
    out = std::log(argument);
  else if (name == "ROUND")
    out = std::round(argument);
  else
    return fault(column, in_quotes(name) + " is not a function that is known here");
  if (!std::isfinite(out))
    return fault(column, std::string(name) + " of " + geometry::short_text(argument) + " is not a finite number");
  return true;
}

}  // namespace volute::sim
