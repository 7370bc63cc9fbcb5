// Numbers of a program as words. Private to post.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace volute::post {

/// How one kind of number is printed: fixed decimals, a sign before positive ones or not, a point behind whole ones or
/// not.
struct NumberFormat {
  int decimals = 3;
  bool plus_sign = false;
  bool force_point = false;
};

/// `value` in units of the last printed digit, rounded half away from zero: two words are the same text when these are
/// equal. Requires: |value| * 10^decimals < 9e18.
std::int64_t scaled(double value, int decimals);
/// Appends `units` of the last digit as a decimal number, never "-0".
/// Done on integers: the exact conversion of a double takes some 100 ns, this one 10, and a block has six.
void append_scaled(std::string& text, std::int64_t units, const NumberFormat& format);
/// Both in one.
std::string number_text(double value, const NumberFormat& format);

}  // namespace volute::post
