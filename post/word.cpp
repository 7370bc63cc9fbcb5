#include "post/word.hpp"

#include <array>
#include <cmath>
#include <cstring>

#include "geometry/check.hpp"

namespace volute::post {

namespace {

constexpr std::array<double, 13> powers_of_ten = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};

/// "00" to "99", one after the other.
constexpr std::array<char, 200> digit_pairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t k = 0; k < 100; ++k) {
    pairs[2 * k] = static_cast<char>('0' + k / 10);
    pairs[2 * k + 1] = static_cast<char>('0' + k % 10);
  }
  return pairs;
}();

}  // namespace

std::int64_t scaled(double value, int decimals) {
  const double units = value * powers_of_ten[static_cast<std::size_t>(decimals)];
  VOLUTE_CHECK(std::abs(units) < 9e18, value, decimals);
  const auto whole = static_cast<std::int64_t>(units);
  const double rest = units - static_cast<double>(whole);  // exact
  return whole + static_cast<std::int64_t>(rest >= 0.5) - static_cast<std::int64_t>(rest <= -0.5);
}

// Digits from the last to the first, two at a time: a division waits for the one before it.
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
  const auto two_digits = [&] {
    const std::uint64_t hundredth = left / 100;
    at -= 2;
    std::memcpy(at, digit_pairs.data() + 2 * (left - 100 * hundredth), 2);
    left = hundredth;
  };
  int decimals = format.decimals;
  for (; decimals >= 2; decimals -= 2) two_digits();
  if (decimals == 1) digit();
  if (format.decimals > 0 || format.force_point) *--at = '.';
  while (left >= 100) two_digits();
  if (left >= 10)
    two_digits();
  else
    digit();
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
