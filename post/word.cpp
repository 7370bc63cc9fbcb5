#include "post/word.hpp"

#include <array>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::post {

namespace {

constexpr std::array<double, 13> powers_of_ten = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};

}  // namespace

std::int64_t scaled(double value, int decimals) {
  const double units = value * powers_of_ten[static_cast<std::size_t>(decimals)];
  VOLUTE_CHECK(std::abs(units) < 9e18, value, decimals);
  const auto whole = static_cast<std::int64_t>(units);
  const double rest = units - static_cast<double>(whole);  // exact
  return whole + static_cast<std::int64_t>(rest >= 0.5) - static_cast<std::int64_t>(rest <= -0.5);
}

// Digits from the last to the first.
void append_scaled(std::string& text, std::int64_t units, const NumberFormat& format) {
  std::array<char, 40> room;
  char* const end = room.data() + room.size();
  char* at = end;
  auto left = units < 0 ? 0 - static_cast<std::uint64_t>(units) : static_cast<std::uint64_t>(units);
  const auto digit = [&] {
    const std::uint64_t tenth = left / 10;
    *--at = static_cast<char>('0' + static_cast<char>(left - 10 * tenth));
    left = tenth;
  };
  for (int k = 0; k < format.decimals; ++k) digit();
  if (format.decimals > 0 || format.force_point) *--at = '.';
  do digit();
  while (left > 0);
  if (units < 0) *--at = '-';
  if (units >= 0 && format.plus_sign) *--at = '+';
  text.append(at, static_cast<std::size_t>(end - at));
}

std::string number_text(double value, const NumberFormat& format) {
  std::string text;
  append_scaled(text, scaled(value, format.decimals), format);
  return text;
}

}  // namespace volute::post
