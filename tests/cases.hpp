// How many random cases a property is tried on.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "geometry/number_text.hpp"

namespace volute {

/// The environment's VOLUTE_CASES, at least 1; else (not set, or no whole number) `usual`.
inline int cases(int usual) {
  const char* text = std::getenv("VOLUTE_CASES");
  const auto asked = text != nullptr ? geometry::parse_integer(text) : std::nullopt;
  return asked ? static_cast<int>(std::max<std::int64_t>(1, *asked)) : usual;
}

}  // namespace volute
