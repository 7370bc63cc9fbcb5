// The text of a program as lines with numbers, and how a fault in it is said.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/result.hpp"

namespace volute::sim {

/// A place to come back to: the offset of a line's first character, and that line's number.
struct LineMark {
  std::size_t offset = 0;
  std::int64_t line = 1;
  friend bool operator==(const LineMark&, const LineMark&) = default;
};

/// Editors put the mark of UTF-8 before a text; it is no part of the program.
std::string_view without_byte_order_mark(std::string_view text);

/// Hands out the lines of a text. Keeps no copy.
class Source {
 public:
  Source(std::string_view text, std::string file_name)
      : text_(without_byte_order_mark(text)), file_name_(std::move(file_name)) {}

  /// The next line without its end (LF or CR LF); nothing at the end of the text.
  std::optional<std::string_view> next_line() {
    if (at_.offset >= text_.size()) return std::nullopt;
    here_ = at_;
    std::size_t end = text_.find('\n', at_.offset);
    if (end == std::string_view::npos) end = text_.size();
    std::string_view line = text_.substr(at_.offset, end - at_.offset);
    at_ = {end + 1, at_.line + 1};
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }
  void go_to(LineMark mark) { at_ = mark; }
  /// Where the line that next_line gave last begins.
  [[nodiscard]] LineMark here() const { return here_; }
  /// Where the line after it begins.
  [[nodiscard]] LineMark after() const { return at_; }
  [[nodiscard]] std::int64_t line() const { return here_.line; }
  [[nodiscard]] const std::string& file_name() const { return file_name_; }
  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] bool at_end() const { return at_.offset >= text_.size(); }

 private:
  std::string_view text_;
  std::string file_name_;
  LineMark at_, here_;
};

/// The first fault found, and what a person should know although the program runs. Every function of this folder that
/// can meet a fault returns false when it did; the fault is here then.
class Diagnosis {
 public:
  explicit Diagnosis(const Source& source) : source_(source) {}

  /// Notes "file:line:column: text" and returns false. `column` counts from 0.
  bool fault(std::size_t column, std::string_view code, const std::string& text);
  /// As fault, for a text that the fault's maker did not see whole.
  bool fault_at(std::int64_t line, std::size_t column, std::string_view code, const std::string& text);
  /// Notes a warning once for each `key`.
  void warn_once(std::string_view key, const std::string& text);

  [[nodiscard]] bool ok() const { return !error_; }
  [[nodiscard]] const geometry::Error& error() const { return *error_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  const Source& source_;
  std::optional<geometry::Error> error_;
  std::vector<std::string> warnings_;
  std::vector<std::string> warned_;
};

/// A bounded copy of a piece of program text for a message: control characters shown as '?', at most 40 characters.
std::string in_quotes(std::string_view text);

}  // namespace volute::sim
