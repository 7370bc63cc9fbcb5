#include "sim/interpreter/oword.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "sim/interpreter/arithmetic.hpp"

namespace volute::sim {

namespace {
constexpr std::size_t oword_calls_most = 64;
/// Loops and calls in a row without a single motion, and in the whole program.
constexpr std::int64_t idle_jumps_most = 200'000, jumps_most = 10'000'000;

}  // namespace

bool OwordFlow::parse(std::string_view line, std::size_t at, Line& out) {
  column_ = at;
  ValueReader reader = lexer_.values(line, at + 1);
  reader.skip_blanks();
  if (reader.peek() == '<') {
    std::string_view name;
    if (!reader.name(name)) return false;
    out.label = "<" + plain_name(name) + ">";
  } else {
    double number = 0.0;
    if (!reader.value(number)) return false;
    if (number != std::round(number) || std::abs(number) > 1e9)
      return fault("the label behind O is not a whole number");
    out.label = std::to_string(static_cast<std::int64_t>(number));
  }
  reader.skip_blanks();
  out.at = reader.at();
  out.keyword.clear();
  while (out.at < line.size() && is_letter(line[out.at]))
    out.keyword += static_cast<char>(std::tolower(static_cast<unsigned char>(line[out.at++])));
  return true;
}

bool OwordFlow::run(std::string_view line, std::size_t at) {
  Line word;
  if (!parse(line, at, word)) return false;
  const std::string& keyword = word.keyword;
  if (keyword == "sub") return begin_sub(word);
  if (keyword == "call") return call(line, word);
  if (keyword == "endsub" || keyword == "return") return leave(word);
  if (keyword == "if") return begin_if(line, word);
  if (keyword == "elseif" || keyword == "else") {
    // Reached from the branch that was taken: the others are passed over.
    std::string_view found_line;
    Line found;
    return skip_to(word.label, {"endif"}, found_line, found);
  }
  if (keyword == "endif") return true;
  return loop(line, word);
}

bool OwordFlow::loop(std::string_view line, const Line& word) {
  const std::string& keyword = word.keyword;
  if (keyword == "do") {
    frames_.back().loops.push_back({word.label, source_.here(), true, 0});
    return true;
  }
  if (keyword == "while") return begin_while(line, word);
  if (keyword == "repeat") return begin_repeat(line, word);
  if (keyword == "endwhile" || keyword == "endrepeat") return end_loop(word);
  if (keyword == "break" || keyword == "continue") return leave_loop(word);
  return fault("the O-word " + in_quotes(keyword) +
               " is not known; sub, call, return, if, while, do, repeat, break, continue are");
}

bool OwordFlow::condition(std::string_view line, std::size_t at, bool& out) {
  ValueReader reader = lexer_.values(line, at);
  double value = 0.0;
  if (!reader.bracketed(value)) return false;
  out = value != 0.0;
  return true;
}

bool OwordFlow::skip_to(const std::string& label, std::initializer_list<std::string_view> keywords,
                        std::string_view& line, Line& found) {
  const std::int64_t from = source_.line();
  while (const auto next = source_.next_line()) {
    std::size_t at = next->find_first_not_of(" \t/");
    if (at == std::string_view::npos) continue;
    if (((*next)[at] == 'n' || (*next)[at] == 'N') && !lexer_.skip_prefix(*next, at)) return false;
    if (at >= next->size() || ((*next)[at] != 'o' && (*next)[at] != 'O')) continue;
    // A computed label cannot be that of a block that is passed over.
    const std::size_t mark = next->find_first_not_of(" \t", at + 1);
    if (mark == std::string_view::npos || (*next)[mark] == '[' || (*next)[mark] == '#') continue;
    if (!parse(*next, at, found)) return false;
    if (found.label != label || std::find(keywords.begin(), keywords.end(), found.keyword) == keywords.end()) continue;
    line = *next;
    return true;
  }
  return diagnosis_.fault_at(from, column_, "program-oword",
                             "O-word " + label + " is not closed: " + std::string(*keywords.begin()) + " is missing");
}

bool OwordFlow::begin_sub(const Line& word) {
  if (inside_call()) return fault("a subprogram cannot be defined inside another");
  subs_[word.label] = source_.after();
  std::string_view line;
  Line found;
  return skip_to(word.label, {"endsub"}, line, found);
}

bool OwordFlow::call(std::string_view line, const Line& word) {
  const auto sub = subs_.find(word.label);
  if (sub == subs_.end())
    return fault("subprogram " + word.label +
                 " is not defined above in this file; copy it in (other files are not read)");
  if (frames_.size() > oword_calls_most) return fault("subprograms call each other more than 64 deep");
  std::vector<double> arguments;
  std::size_t at = word.at;
  while (true) {
    if (!lexer_.skip_comments(line, at)) return false;
    if (at >= line.size()) break;
    if (line[at] != '[' || arguments.size() == Parameters::local_count) {
      column_ = at;
      return fault("arguments of a call are written [value], at most 30");
    }
    ValueReader reader = lexer_.values(line, at);
    if (!reader.bracketed(arguments.emplace_back())) return false;
    at = reader.at();
  }
  frames_.push_back({word.label, source_.after(), {}});
  lexer_.parameters().enter(arguments);
  return jump(sub->second);
}

bool OwordFlow::leave(const Line& word) {
  if (!inside_call() || frames_.back().label != word.label)
    return fault("O-word " + word.keyword + " stands outside of subprogram " + word.label);
  const LineMark back = frames_.back().back;
  frames_.pop_back();
  lexer_.parameters().leave();
  source_.go_to(back);
  return true;
}

bool OwordFlow::begin_if(std::string_view line, Line word) {
  bool taken = false;
  if (!condition(line, word.at, taken)) return false;
  while (!taken) {
    Line found;
    if (!skip_to(word.label, {"elseif", "else", "endif"}, line, found)) return false;
    if (found.keyword != "elseif") return true;
    if (!condition(line, found.at, taken)) return false;
  }
  return true;
}

OwordFlow::Loop* OwordFlow::innermost(const std::string& label) {
  auto& loops = frames_.back().loops;
  while (!loops.empty() && loops.back().label != label) loops.pop_back();
  return loops.empty() ? nullptr : &loops.back();
}

bool OwordFlow::begin_while(std::string_view line, const Line& word) {
  bool go_on = false;
  if (!condition(line, word.at, go_on)) return false;
  auto& loops = frames_.back().loops;
  const bool known = std::any_of(loops.begin(), loops.end(), [&](const Loop& l) { return l.label == word.label; });
  if (known) {
    const Loop* running = innermost(word.label);
    if (running->until) {
      const LineMark start = running->start;
      loops.pop_back();
      return !go_on || jump(start);
    }
    loops.pop_back();
  }
  if (go_on) {
    loops.push_back({word.label, source_.here(), false, 0});
    return true;
  }
  std::string_view found_line;
  Line found;
  return skip_to(word.label, {"endwhile"}, found_line, found);
}

bool OwordFlow::begin_repeat(std::string_view line, const Line& word) {
  ValueReader reader = lexer_.values(line, word.at);
  double count = 0.0;
  if (!reader.bracketed(count)) return false;
  if (count > static_cast<double>(jumps_most)) return fault("more than 10 million repetitions");
  const auto times = static_cast<std::int64_t>(std::round(std::max(count, 0.0)));
  if (times >= 1) {
    frames_.back().loops.push_back({word.label, source_.after(), false, times});
    return true;
  }
  std::string_view found_line;
  Line found;
  return skip_to(word.label, {"endrepeat"}, found_line, found);
}

bool OwordFlow::end_loop(const Line& word) {
  Loop* loop = innermost(word.label);
  if (loop == nullptr) return fault("O-word " + word.keyword + " has no beginning");
  if (word.keyword == "endwhile") return jump(loop->start);
  if (--loop->remaining > 0) return jump(loop->start);
  frames_.back().loops.pop_back();
  return true;
}

bool OwordFlow::leave_loop(const Line& word) {
  Loop* loop = innermost(word.label);
  if (loop == nullptr) return fault("O-word " + word.keyword + " stands outside of loop " + word.label);
  const bool until = loop->until;
  const std::string label = loop->label;
  std::string_view line;
  Line found;
  const bool ends =
      until ? skip_to(label, {"while"}, line, found) : skip_to(label, {"endwhile", "endrepeat"}, line, found);
  if (!ends) return false;
  if (word.keyword == "continue") return until ? begin_while(line, found) : end_loop(found);
  frames_.back().loops.pop_back();
  return true;
}

bool OwordFlow::jump(LineMark mark) {
  if (++idle_jumps_ > idle_jumps_most || ++jumps_ > jumps_most)
    return diagnosis_.fault(column_, "program-endless",
                            idle_jumps_ > idle_jumps_most ? "loops and calls have run 200000 times without a motion"
                                                          : "loops and calls have run 10 million times");
  source_.go_to(mark);
  return true;
}

}  // namespace volute::sim
