// Arithmetic as Siemens and Heidenhain write it: + - * / ( ), functions, numbered variables (R1, Q1).
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

#include "sim/interpreter/source.hpp"

namespace volute::sim {

/// Numbered variables of a program: R0 .. R999, Q0 .. Q1999.
class Variables {
 public:
  static constexpr int highest = 1999;
  [[nodiscard]] std::optional<double> get(int index) const {
    const auto found = values_.find(index);
    return found == values_.end() ? std::nullopt : std::optional<double>(found->second);
  }
  void set(int index, double value) { values_[index] = value; }

 private:
  std::map<int, double> values_;
};

/// Reads one formula from a line. Angles are in degrees. Functions take their argument with or without brackets (SIN
/// Q1, SIN(R1)). Errors: program-expression, program-parameter.
class Formula {
 public:
  Formula(std::string_view line, std::size_t at, char variable, const Variables& variables, Diagnosis& diagnosis)
      : line_(line), at_(at), variable_(variable), variables_(variables), diagnosis_(diagnosis) {}

  /// sum of products
  bool sum(double& out);
  /// a number, a variable, a function or a bracketed sum, with signs
  bool factor(double& out);
  /// The number behind the variable's letter.
  bool variable_index(int& out);
  void skip_blanks();
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] char peek() const { return at_ < line_.size() ? line_[at_] : '\0'; }

 private:
  bool product(double& out);
  bool function(double& out);
  bool arc_tangent(double& out);
  bool fault(std::size_t column, const std::string& text) {
    return diagnosis_.fault(column, "program-expression", text);
  }

  std::string_view line_;
  std::size_t at_;
  char variable_;
  const Variables& variables_;
  Diagnosis& diagnosis_;
  int depth_ = 0;
};

}  // namespace volute::sim
