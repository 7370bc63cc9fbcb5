// One line of a word-address program as words: letter and number.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/interpreter/expression.hpp"
#include "sim/interpreter/parameters.hpp"
#include "sim/interpreter/source.hpp"

namespace volute::sim {

/// A G or M code, times ten: G43.4 is 434.
struct Code {
  int tenths = 0;
  std::uint32_t column = 0;
};

/// The words of one block. Letters other than G and M occur at most once.
class Block {
 public:
  static constexpr std::size_t codes_most = 16;

  void clear() { present = used = point = 0, g_count = m_count = 0; }
  [[nodiscard]] bool has(char letter) const { return ((present >> index(letter)) & 1U) != 0; }
  [[nodiscard]] double value(char letter) const { return values[index(letter)]; }
  [[nodiscard]] std::size_t column(char letter) const { return columns[index(letter)]; }
  [[nodiscard]] bool has_point(char letter) const { return ((point >> index(letter)) & 1U) != 0; }
  /// Marks the word as understood; every word has to be by the end of its block.
  bool use(char letter) {
    used |= 1U << index(letter);
    return has(letter);
  }
  [[nodiscard]] bool empty() const { return present == 0 && g_count == 0 && m_count == 0; }
  static std::size_t index(char letter) { return static_cast<std::size_t>(letter - 'A'); }

  std::uint32_t present = 0, used = 0, point = 0;
  std::array<double, 26> values{};
  std::array<std::uint32_t, 26> columns{};
  std::array<Code, codes_most> g{}, m{};
  std::size_t g_count = 0, m_count = 0;
};

struct WordStyle {
  bool linuxcnc = false;  ///< ';' starts a comment, nested '(' is a fault, never-set numbers are 0
};

/// Splits lines into words. Comments, block numbers and '/' are dealt with here; parameters are set here.
/// Errors: program-syntax, program-expression, program-parameter.
class WordLexer {
 public:
  WordLexer(WordStyle style, Parameters& parameters, ValueReader::SystemParameter system, Diagnosis& diagnosis)
      : style_(style), parameters_(parameters), system_(std::move(system)), diagnosis_(diagnosis) {}

  /// Reads `line` from `at` on into `block`.
  bool read(std::string_view line, std::size_t at, Block& block);
  /// Behind blanks, '/' and a block number: where the words of the line begin.
  bool skip_prefix(std::string_view line, std::size_t& at);
  /// Moves over blanks and comments.
  bool skip_comments(std::string_view line, std::size_t& at);
  [[nodiscard]] ValueReader values(std::string_view line, std::size_t at) {
    return {line, at, parameters_, system_, style_.linuxcnc, diagnosis_};
  }
  Parameters& parameters() { return parameters_; }

 private:
  struct Assignment {
    int index = 0;
    std::string_view name;
    double value = 0.0;
  };
  bool word(std::string_view line, std::size_t& at, Block& block);
  bool code(Code code, double value, bool is_g, Block& block);
  bool assignment(std::string_view line, std::size_t& at);
  bool fault(std::size_t column, const std::string& text) { return diagnosis_.fault(column, "program-syntax", text); }

  WordStyle style_;
  Parameters& parameters_;
  ValueReader::SystemParameter system_;
  Diagnosis& diagnosis_;
  std::vector<Assignment> assignments_;
};

}  // namespace volute::sim
