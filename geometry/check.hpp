// VOLUTE_CHECK(condition, value, ...): a programmer's mistake. Stays on in every build, prints the values, ends the
// program.
#pragma once

#include <sstream>
#include <string>

namespace volute::geometry {

/// Prints "file:line: check failed: text [values]" to standard error and ends the program with exit status 3.
[[noreturn]] void check_failed(const char* file, int line, const char* text, const std::string& values);

template <class... Values>
std::string values_text(const Values&... values) {
  std::ostringstream out;
  out.precision(17);
  ((out << ' ' << values), ...);
  return out.str();
}

}  // namespace volute::geometry

#define VOLUTE_CHECK(condition, ...)                                                               \
  (static_cast<bool>(condition) ? static_cast<void>(0)                                             \
                                : ::volute::geometry::check_failed(__FILE__, __LINE__, #condition, \
                                                                   ::volute::geometry::values_text(__VA_ARGS__)))
