// Statements of CL data: a major word, then words and numbers. Private to post.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/result.hpp"

namespace volute::post {

/// What stands behind the slash: a word in capitals, or a number.
struct ClItem {
  std::string word;
  std::optional<double> number;
};

struct ClStatement {
  std::string major;          ///< in capitals, blanks taken out
  std::string text;           ///< everything behind the slash, as it stands
  std::vector<ClItem> items;  ///< the same split at commas and blanks; texts in quotes are one word
  std::int64_t line = 0;      ///< where it starts, from 1

  [[nodiscard]] std::vector<double> numbers() const;
  [[nodiscard]] bool has(std::string_view word) const;
  /// The number that follows a word ("LENGTH, 120"), if there is one.
  [[nodiscard]] std::optional<double> number_after(std::string_view word) const;
};

/// Splits text into statements: `$$` starts a comment, `$` at a line's end continues it, blank lines are left out.
class ClLexer {
 public:
  explicit ClLexer(std::string_view text) : rest_(text) {}
  /// The next statement, or nothing at the end.
  std::optional<ClStatement> next();

 private:
  std::optional<std::string_view> next_line();

  std::string_view rest_;
  std::int64_t line_ = 0;
};

}  // namespace volute::post
