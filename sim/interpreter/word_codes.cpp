// What the G codes of word-address programs mean.
#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/number_text.hpp"
#include "sim/interpreter/word_program.hpp"

namespace volute::sim {

namespace {

/// Modal groups, one bit each: two codes of one group contradict each other.
enum Group : int {
  group_motion = 0,
  group_plane,
  group_distance,
  group_arc_distance,
  group_feed,
  group_units,
  group_compensation,
  group_length,
  group_return,
  group_offset,
  group_path,
  group_one_shot,
  group_spindle,
  group_smoothing,
  group_tilt
};

}  // namespace

std::string code_name(char letter, int tenths) {
  std::string text = letter + std::to_string(tenths / 10);
  if (tenths % 10 != 0) text += "." + std::to_string(tenths % 10);
  return text;
}

bool WordProgram::set_group(Code code, int group) {
  const std::uint32_t bit = 1U << static_cast<unsigned>(group);
  // Fanuc and its relatives take the last code of a group; LinuxCNC refuses the block.
  if ((plan_.groups & bit) != 0 && linuxcnc_)
    return fault(code.column, "program-syntax",
                 code_name('G', code.tenths) + " contradicts another G code of the same group in this block");
  plan_.groups |= bit;
  return true;
}

bool WordProgram::apply_g(Code code) {
  const auto move = [&](MotionMode mode) {
    mode_ = mode;
    plan_.motion_named = true;
    plan_.motion_column = code.column;
    return set_group(code, group_motion);
  };
  switch (code.tenths) {
    case 0:
      return move(MotionMode::rapid);
    case 10:
      return move(MotionMode::line);
    case 20:
      return move(MotionMode::clockwise);
    case 30:
      return move(MotionMode::counter_clockwise);
    case 800:
      return move(MotionMode::none);
    case 730:
    case 810:
    case 820:
    case 830:
    case 850:
    case 860:
    case 890:
      return begin_cycle(code) && move(MotionMode::cycle);
    case 921:
      return linuxcnc_ ? one_shot(code, OneShot::clear_shift) : refuse_g(code);
    case 922:
      return linuxcnc_ ? one_shot(code, OneShot::suspend_shift) : refuse_g(code);
    case 923:
      return linuxcnc_ ? one_shot(code, OneShot::restore_shift) : refuse_g(code);
    case 431:
      return linuxcnc_ ? one_shot(code, OneShot::tool_offset) && set_group(code, group_length) : refuse_g(code);
    case 40:
      return one_shot(code, OneShot::dwell);
    case 100:
      return one_shot(code, OneShot::set_data);
    case 280:
      return one_shot(code, OneShot::reference);
    case 300:
      return one_shot(code, OneShot::second_reference);
    case 520:
      return one_shot(code, OneShot::local_shift);
    case 530:
      return one_shot(code, OneShot::machine_coordinates);
    case 920:
      return one_shot(code, OneShot::shift_position);
    default:
      return apply_mode(code);
  }
}

bool WordProgram::one_shot(Code code, OneShot what) {
  if (!set_group(code, group_one_shot)) return false;
  if (plan_.one_shot != OneShot::none)
    return fault(code.column, "program-syntax",
                 code_name('G', code.tenths) + " cannot stand with another one-shot G code");
  plan_.one_shot = what;
  plan_.column = code.column;
  return true;
}

bool WordProgram::apply_mode(Code code) {
  const auto plane = [&](Plane which) {
    state_.plane = which;
    return set_group(code, group_plane);
  };
  const auto feed = [&](FeedMode mode) {
    // LinuxCNC forgets F at G94 and G95 even when nothing changes.
    if (linuxcnc_) state_.feed_number = 0.0;
    state_.set_feed_mode(mode);
    return set_group(code, group_feed);
  };
  switch (code.tenths) {
    case 170:
      return plane(Plane::xy);
    case 180:
      return plane(Plane::zx);
    case 190:
      return plane(Plane::yz);
    case 200:
      state_.inches = true;
      return set_group(code, group_units);
    case 210:
      state_.inches = false;
      return set_group(code, group_units);
    case 900:
      state_.incremental = false;
      return set_group(code, group_distance);
    case 910:
      state_.incremental = true;
      return set_group(code, group_distance);
    case 930:
      return feed(FeedMode::inverse_time);
    case 940:
      return feed(FeedMode::per_minute);
    case 950:
      return feed(FeedMode::per_revolution);
    case 400:
      return set_group(code, group_compensation);
    case 690:
      return linuxcnc_ ? refuse_g(code) : set_group(code, group_tilt);
    case 970:
      return set_group(code, group_spindle);
    case 980:
    case 990:
      return_to_r_ = code.tenths == 990;
      return set_group(code, group_return);
    case 901:
    case 911:
      if (!linuxcnc_) return refuse_g(code);
      arc_centre_absolute_ = code.tenths == 901;
      return set_group(code, group_arc_distance);
    default:
      break;
  }
  if (code.tenths >= 540 && code.tenths <= 593) return choose_work_offset(code);
  return apply_length(code);
}

bool WordProgram::choose_work_offset(Code code) {
  if (code.tenths == 541 && !linuxcnc_) {
    if (!block_.use('P')) return fault(code.column, "program-syntax", "G54.1 needs P, the number of the work offset");
    const double number = block_.value('P');
    if (number != std::floor(number) || number < 1.0 || number > 300.0)
      return fault(block_.column('P'), "program-word-range", "P of G54.1 is a whole number from 1 to 300");
    return work_offset(code, 100 + static_cast<int>(number));
  }
  if (code.tenths % 10 == 0) return work_offset(code, code.tenths / 10 - 53);
  if (code.tenths > 590 && linuxcnc_) return work_offset(code, code.tenths - 590 + 6);
  return refuse_g(code);
}

bool WordProgram::work_offset(Code code, int system) {
  if (system != 1 && system != work_system_)
    reading_.diagnosis.warn_once(
        "work offset " + std::to_string(system),
        code_name('G', code.tenths) +
            ": no table of work offsets is known; its zero is taken to be the setup's program zero");
  work_system_ = system;
  update_shift();
  return set_group(code, group_offset);
}

bool WordProgram::switch_tcp(Code code, bool on) {
  if (on && !reading_.control.tcp)
    return fault(code.column, "program-no-tcp",
                 "the program switches TCP on, but this control has none; choose a profile whose control has it");
  if (on && !refuse_tcp_with_offset(code.column)) return false;
  state_.set_tcp(on);
  return true;
}

bool WordProgram::apply_length(Code code) {
  using kinematics::DialectFamily;
  const bool point_control = family_ == DialectFamily::fanuc || family_ == DialectFamily::mazak;
  switch (code.tenths) {
    case 430:
      block_.use('H');
      tool_offset_mm_.setZero();
      update_shift();
      state_.set_tool_length(true);
      return set_group(code, group_length);
    case 434:
    case 435:
      if (!point_control) return refuse_g(code);
      block_.use('H');
      if (block_.use('P') && block_.value('P') != 0.0 && block_.value('P') != 1.0)
        return fault(block_.column('P'), "program-word-range", "P of G43.4 and G43.5 is 0 or 1");
      if (code.tenths == 435 && block_.use('Q') && block_.value('Q') != 0.0)
        return fault(block_.column('Q'), "program-unknown-word",
                     "an inclination angle Q with G43.5 is not read; use Q0");
      vector_words_ = code.tenths == 435;
      state_.set_tool_length(true);
      return set_group(code, group_length) && switch_tcp(code, true);
    case 2340:
      if (family_ != DialectFamily::haas) return refuse_g(code);
      block_.use('H');
      state_.set_tool_length(true);
      return set_group(code, group_length) && switch_tcp(code, true);
    case 490:
      block_.use('H');
      vector_words_ = false;
      tool_offset_mm_.setZero();
      update_shift();
      state_.set_tool_length(false);
      if (!linuxcnc_) state_.set_tcp(false);
      return set_group(code, group_length);
    default:
      return apply_path_mode(code);
  }
}

bool WordProgram::apply_path_mode(Code code) {
  using kinematics::DialectFamily;
  MotionBlock& standing = state_.standing;
  const auto ask = [&](PathMode mode) {
    standing.path_mode = mode;
    return set_group(code, group_path);
  };
  switch (code.tenths) {
    case 610:
      return ask(linuxcnc_ ? PathMode::exact_path : PathMode::exact_stop);
    case 611:
      return linuxcnc_ ? ask(PathMode::exact_stop) : refuse_g(code);
    case 640:
      if (linuxcnc_) {
        standing.path_tolerance_mm = block_.use('P') ? block_.value('P') * state_.unit_mm() : -1.0;
        standing.naive_cam_tolerance_mm =
            block_.use('Q') ? block_.value('Q') * state_.unit_mm() : standing.path_tolerance_mm;
      }
      return ask(PathMode::continuous);
    case 90:
      if (linuxcnc_) return refuse_g(code);
      plan_.exact_stop = true;
      return true;
    case 51:
      if (linuxcnc_ || family_ == DialectFamily::haas) return refuse_g(code);
      if (!block_.use('Q')) return fault(code.column, "program-syntax", "G5.1 needs Q0 or Q1");
      block_.use('R');
      return set_group(code, group_smoothing);
    case 50:
      if (linuxcnc_ || family_ == DialectFamily::haas) return refuse_g(code);
      if (!block_.use('P')) return fault(code.column, "program-syntax", "G5 needs P");
      return set_group(code, group_smoothing);
    case 1870:
      if (family_ != DialectFamily::haas) return refuse_g(code);
      block_.use('P');
      standing.path_tolerance_mm = block_.use('E') ? block_.value('E') * state_.unit_mm() : -1.0;
      return set_group(code, group_smoothing);
    case 2550:
      return family_ == DialectFamily::haas ? set_group(code, group_tilt) : refuse_g(code);
    default:
      return refuse_g(code);
  }
}

std::string WordProgram::unknown_code(const char* letter) const {
  return std::string("this ") + letter + " code is not known to the control \"" + reading_.control.name +
         "\"; take it out, or choose the profile that the program was written for";
}

bool WordProgram::refuse_g(Code code) {
  struct Reason {
    int tenths;
    const char* text;
  };
  static constexpr std::array reasons{
      Reason{410, "cutter radius compensation is not read: let the CAM system compensate"},
      Reason{420, "cutter radius compensation is not read: let the CAM system compensate"},
      Reason{411, "cutter radius compensation is not read: let the CAM system compensate"},
      Reason{421, "cutter radius compensation is not read: let the CAM system compensate"},
      Reason{330, "spindle-synchronized motion is not read"},
      Reason{331, "rigid tapping is not read"},
      Reason{382, "probing is not read: its path depends on what the probe meets"},
      Reason{650, "macro calls are not read: post the motions themselves"},
      Reason{660, "macro calls are not read: post the motions themselves"},
      Reason{680, "rotated coordinates are not read"},
      Reason{510, "scaling and mirroring are not read"},
      Reason{160, "polar coordinates are not read"},
      Reason{960, "constant surface speed belongs to turning and is not read"},
      Reason{2540, "dynamic work offsets (G254) depend on the machine's rotary zero table; post with TCP (G234)"},
      Reason{682, "tilted working planes are not read: post with TCP"},
      Reason{683, "tilted working planes are not read: post with TCP"},
      Reason{684, "tilted working planes are not read: post with TCP"},
      Reason{690, "tilted working planes are not read: post with TCP"},
      Reason{531, "tilted working planes are not read: post with TCP"},
      Reason{533, "tilted working planes are not read: post with TCP"},
      Reason{536, "tilted working planes are not read: post with TCP"},
      Reason{431, "tool length along the tool's axis (G43.1) is not read: post with TCP (G43.4)"},
      Reason{740, "tapping is not read"},
      Reason{840, "tapping is not read"},
      Reason{760, "fine boring and threading cycles are not read"},
      Reason{870, "back boring is not read"},
      Reason{880, "manual boring is not read"},
      Reason{1410, "this control's dialect has no G141"},
  };
  const auto* found =
      std::find_if(reasons.begin(), reasons.end(), [&](const Reason& r) { return r.tenths == code.tenths; });
  return fault(
      code.column, "program-unknown-code",
      code_name('G', code.tenths) + ": " + (found != reasons.end() ? std::string(found->text) : unknown_code("G")));
}

}  // namespace volute::sim
