#include "geometry/text_cursor.hpp"

#include <algorithm>

#include "geometry/number_text.hpp"

namespace volute::geometry {

namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
char lowered(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool says_not_finite(std::string_view word) {
  while (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  return same_word(word.substr(0, 3), "nan") || same_word(word.substr(0, 3), "inf") || word.starts_with("1.#");
}

/// A word fit for a message: short, and no control characters.
std::string in_quotes(std::string_view word) {
  std::string text = "\"";
  for (const char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > 24 ? "...\"" : "\"");
}

}  // namespace

std::string_view TextCursor::word() {
  while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
  word_start_ = position_;
  while (position_ < text_.size() && !is_blank(text_[position_])) ++position_;
  return text_.substr(word_start_, position_ - word_start_);
}

std::string_view TextCursor::rest_of_line() {
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  const std::string_view rest = text_.substr(position_, end - position_);
  position_ = std::min(end + 1, text_.size());
  return rest;
}

std::string_view TextCursor::peek() const {
  TextCursor ahead = *this;
  return ahead.word();
}

std::size_t TextCursor::line() const {
  const std::string_view before = text_.substr(0, word_start_);
  return first_line_ + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

tl::unexpected<Error> TextCursor::misfit(std::string_view word, const std::string& name, const char* what,
                                         const char* kind) const {
  if (was_cut())
    return bad_input("mesh-truncated",
                     place(name, *this) + "the file ends where " + what + " should stand; copy or export it again");
  if (says_not_finite(word))
    return bad_input("mesh-not-finite", place(name, *this) + what + " is " + in_quotes(word) +
                                            "; every coordinate must be a finite number");
  return bad_input("mesh-syntax", place(name, *this) + (word.empty() ? std::string("nothing") : in_quotes(word)) +
                                      " stands where " + what + " (" + kind + ") should; export the file again");
}

Result<double> TextCursor::number(const std::string& name, const char* what) {
  const std::string_view text = word();
  if (const auto value = parse_number(text)) return *value;
  return misfit(text, name, what, "a number");
}

Result<std::int64_t> TextCursor::integer(const std::string& name, const char* what) {
  const std::string_view text = word();
  if (const auto value = parse_integer(text)) return *value;
  return misfit(text, name, what, "a whole number");
}

bool same_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return lowered(a) == b; });
}

std::string place(const std::string& name, const TextCursor& cursor) {
  return name + ":" + std::to_string(cursor.line()) + ": ";
}

}  // namespace volute::geometry
