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
  /// `first_line`: the number of the line that `text` begins with. `is_one_line`: more text follows behind its end.
  explicit TextCursor(std::string_view text, std::size_t first_line = 1, bool is_one_line = false)
      : text_(text), first_line_(first_line), is_one_line_(is_one_line) {}

  /// The next word (no blank inside), across line ends; empty at the end of the text.
  std::string_view word();
  /// The rest of the line, the line end eaten.
  std::string_view rest_of_line();
  /// The next word without eating it.
  [[nodiscard]] std::string_view peek() const;
  /// Number of the line in which the last word stood, from 1. Counted when asked: only messages need it.
  [[nodiscard]] std::size_t line() const;
  [[nodiscard]] bool at_end() const { return peek().empty(); }
  /// The last word reached the very end of the file: it may be the half of one.
  [[nodiscard]] bool was_cut() const { return left() == 0 && !is_one_line_; }
  /// Bytes not read yet.
  [[nodiscard]] std::size_t left() const { return text_.size() - position_; }
  [[nodiscard]] std::size_t position() const { return position_; }

  /// Errors, each "name:line: ...": mesh-truncated at the end of the file, mesh-not-finite for nan and inf, mesh-syntax
  /// otherwise.
  Result<double> number(const std::string& name, const char* what);
  Result<std::int64_t> integer(const std::string& name, const char* what);

 private:
  std::string_view text_;
  tl::unexpected<Error> misfit(std::string_view word, const std::string& name, const char* what,
                               const char* kind) const;
  std::size_t first_line_ = 1;
  bool is_one_line_ = false;
  std::size_t position_ = 0;
  std::size_t word_start_ = 0;
};

/// Equal but for the case of ASCII letters; `lower` is in lower case.
bool same_word(std::string_view word, std::string_view lower);
/// "name:line: "
std::string place(const std::string& name, const TextCursor& cursor);

}  // namespace volute::geometry
