// Words of a text file, one after the other, with the line number for messages. Internal to `geometry`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/result.hpp"

namespace volute::geometry {

class TextCursor {
 public:
  /// `first_line`: the number of the line that `text` begins with.
  explicit TextCursor(std::string_view text, std::size_t first_line = 1) : text_(text), first_line_(first_line) {}

  /// The next word (no blank inside), across line ends; empty at the end of the text.
  std::string_view word();
  /// The rest of the line, the line end eaten.
  std::string_view rest_of_line();
  /// The next word without eating it.
  [[nodiscard]] std::string_view peek() const;
  /// Number of the line in which the last word stood, from 1. Counted when asked: only messages need it.
  [[nodiscard]] std::size_t line() const;
  [[nodiscard]] bool at_end() const { return peek().empty(); }
  /// Bytes not read yet.
  [[nodiscard]] std::size_t left() const { return text_.size() - position_; }
  [[nodiscard]] std::size_t position() const { return position_; }

  /// Errors, each "name:line: ...": mesh-truncated at the end of the text, mesh-not-finite for nan and inf, mesh-syntax
  /// otherwise.
  Result<double> number(const std::string& name, const char* what);
  Result<std::int64_t> integer(const std::string& name, const char* what);

 private:
  std::string_view text_;
  std::size_t first_line_ = 1;
  std::size_t position_ = 0;
  std::size_t word_start_ = 0;
};

/// Equal but for the case of ASCII letters; `lower` is in lower case.
bool same_word(std::string_view word, std::string_view lower);
/// "name:line: "
std::string place(const std::string& name, const TextCursor& cursor);

}  // namespace volute::geometry
