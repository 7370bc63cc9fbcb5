#include "sim/interpreter/source.hpp"

#include <algorithm>

namespace volute::sim {

bool Diagnosis::fault(std::size_t column, std::string_view code, const std::string& text) {
  return fault_at(source_.line(), column, code, text);
}

bool Diagnosis::fault_at(std::int64_t line, std::size_t column, std::string_view code, const std::string& text) {
  if (error_) return false;
  const std::string place = source_.file_name() + ":" + std::to_string(line) + ":" + std::to_string(column + 1) + ": ";
  error_ = geometry::Error{geometry::ErrorKind::bad_input, std::string(code), place + text};
  return false;
}

void Diagnosis::warn_once(std::string_view key, const std::string& text) {
  if (std::find(warned_.begin(), warned_.end(), key) != warned_.end()) return;
  warned_.emplace_back(key);
  warnings_.push_back(source_.file_name() + ":" + std::to_string(source_.line()) + ": " + text);
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string out = "\"";
  for (const char c : text.substr(0, longest)) out += (c >= ' ' && c <= '~') ? c : '?';
  if (text.size() > longest) out += "...";
  return out + "\"";
}

}  // namespace volute::sim
