// Real values of word-address programs: numbers, parameters, [expressions] and functions.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

#include "sim/interpreter/parameters.hpp"
#include "sim/interpreter/source.hpp"

namespace volute::sim {

/// The plain decimal number that starts at `at` (optional sign, digits, at most one point, no exponent). Moves `at`
/// behind it. `point` tells whether it holds a decimal point. Nothing: no number starts there, and `at` has not moved.
std::optional<double> read_plain_number(std::string_view line, std::size_t& at, bool& point);

/// Reads values from one line. Blanks may stand anywhere between tokens. Angles are in degrees.
/// Errors: program-expression, program-parameter.
class ValueReader {
 public:
  /// A system parameter's value (positions and the like); nothing: it has none. May be empty.
  using SystemParameter = std::function<std::optional<double>(int index)>;

  ValueReader(std::string_view line, std::size_t at, const Parameters& parameters, const SystemParameter& system,
              bool unset_is_zero, Diagnosis& diagnosis)
      : line_(line),
        at_(at),
        parameters_(parameters),
        system_(system),
        unset_is_zero_(unset_is_zero),
        diagnosis_(diagnosis) {}

  /// number | #parameter | [expression] | FUNCTION[expression] | -value
  bool value(double& out);
  /// [expression]; Requires nothing: a missing bracket is a fault.
  bool bracketed(double& out);
  /// The index behind '#': a number, or a value.
  bool parameter_index(int& out);
  /// The name in <...>; `out` points into the line.
  bool name(std::string_view& out);
  void skip_blanks();
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] char peek() const { return at_ < line_.size() ? line_[at_] : '\0'; }

 private:
  bool binary(int least_precedence, double& out);
  bool function(double& out);
  bool parameter(double& out);
  bool exists(double& out);
  bool apply(std::string_view name, std::size_t column, double argument, double& out);
  bool arc_tangent(double& out);
  int operator_here(std::string_view& name) const;
  bool fault(std::size_t column, const std::string& text) {
    return diagnosis_.fault(column, "program-expression", text);
  }

  std::string_view line_;
  std::size_t at_;
  const Parameters& parameters_;
  const SystemParameter& system_;
  bool unset_is_zero_;
  Diagnosis& diagnosis_;
  int depth_ = 0;
};

}  // namespace volute::sim
