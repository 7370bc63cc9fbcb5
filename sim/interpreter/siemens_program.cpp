#include "sim/interpreter/siemens_program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/interpreter/arithmetic.hpp"

namespace volute::sim {

std::unique_ptr<Dialect> make_siemens_dialect(Reading& reading) { return std::make_unique<SiemensProgram>(reading); }

bool SiemensProgram::advance() {
  const auto line = reading_.source.next_line();
  if (!line)
    return fault(0, "program-ended-early", "the text ends without the program's end; write M30 as its last block");
  std::size_t at = line->find_first_not_of(" \t");
  if (at == std::string_view::npos) return true;
  // "%_N_NAME_MPF" names the program.
  if ((*line)[at] == '%') return true;
  // Block skip: the switch is taken as off.
  if ((*line)[at] == '/') ++at;
  if (at < line->size() && ((*line)[at] == 'N' || (*line)[at] == 'n' || (*line)[at] == ':')) {
    std::size_t end = at + 1;
    while (end < line->size() && (*line)[end] >= '0' && (*line)[end] <= '9') ++end;
    if (end > at + 1) at = end;
  }
  words_ = {};
  state_.standing.line = reading_.source.line();
  if (state_.standing.feed_mode == FeedMode::inverse_time) state_.feed_number = 0.0;
  return words(*line, at) && execute();
}

bool SiemensProgram::execute() {
  if (words_.speed) {
    if (*words_.speed < 0.0) return fault(0, "program-word-range", "S is negative");
    state_.standing.spindle_rad_s = *words_.speed * rad_s_per_rpm;
  }
  if (words_.dwell) {
    if (!words_.feed) return fault(0, "program-syntax", "G4 needs F, the seconds to wait");
    if (*words_.feed < 0.0) return fault(words_.feed_column, "program-word-range", "G4 waits a negative time");
    reading_.queue.push_back(state_.dwell(*words_.feed));
    words_.feed.reset();
  }
  if (words_.feed) {
    if (*words_.feed < 0.0) return fault(words_.feed_column, "program-word-range", "F is negative");
    state_.feed_number = *words_.feed;
    state_.feed_unit_mm = feed_in_inches_ ? 25.4 : 1.0;
  }
  if (words_.frame ? !frame() : !motion()) return false;
  for (const int code : words_.m_after) {
    if (code == 0) reading_.queue.push_back(state_.stop());
    if (code == 5) state_.standing.spindle_on = false;
    if (code == 2 || code == 17 || code == 30) reading_.finished = true;
  }
  return true;
}

bool SiemensProgram::frame() {
  // TRANS puts the zero where its words say, from the work offset; without words it takes every frame back.
  const bool any =
      std::any_of(words_.axes.begin(), words_.axes.end(), [](const SiemensAxisWord& w) { return w.given; });
  if (!words_.frame_adds) state_.shift = {};
  if (!any) return true;
  for (std::size_t i = 0; i < 5; ++i) {
    const SiemensAxisWord& word = words_.axes[i];
    if (!word.given) continue;
    if (word.mode != SiemensValue::modal) return fault(word.column, "program-syntax", "TRANS takes plain numbers");
    if (i < 3)
      state_.shift.linear_mm[static_cast<Eigen::Index>(i)] += word.value * state_.unit_mm();
    else
      state_.shift.rotary_rad[i - 3] += word.value * rad_per_deg;
  }
  return true;
}

bool SiemensProgram::rotary_word(int rotary, const SiemensAxisWord& word, MoveWords& out) {
  const auto i = static_cast<std::size_t>(rotary);
  const unsigned bit = 1U << i;
  out.rotary |= bit;
  out.rotary_rad[i] = word.value * rad_per_deg;
  switch (word.mode) {
    case SiemensValue::incremental:
      out.rotary_incremental |= bit;
      return true;
    case SiemensValue::modal:
      if (state_.incremental) out.rotary_incremental |= bit;
      return true;
    case SiemensValue::absolute:
      return true;
    default:
      break;
  }
  const auto now = state_.program_rotary_rad(rotary);
  if (word.mode == SiemensValue::direct && !now) {
    // The control finds the turn from where the axis stands. What is said of one axis holds for both words of a block,
    // so the other one must go the short way too.
    const SiemensAxisWord& other = words_.axes[i == 0 ? 4 : 3];
    const bool plain =
        other.mode == SiemensValue::absolute || (other.mode == SiemensValue::modal && !state_.incremental);
    if (!other.given || other.mode == SiemensValue::direct || other.mode == SiemensValue::incremental ||
        (plain && state_.plain_way_is_short(1 - rotary, other.value * rad_per_deg)) ||
        (other.mode == SiemensValue::modal && !plain))
      return out.rotary_shortest = true;
  }
  if (!now)
    return fault(word.column, "program-position-unknown",
                 std::string("where ") + state_.rotary_letter(rotary) +
                     " stands is not known here; move it to a plain position first");
  const double away = out.rotary_rad[i] - *now;
  double way = std::remainder(away, turn_rad);
  if (word.mode == SiemensValue::positive) way = way < 0.0 ? way + turn_rad : way;
  if (word.mode == SiemensValue::negative) way = way > 0.0 ? way - turn_rad : way;
  out.rotary_rad[i] = *now + way;
  return true;
}

bool SiemensProgram::move_words(MoveWords& out) {
  for (std::size_t i = 0; i < 3; ++i) {
    const SiemensAxisWord& word = words_.axes[i];
    if (!word.given) continue;
    if (word.mode > SiemensValue::incremental)
      return fault(word.column, "program-syntax", "DC, ACP and ACN are for rotary axes");
    out.linear |= 1U << i;
    out.linear_mm[i] = word.value * state_.unit_mm();
    if (word.mode == SiemensValue::incremental || (word.mode == SiemensValue::modal && state_.incremental))
      out.linear_incremental |= 1U << i;
  }
  for (int rotary = 0; rotary < 2; ++rotary) {
    const SiemensAxisWord& word = words_.axes[static_cast<std::size_t>(3 + rotary)];
    if (word.given && !rotary_word(rotary, word, out)) return false;
  }
  return tool_axis(out);
}

bool SiemensProgram::tool_axis(MoveWords& out) {
  const auto& parts = words_.vector;
  if (!parts[0] && !parts[1] && !parts[2]) return true;
  const std::size_t column = words_.vector_column;
  if (!state_.standing.tcp) return fault(column, "program-vector", "A3 B3 C3 need TRAORI; write it before this block");
  if (out.rotary != 0)
    return fault(column, "program-vector", "the tool axis is given by A3 B3 C3 and by a rotary axis in the same block");
  // [S-PGA]: components that are missing are 0; the length does not matter.
  const Vec3 axis(parts[0].value_or(0.0), parts[1].value_or(0.0), parts[2].value_or(0.0));
  if (!(axis.norm() > 1e-9)) return fault(column, "program-vector", "the tool axis A3 B3 C3 has no length");
  out.axis_vector = axis.normalized();
  return true;
}

bool SiemensProgram::motion() {
  MoveWords moves;
  if (!move_words(moves)) return false;
  const bool arcs = mode_ == Motion::clockwise || mode_ == Motion::counter_clockwise;
  const bool centre =
      std::any_of(words_.centre.begin(), words_.centre.end(), [](const SiemensAxisWord& w) { return w.given; });
  const bool arc_words = centre || words_.radius || words_.opening || words_.turn;
  if (arc_words && !arcs)
    return fault(words_.motion_column, "program-unknown-word", "I J K, CR=, AR= and TURN= belong to G2 and G3");
  if (!moves.any() && !arc_words) return true;
  if (mode_ == Motion::none)
    return fault(0, "program-no-motion", "axis words without a motion code in force; write G0 or G1 before them");
  if (arcs) return arc(moves);
  if (words_.machine) {
    if (state_.standing.tcp)
      return fault(0, "program-machine-tcp", "machine coordinates while TRAORI is on; write TRAFOOF first");
    if (moves.linear_incremental != 0 || moves.rotary_incremental != 0)
      return fault(0, "program-syntax", "machine coordinates are positions and have no meaning under G91");
    moves.machine_coordinates = true;
  }
  MotionBlock block;
  if (!state_.line(mode_ == Motion::rapid ? MotionKind::rapid : MotionKind::line, moves, words_.motion_column, block))
    return false;
  if (words_.exact_stop) block.path_mode = PathMode::exact_stop;
  reading_.queue.push_back(block);
  return true;
}

bool SiemensProgram::arc(const MoveWords& moves) {
  ArcWords arc;
  arc.clockwise = mode_ == Motion::clockwise;
  arc.column = words_.motion_column;
  for (std::size_t i = 0; i < 3; ++i) {
    const SiemensAxisWord& word = words_.centre[i];
    if (!word.given) continue;
    if (word.mode > SiemensValue::incremental) return fault(word.column, "program-syntax", "the centre takes AC or IC");
    arc.centre |= 1U << i;
    if (word.mode == SiemensValue::absolute) arc.centre_absolute |= 1U << i;
    arc.centre_mm[i] = word.value * state_.unit_mm();
  }
  if (words_.radius) arc.radius_mm = *words_.radius * state_.unit_mm();
  arc.opening_rad = words_.opening;
  if (arc.opening_rad && !(*arc.opening_rad > 0.0 && *arc.opening_rad < turn_rad))
    return fault(arc.column, "program-arc", "AR= lies between 0 and 360 degrees");
  if (words_.turn) {
    if (*words_.turn < 0.0 || *words_.turn > 999.0 || *words_.turn != std::floor(*words_.turn))
      return fault(arc.column, "program-arc", "TURN= is a whole number from 0 to 999");
    arc.turns = 1 + static_cast<int>(*words_.turn);
  }
  if (words_.machine) return fault(arc.column, "program-syntax", "machine coordinates need G0 or G1");
  MotionBlock block;
  if (!state_.arc(moves, arc, block)) return false;
  if (words_.exact_stop) block.path_mode = PathMode::exact_stop;
  reading_.queue.push_back(block);
  return true;
}

}  // namespace volute::sim
