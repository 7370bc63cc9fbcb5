#include "post/cl_statement.hpp"

#include <algorithm>
#include <cctype>

#include "geometry/number_text.hpp"

namespace volute::post {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::vector<ClItem> split_items(std::string_view text) {
  std::vector<ClItem> items;
  std::size_t at = 0;
  while (at < text.size()) {
    if (text[at] == ',' || is_blank(text[at])) {
      ++at;
      continue;
    }
    const bool quoted = text[at] == '\'';
    std::size_t end = quoted ? text.find('\'', at + 1) : text.find_first_of(", \t\r", at);
    end = std::min(end, text.size());
    const std::string_view word = quoted ? text.substr(at + 1, end - at - 1) : text.substr(at, end - at);
    items.push_back({capitals(word), quoted ? std::nullopt : geometry::parse_number(word)});
    at = quoted ? end + 1 : end;
  }
  return items;
}

}  // namespace

std::vector<double> ClStatement::numbers() const {
  std::vector<double> values;
  for (const ClItem& item : items)
    if (item.number) values.push_back(*item.number);
  return values;
}

bool ClStatement::has(std::string_view word) const {
  return std::any_of(items.begin(), items.end(), [&](const ClItem& item) { return item.word == word; });
}

std::optional<double> ClStatement::number_after(std::string_view word) const {
  for (std::size_t k = 0; k + 1 < items.size(); ++k)
    if (items[k].word == word) return items[k + 1].number;
  return std::nullopt;
}

std::optional<std::string_view> ClLexer::next_line() {
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = rest_.find('\n');
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++line_;
  return line;
}

std::optional<ClStatement> ClLexer::next() {
  std::string joined;
  std::int64_t first_line = 0;
  while (const auto line = next_line()) {
    std::string_view text = trimmed(line->substr(0, line->find("$$")));
    const bool continues = !text.empty() && text.back() == '$';
    if (continues) text = trimmed(text.substr(0, text.size() - 1));
    if (joined.empty()) first_line = line_;
    joined += text;
    if (continues || joined.empty()) continue;
    break;
  }
  if (joined.empty()) return std::nullopt;
  const std::size_t slash = joined.find('/');
  ClStatement statement;
  statement.line = first_line;
  statement.major = capitals(joined.substr(0, slash));
  statement.major.erase(std::remove_if(statement.major.begin(), statement.major.end(), is_blank),
                        statement.major.end());
  if (slash != std::string::npos) statement.text = trimmed(std::string_view(joined).substr(slash + 1));
  statement.items = split_items(statement.text);
  return statement;
}

}  // namespace volute::post
