// M98 and M99: subprograms that stand in the same file behind their O number.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "sim/interpreter/source.hpp"

namespace volute::sim {

/// Errors: program-subprogram.
class FanucFlow {
 public:
  FanucFlow(Source& source, Diagnosis& diagnosis, std::string_view text)
      : source_(source), diagnosis_(diagnosis), text_(text) {}

  /// M98 P: up to four digits are the program; with more, the digits before the last four are how often. `times`: the L
  /// word or 1.
  bool call(std::size_t column, std::int64_t p, std::int64_t times);
  /// M99 of a subprogram. `main`: it stood in the main program instead.
  bool leave(bool& main);
  [[nodiscard]] bool inside_call() const { return !frames_.empty(); }

 private:
  struct Frame {
    LineMark start, back;
    std::int64_t remaining = 0;
  };
  void index_programs();

  Source& source_;
  Diagnosis& diagnosis_;
  std::string_view text_;
  bool indexed_ = false;
  std::map<std::int64_t, LineMark> programs_;
  std::vector<Frame> frames_;
  std::int64_t calls_ = 0;
};

}  // namespace volute::sim
