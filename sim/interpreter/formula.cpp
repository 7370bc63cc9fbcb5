#include "sim/interpreter/formula.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "geometry/number_text.hpp"
#include "sim/interpreter/arithmetic.hpp"
#include "sim/interpreter/expression.hpp"

namespace volute::sim {

void Formula::skip_blanks() {
  while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t')) ++at_;
}

bool Formula::sum(double& out) {
  if (++depth_ > nesting_most) return fault(at_, "the formula is nested too deeply");
  if (!product(out)) return false;
  for (skip_blanks(); peek() == '+' || peek() == '-'; skip_blanks()) {
    const char sign = line_[at_++];
    double right = 0.0;
    if (!product(right)) return false;
    out += sign == '+' ? right : -right;
  }
  --depth_;
  return true;
}

bool Formula::product(double& out) {
  if (!factor(out)) return false;
  for (skip_blanks(); peek() == '*' || peek() == '/'; skip_blanks()) {
    const std::size_t column = at_;
    const char sign = line_[at_++];
    double right = 0.0;
    if (!factor(right)) return false;
    out = sign == '*' ? out * right : out / right;
    if (!std::isfinite(out)) return fault(column, "the result is not a finite number");
  }
  return true;
}

bool Formula::factor(double& out) {
  skip_blanks();
  bool point = false;
  if (const auto number = read_plain_number(line_, at_, point)) {
    out = *number;
    return true;
  }
  if (++depth_ > nesting_most) return fault(at_, "the formula is nested too deeply");
  bool ok = false;
  const char c = peek();
  if (c == '+' || c == '-') {
    ++at_;
    ok = factor(out);
    if (c == '-') out = -out;
  } else if (c == '(') {
    ++at_;
    ok = sum(out);
    skip_blanks();
    if (ok && peek() != ')') ok = fault(at_, "\")\" is missing here");
    if (ok) ++at_;
  } else if (upper_case(c) == variable_ && at_ + 1 < line_.size() && is_digit(line_[at_ + 1])) {
    const std::size_t column = at_;
    int index = 0;
    ok = variable_index(index);
    if (ok) {
      const auto value = variables_.get(index);
      if (!value)
        return diagnosis_.fault(column, "program-parameter",
                                variable_ + std::to_string(index) + " has no value here; set it in the program");
      out = *value;
    }
  } else if (is_letter(c)) {
    ok = function(out);
  } else {
    ok = fault(at_, "a number is missing here");
  }
  --depth_;
  return ok;
}

bool Formula::variable_index(int& out) {
  const std::size_t column = at_++;
  const std::size_t first = at_;
  while (is_digit(peek())) ++at_;
  const auto index = geometry::parse_integer(line_.substr(first, at_ - first));
  if (!index || *index > Variables::highest)
    return diagnosis_.fault(column, "program-parameter",
                            std::string("behind ") + variable_ + " stands a number from 0 to 1999");
  out = static_cast<int>(*index);
  return true;
}

bool Formula::arc_tangent(double& out) {
  const std::size_t column = at_;
  double y = 0.0, x = 0.0;
  skip_blanks();
  if (peek() != '(') return fault(column, "ATAN2 takes (y, x)");
  ++at_;
  if (!sum(y)) return false;
  skip_blanks();
  if (peek() != ',') return fault(at_, "ATAN2 takes (y, x)");
  ++at_;
  if (!sum(x)) return false;
  skip_blanks();
  if (peek() != ')') return fault(at_, "\")\" is missing here");
  ++at_;
  out = std::atan2(y, x) / rad_per_deg;
  return true;
}

bool Formula::function(double& out) {
  const std::size_t column = at_;
  std::string name;
  while (is_letter(peek()) || (!name.empty() && is_digit(peek()))) name += upper_case(line_[at_++]);
  if (name == "ATAN2") return arc_tangent(out);
  double x = 0.0;
  if (name == "PI") {
    out = std::numbers::pi;
    return true;
  }
  if (!factor(x)) return false;
  if (const auto common = common_function(name, x))
    out = *common;
  else if (name == "POT" || name == "SQ")
    out = x * x;
  else
    return fault(column, in_quotes(name) + " is not a function that is known here");
  return std::isfinite(out) || fault(column, "the result of " + name + " is not a finite number");
}

}  // namespace volute::sim
