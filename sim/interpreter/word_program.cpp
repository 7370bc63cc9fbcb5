#include "sim/interpreter/word_program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/number_text.hpp"
#include "sim/interpreter/arithmetic.hpp"

namespace volute::sim {

namespace {
constexpr int user_codes_from = 1000;  ///< M100 in tenths: codes that an integrator defines
}  // namespace

std::unique_ptr<Dialect> make_word_dialect(Reading& reading) { return std::make_unique<WordProgram>(reading); }

WordProgram::WordProgram(Reading& reading)
    : reading_(reading),
      state_(reading.state),
      family_(reading.control.family),
      linuxcnc_(family_ == kinematics::DialectFamily::linuxcnc),
      lexer_(
          WordStyle{linuxcnc_}, parameters_,
          [this](int index) -> std::optional<double> {
            // LinuxCNC #5420 .. #5425: where the axes stand in program coordinates.
            if (index < 5420 || index > 5422 || !linuxcnc_) return std::nullopt;
            const auto mm = state_.program_linear_mm(index - 5420);
            return mm ? std::optional<double>(*mm / state_.unit_mm()) : std::nullopt;
          },
          reading.diagnosis),
      owords_(reading.source, lexer_, reading.diagnosis),
      subprograms_(reading.source, reading.diagnosis, reading.source.text()) {
  // Measured on LinuxCNC's interpreter; Fanuc and its relatives start with G98.
  return_to_r_ = linuxcnc_;
  if (!linuxcnc_) return;
  read_tcp_switches(reading.control.tcp_on, true);
  read_tcp_switches(reading.control.tcp_off, false);
}

void WordProgram::read_tcp_switches(const std::vector<std::string>& lines, bool on) {
  // The control file's own lines; a fault in them is not the program's, so such a line switches nothing.
  for (const std::string& text : lines) {
    const Source source(text, "");
    Diagnosis diagnosis(source);
    Parameters parameters;
    WordLexer lexer(WordStyle{true}, parameters, {}, diagnosis);
    Block block;
    std::size_t at = 0;
    if (!lexer.skip_prefix(text, at) || !lexer.read(text, at, block)) continue;
    for (std::size_t i = 0; i < block.m_count; ++i) {
      const int code = block.m[i].tenths;
      if (code >= user_codes_from) (on ? tcp_on_m_ : tcp_off_m_).push_back(code);
      if (code == 680 && block.has('E') && block.has('Q'))
        (on ? tcp_on_outputs_ : tcp_off_outputs_).push_back({block.value('E'), block.value('Q')});
    }
  }
}

bool WordProgram::end_of_text() {
  if (owords_.inside_call() || subprograms_.inside_call())
    return fault(0, "program-ended-early", "the text ends inside a subprogram; its end (endsub, M99) is missing");
  return fault(0, "program-ended-early", "the text ends without the program's end; write M30 or M2 as its last block");
}

bool WordProgram::percent(std::string_view line, std::size_t at) {
  if (line.find_first_not_of(" \t", at + 1) != std::string_view::npos)
    return fault(at, "program-syntax", "\"%\" stands alone on its line");
  if (linuxcnc_ && any_block_ && !percent_open_)
    return fault(at, "program-syntax", "\"%\" ends only a program that begins with one");
  // The first one opens the program, the next one ends it.
  if (percent_open_ || any_block_) reading_.finished = true;
  percent_open_ = true;
  return true;
}

bool WordProgram::advance() {
  const auto line = reading_.source.next_line();
  if (!line) return end_of_text();
  std::size_t at = 0;
  while (at < line->size() && ((*line)[at] == ' ' || (*line)[at] == '\t')) ++at;
  if (at < line->size() && (*line)[at] == '%') return percent(*line, at);
  if (!lexer_.skip_prefix(*line, at)) return false;
  if (at >= line->size()) return true;
  any_block_ = true;
  if (linuxcnc_ && ((*line)[at] == 'O' || (*line)[at] == 'o')) return owords_.run(*line, at);
  if (!lexer_.read(*line, at, block_)) return false;
  return block_.empty() || execute();
}

bool WordProgram::execute() {
  plan_ = {};
  state_.standing.line = reading_.source.line();
  if (state_.standing.feed_mode == FeedMode::inverse_time) state_.feed_number = 0.0;
  for (std::size_t i = 0; i < block_.g_count; ++i)
    if (!apply_g(block_.g[i])) return false;
  if (!feed_speed_tool()) return false;
  for (std::size_t i = 0; i < block_.m_count; ++i)
    if (!apply_m_before(block_.m[i])) return false;
  const bool moved =
      plan_.one_shot == OneShot::none || plan_.one_shot == OneShot::machine_coordinates ? motion() : run_one_shot();
  if (!moved) return false;
  for (std::size_t i = 0; i < block_.m_count; ++i)
    if (!apply_m_after(block_.m[i])) return false;
  if (!reading_.queue.empty()) owords_.motion_came();
  return leftovers();
}

bool WordProgram::feed_speed_tool() {
  const auto negative = [&](char letter) {
    return fault(block_.column(letter), "program-word-range", std::string(1, letter) + " is negative");
  };
  if (block_.use('F')) {
    if (block_.value('F') < 0.0) return negative('F');
    state_.feed_number = block_.value('F');
    state_.feed_unit_mm = state_.unit_mm();
  }
  if (block_.use('S')) {
    if (block_.value('S') < 0.0) return negative('S');
    state_.standing.spindle_rad_s = block_.value('S') * rad_s_per_rpm;
  }
  if (block_.use('T')) {
    const double number = block_.value('T');
    if (number < 0.0 || number > 1e8 || number != std::floor(number))
      return fault(block_.column('T'), "program-word-range", "T takes a whole number from 0 to 99999999");
    tool_prepared_ = static_cast<int>(number);
  }
  if (!linuxcnc_ && block_.use('O')) {
    if (program_number_seen_)
      return fault(block_.column('O'), "program-ended-early",
                   "another program begins before the one above has ended; write M30 or M99 above");
    program_number_seen_ = true;
  }
  return true;
}

bool WordProgram::leftovers() {
  const std::uint32_t rest = block_.present & ~block_.used;
  if (rest == 0) return true;
  // The leftmost of the words that nothing has used.
  char first = 0;
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (((rest >> Block::index(letter)) & 1U) != 0 && (first == 0 || block_.column(letter) < block_.column(first)))
      first = letter;
  const bool axis = first >= 'A' && (first <= 'C' || (first >= 'U' && first <= 'W')) && state_.rotary_of(first) < 0;
  return fault(block_.column(first), "program-unknown-word",
               std::string("the word ") + first +
                   (axis ? " names an axis that this machine does not have" : " has no meaning in this block") +
                   "; take it out or choose the machine that the program was written for");
}

}  // namespace volute::sim
