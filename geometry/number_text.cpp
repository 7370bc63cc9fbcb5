#include "geometry/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::geometry {

namespace {

/// Room for every double in fixed notation with 12 decimals: 309 + 1 + 12 + sign.
constexpr std::size_t text_room = 400;

bool shows_only_zeros(std::string_view text) { return text.find_first_not_of("-0.") == std::string_view::npos; }

template <class Number>
std::optional<Number> parse_whole(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  Number value{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> value = parse_whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parse_integer(std::string_view text) { return parse_whole<std::int64_t>(text); }

void append_fixed(std::string& out, double value, int decimals) {
  VOLUTE_CHECK(std::isfinite(value) && decimals >= 0 && decimals <= 12, value, decimals);
  std::array<char, text_room> room;
  const auto [end, status] =
      std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::fixed, decimals);
  VOLUTE_CHECK(status == std::errc{}, value);
  std::string_view text(room.data(), static_cast<std::size_t>(end - room.data()));
  if (text.front() == '-' && shows_only_zeros(text)) text.remove_prefix(1);
  out.append(text);
}

std::string fixed_text(double value, int decimals) {
  std::string text;
  append_fixed(text, value, decimals);
  return text;
}

std::string shortest_text(double value) {
  if (value == 0.0) return "0";
  std::array<char, text_room> room;
  const auto [end, status] = std::to_chars(room.data(), room.data() + room.size(), value);
  VOLUTE_CHECK(status == std::errc{}, value);
  return {room.data(), end};
}

std::string short_text(double value, int significant) {
  if (value == 0.0) return "0";
  std::array<char, text_room> room;
  const auto [end, status] =
      std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::general, significant);
  VOLUTE_CHECK(status == std::errc{}, value);
  return {room.data(), end};
}

}  // namespace volute::geometry
