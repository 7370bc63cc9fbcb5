// What the verifier found wrong, in the user's words.
#pragma once

#include <cstdint>
#include <string>

namespace volute::sim {

/// report.json "findings". Sorted by severity: collision, gouge, limit, travel, uncut, tilt, disagreement.
struct Finding {
  std::string kind;
  std::int64_t line = 0;     ///< of the program; key "block" in the report
  double time_s = 0.0;
  std::string axis_or_pair;
  double value = 0.0, limit = 0.0;  ///< mm, deg, or the axis's unit
  std::string text;          ///< one line
};

}  // namespace volute::sim
