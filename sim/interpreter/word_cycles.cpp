// Drilling cycles of word-address programs as the motions that they stand for: G73, G81 to G83, G85, G86, G89.
#include <algorithm>
#include <cmath>

#include "geometry/number_text.hpp"
#include "sim/interpreter/word_program.hpp"

namespace volute::sim {

namespace {
/// How far above the last depth a peck begins again: LinuxCNC's 0.010 inch; other controls hold it in a parameter.
constexpr double peck_clearance_mm = 0.254;
constexpr std::int64_t pecks_most = 10'000, repeats_most = 1'000;
}  // namespace

bool WordProgram::begin_cycle(Code code) {
  if (mode_ != MotionMode::cycle) cycle_ = Cycle{};
  cycle_.code = code.tenths;
  return true;
}

bool WordProgram::cycle_words(std::int64_t& repeats) {
  const auto take = [&](char letter, std::optional<double>& out) {
    if (block_.use(letter)) out = block_.value(letter) * state_.unit_mm();
  };
  take('Z', cycle_.z_mm);
  take('R', cycle_.r_mm);
  const bool pecks = cycle_.code == 730 || cycle_.code == 830;
  if (pecks) take('Q', cycle_.q_mm);
  if (block_.use('P'))
    cycle_.dwell_s = linuxcnc_ || block_.has_point('P') ? block_.value('P') : block_.value('P') / 1000.0;
  const char count = linuxcnc_ || family_ == kinematics::DialectFamily::haas ? 'L' : 'K';
  const double times = block_.use(count) ? block_.value(count) : 1.0;
  const auto refuse = [&](const std::string& text) {
    return fault(plan_.motion_named ? plan_.motion_column : 0, "program-cycle", text);
  };
  if (!cycle_.z_mm || !cycle_.r_mm) return refuse("a drilling cycle needs Z and R");
  if (*cycle_.r_mm < *cycle_.z_mm) return refuse("the cycle's R lies below its Z");
  if (pecks && !(cycle_.q_mm && *cycle_.q_mm > 0.0)) return refuse("pecking needs Q above 0");
  if (pecks && (*cycle_.r_mm - *cycle_.z_mm) / *cycle_.q_mm > static_cast<double>(pecks_most))
    return refuse("more than 10000 pecks in a hole");
  if (cycle_.dwell_s < 0.0) return refuse("the dwell P is negative");
  if (times < 0.0 || times > static_cast<double>(repeats_most) || times != std::floor(times))
    return refuse("a cycle is repeated 0 to 1000 times");
  repeats = static_cast<std::int64_t>(times);
  return true;
}

bool WordProgram::drill() {
  const bool places = block_.has('X') || block_.has('Y') || block_.has('Z');
  if (!plan_.motion_named && !places) return true;
  const std::size_t column = plan_.motion_named ? plan_.motion_column : 0;
  if (state_.incremental) return fault(column, "program-cycle", "drilling cycles are read under G90 only");
  if (state_.plane != Plane::xy) return fault(column, "program-cycle", "drilling cycles are read in G17 only");
  std::int64_t repeats = 1;
  if (!cycle_words(repeats)) return false;
  MoveWords place;
  axis_words(place);
  place.linear &= 3U;
  if (place.rotary != 0)
    return fault(column, "program-cycle", "a rotary axis cannot turn in a drilling cycle; turn it in a block above");
  if (!cycle_.initial_z_mm) cycle_.initial_z_mm = state_.program_linear_mm(2);
  const auto z = state_.program_linear_mm(2);
  if (!z || !cycle_.initial_z_mm)
    return fault(column, "program-position-unknown",
                 "where Z stands is not known here; move it to a position before drilling");
  if (*z < *cycle_.r_mm && !go_z(MotionKind::rapid, *cycle_.r_mm)) return false;
  for (std::int64_t i = 0; i < repeats; ++i) {
    MotionBlock block;
    if (place.any() && !emit(state_.line(MotionKind::rapid, place, column, block), block)) return false;
    if (!go_z(MotionKind::rapid, *cycle_.r_mm) || !drill_hole()) return false;
    const double clear = return_to_r_ ? *cycle_.r_mm : std::max(*cycle_.initial_z_mm, *cycle_.r_mm);
    if (!go_z(MotionKind::rapid, clear)) return false;
  }
  return true;
}

bool WordProgram::drill_hole() {
  const double r = *cycle_.r_mm, bottom = *cycle_.z_mm;
  const bool pecks = cycle_.code == 730 || cycle_.code == 830;
  double depth = r;
  while (pecks && depth - *cycle_.q_mm > bottom) {
    depth -= *cycle_.q_mm;
    if (!go_z(MotionKind::line, depth)) return false;
    if (cycle_.code == 830 && !go_z(MotionKind::rapid, r)) return false;
    if (!go_z(MotionKind::rapid, depth + peck_clearance_mm)) return false;
  }
  if (!go_z(MotionKind::line, bottom)) return false;
  const bool dwells = cycle_.code == 820 || cycle_.code == 860 || cycle_.code == 890;
  if (dwells && cycle_.dwell_s > 0.0) reading_.queue.push_back(state_.dwell(cycle_.dwell_s));
  const bool feeds_out = cycle_.code == 850 || cycle_.code == 890;
  return !feeds_out || go_z(MotionKind::line, r);
}

bool WordProgram::go_z(MotionKind kind, double z_mm) {
  const auto now = state_.program_linear_mm(2);
  if (now && *now == z_mm) return true;
  MoveWords words;
  words.linear = 4U;
  words.linear_mm[2] = z_mm;
  MotionBlock block;
  return emit(state_.line(kind, words, plan_.motion_named ? plan_.motion_column : 0, block), block);
}

}  // namespace volute::sim
