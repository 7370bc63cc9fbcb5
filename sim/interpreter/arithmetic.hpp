// What the arithmetic of all dialects has in common. Private to sim/interpreter.
#pragma once

#include <numbers>
#include <optional>
#include <string_view>

namespace volute::sim {

constexpr double rad_per_deg = std::numbers::pi / 180.0, rad_s_per_rpm = std::numbers::pi / 30.0;
constexpr double turn_rad = 2.0 * std::numbers::pi;
/// Brackets and signs within each other before a text is refused.
constexpr int nesting_most = 64;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr char upper_case(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr bool is_letter(char c) { return upper_case(c) >= 'A' && upper_case(c) <= 'Z'; }

/// ABS ACOS ASIN COS SIN SQRT TAN of x, angles in degrees. Nothing: `name` (upper case) is none of them.
std::optional<double> common_function(std::string_view name, double x);

}  // namespace volute::sim
