// LinuxCNC's O-words: subprograms, conditions and loops. They move the place where the text is read.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/interpreter/source.hpp"
#include "sim/interpreter/word_lexer.hpp"

namespace volute::sim {

/// Errors: program-oword, program-endless.
class OwordFlow {
 public:
  OwordFlow(Source& source, WordLexer& lexer, Diagnosis& diagnosis)
      : source_(source), lexer_(lexer), diagnosis_(diagnosis), frames_(1) {}

  /// Carries out the O-word line whose 'O' stands at `at`.
  bool run(std::string_view line, std::size_t at);
  /// To be told when a motion came, so that loops without any are noticed.
  void motion_came() { idle_jumps_ = 0; }
  [[nodiscard]] bool inside_call() const { return frames_.size() > 1; }

 private:
  struct Loop {
    std::string label;
    LineMark start;      ///< of the loop's first line
    bool until = false;  ///< do ... while
    std::int64_t remaining = 0;
  };
  struct Frame {
    std::string label;
    LineMark back;
    std::vector<Loop> loops;
  };
  struct Line {
    std::string label, keyword;
    std::size_t at = 0;  ///< behind the keyword
  };
  bool parse(std::string_view line, std::size_t at, Line& out);
  bool condition(std::string_view line, std::size_t at, bool& out);
  /// Reads on to a line with this label and one of the keywords.
  bool skip_to(const std::string& label, std::initializer_list<std::string_view> keywords, std::string_view& line,
               Line& found);
  bool begin_sub(const Line& word);
  bool call(std::string_view line, const Line& word);
  bool leave(const Line& word);
  bool begin_if(std::string_view line, Line word);
  bool loop(std::string_view line, const Line& word);
  bool begin_while(std::string_view line, const Line& word);
  bool begin_repeat(std::string_view line, const Line& word);
  bool end_loop(const Line& word);
  bool leave_loop(const Line& word);
  bool jump(LineMark mark);
  bool fault(const std::string& text) { return diagnosis_.fault(column_, "program-oword", text); }
  Loop* innermost(const std::string& label);

  Source& source_;
  WordLexer& lexer_;
  Diagnosis& diagnosis_;
  std::map<std::string, LineMark> subs_;
  std::vector<Frame> frames_;
  std::int64_t idle_jumps_ = 0, jumps_ = 0;
  std::size_t column_ = 0;
};

}  // namespace volute::sim
