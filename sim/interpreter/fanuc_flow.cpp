#include "sim/interpreter/fanuc_flow.hpp"

#include <string>

#include "geometry/number_text.hpp"

namespace volute::sim {

namespace {
constexpr std::size_t fanuc_calls_deep_most = 10;
constexpr std::int64_t fanuc_calls_most = 1'000'000;
}  // namespace

void FanucFlow::index_programs() {
  indexed_ = true;
  Source all(text_, source_.file_name());
  while (const auto line = all.next_line()) {
    const std::size_t at = line->find_first_not_of(" \t");
    if (at == std::string_view::npos || ((*line)[at] != 'O' && (*line)[at] != 'o')) continue;
    std::size_t end = at + 1;
    while (end < line->size() && (*line)[end] >= '0' && (*line)[end] <= '9') ++end;
    const auto number = geometry::parse_integer(line->substr(at + 1, end - at - 1));
    if (number) programs_.emplace(*number, all.after());
  }
}

bool FanucFlow::call(std::size_t column, std::int64_t p, std::int64_t times) {
  const auto fault = [&](const std::string& text) { return diagnosis_.fault(column, "program-subprogram", text); };
  if (!indexed_) index_programs();
  constexpr std::int64_t number_range = 10'000;
  if (p >= number_range && !programs_.contains(p)) {
    times = p / number_range;
    p %= number_range;
  }
  const auto found = programs_.find(p);
  if (found == programs_.end()) return fault("subprogram O" + std::to_string(p) + " is not in this file; append it");
  if (times < 1) return fault("a subprogram is called at least once; L is " + std::to_string(times));
  if (frames_.size() == fanuc_calls_deep_most) return fault("subprograms call each other more than 10 deep");
  calls_ += times;
  if (calls_ > fanuc_calls_most)
    return diagnosis_.fault(column, "program-endless", "subprograms were called a million times");
  frames_.push_back({found->second, source_.after(), times});
  source_.go_to(found->second);
  return true;
}

bool FanucFlow::leave(bool& main) {
  main = frames_.empty();
  if (main) return true;
  Frame& frame = frames_.back();
  if (--frame.remaining > 0) {
    source_.go_to(frame.start);
    return true;
  }
  source_.go_to(frame.back);
  frames_.pop_back();
  return true;
}

}  // namespace volute::sim
