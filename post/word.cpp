#include "post/word.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::post {

namespace {

constexpr std::array<double, 13> powers_of_ten = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};

}  // namespace

std::int64_t scaled(double value, int decimals) {
  const double units = value * powers_of_ten[static_cast<std::size_t>(decimals)];
  VOLUTE_CHECK(std::abs(units) < 9e18, value, decimals);
  return std::llround(units);
}

void append_scaled(std::string& text, std::int64_t units, const NumberFormat& format) {
  if (units < 0) text += '-';
  if (units >= 0 && format.plus_sign) text += '+';
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), units < 0 ? -units : units).ptr;
  const auto count = static_cast<std::size_t>(end - digits.data());
  const auto decimals = static_cast<std::size_t>(format.decimals);
  const std::size_t whole = count > decimals ? count - decimals : 0;
  whole > 0 ? text.append(digits.data(), whole) : text.append(1, '0');
  if (decimals > 0) {
    text += '.';
    if (count < decimals) text.append(decimals - count, '0');
    text.append(digits.data() + whole, count - whole);
  } else if (format.force_point) {
    text += '.';
  }
}

std::string number_text(double value, const NumberFormat& format) {
  std::string text;
  append_scaled(text, scaled(value, format.decimals), format);
  return text;
}

}  // namespace volute::post
