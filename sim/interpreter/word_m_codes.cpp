// What the M codes of word-address programs mean.
#include <algorithm>
#include <string>

#include "sim/interpreter/word_program.hpp"

namespace volute::sim {

bool WordProgram::tool_change(Code code) {
  if (state_.standing.tcp)
    return fault(code.column, "program-tool-change", "the tool is changed while TCP is on; switch TCP off first");
  state_.standing.tool_number = tool_prepared_;
  reading_.queue.push_back(state_.stop());
  return true;
}

bool WordProgram::apply_m_before(Code code) {
  const auto same = [&](const std::vector<int>& codes) {
    return std::find(codes.begin(), codes.end(), code.tenths) != codes.end();
  };
  if (same(tcp_on_m_)) return switch_tcp(code, true);
  if (same(tcp_off_m_)) return switch_tcp(code, false);
  MotionBlock& standing = state_.standing;
  switch (code.tenths) {
    case 30:
    case 40:
      standing.spindle_on = true;
      standing.spindle_reversed = code.tenths == 40;
      return true;
    case 60:
      return tool_change(code);
    case 50:
    case 0:
    case 10:
    case 20:
    case 300:
    case 70:
    case 80:
    case 90:
      return true;
    case 190:
      if (linuxcnc_) block_.use('R'), block_.use('Q');
      standing.spindle_on = false;
      return true;
    case 980:
    case 990:
      if (!linuxcnc_) return true;
      break;
    default:
      break;
  }
  bool known = false;
  if (!machine_m(code, known)) return false;
  if (known) return true;
  return fault(code.column, "program-unknown-code", code_name('M', code.tenths) + ": " + unknown_code("M"));
}

bool WordProgram::machine_m(Code code, bool& known) {
  const auto one_of = [&](std::initializer_list<int> codes) {
    return std::find(codes.begin(), codes.end(), code.tenths) != codes.end();
  };
  if (!linuxcnc_) {
    // Clamps of the rotary axes (M10 to M13) hold what stands still: they move nothing.
    known = one_of({100, 110, 120, 130});
    return true;
  }
  known = one_of({480, 490, 500, 510, 520, 530, 600, 610, 620, 630, 640, 650, 660, 670, 680});
  if (!known) return true;
  block_.use('P');
  if (code.tenths == 610) {
    if (!block_.use('Q'))
      return fault(code.column, "program-syntax", "M61 needs Q, the number of the tool in the spindle");
    state_.standing.tool_number = tool_prepared_ = static_cast<int>(std::clamp(block_.value('Q'), 0.0, 1e6));
    return true;
  }
  if (code.tenths < 660) return true;
  block_.use('E'), block_.use('L'), block_.use('Q');
  if (code.tenths != 680) return true;
  const std::array<double, 2> output{block_.value('E'), block_.value('Q')};
  const auto is = [&](const auto& outputs) {
    return std::find(outputs.begin(), outputs.end(), output) != outputs.end();
  };
  if (is(tcp_on_outputs_)) return switch_tcp(code, true);
  return !is(tcp_off_outputs_) || switch_tcp(code, false);
}

bool WordProgram::apply_m_after(Code code) {
  switch (code.tenths) {
    case 50:
      state_.standing.spindle_on = false;
      return true;
    case 0:
      reading_.queue.push_back(state_.stop());
      return true;
    case 20:
    case 300:
      reading_.finished = true;
      return true;
    case 980: {
      if (linuxcnc_) return true;
      if (!block_.use('P')) return fault(code.column, "program-syntax", "M98 needs P, the number of the subprogram");
      const double times = block_.use('L') ? block_.value('L') : 1.0;
      if (!(block_.value('P') >= 0.0 && block_.value('P') < 1e12 && times >= 0.0 && times < 1e6))
        return fault(code.column, "program-word-range", "P or L of M98 is out of range");
      return subprograms_.call(code.column, static_cast<std::int64_t>(block_.value('P')),
                               static_cast<std::int64_t>(times));
    }
    case 990: {
      if (linuxcnc_) return true;
      bool main = false;
      if (!subprograms_.leave(main)) return false;
      if (main) {
        reading_.diagnosis.warn_once("M99 in main",
                                     "M99 in the main program would start it again; it is taken as the end");
        reading_.finished = true;
      }
      return true;
    }
    default:
      return true;
  }
}

}  // namespace volute::sim
