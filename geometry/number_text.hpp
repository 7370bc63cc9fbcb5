// Numbers as text without locale, exponent surprises or "-0": the only way numbers become text or come from it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace volute::geometry {

/// The decimal number that `text` holds from its first to its last character; nothing when any character is left
/// over, when the text is empty, or when the value is not finite. A leading '+' is accepted.
std::optional<double> parse_number(std::string_view text);
std::optional<std::int64_t> parse_integer(std::string_view text);

/// `value` with exactly `decimals` digits behind the point, correctly rounded from the exact value of the double
/// (std::to_chars), never "-0" and never an exponent. Requires: value finite, 0 <= decimals <= 12.
std::string fixed_text(double value, int decimals);
/// Appends the same to `out` without allocating anything else.
void append_fixed(std::string& out, double value, int decimals);

/// The shortest text that reads back as the same double (std::to_chars), "-0" written as "0". For reports and messages.
std::string shortest_text(double value);
/// At most `significant` digits, for messages that people read: 0.0123457, 1234.57.
std::string short_text(double value, int significant = 6);

}  // namespace volute::geometry
