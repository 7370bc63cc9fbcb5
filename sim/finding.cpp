#include "sim/finding.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

namespace volute::sim {

int severity(const std::string& kind) {
  static constexpr std::array<std::string_view, 8> order{"collision", "gouge", "limit",        "travel",
                                                         "uncut",     "tilt",  "disagreement", "clearance"};
  return static_cast<int>(std::find(order.begin(), order.end(), kind) - order.begin());
}

void sort_by_severity(std::vector<Finding>& findings) {
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return std::tuple(severity(a.kind), a.line, a.time_s) < std::tuple(severity(b.kind), b.line, b.time_s);
  });
}

}  // namespace volute::sim
