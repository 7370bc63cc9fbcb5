// Word-address programs: LinuxCNC, Fanuc, Haas, Mazak. One block: codes, then F S T, then M before, motion, M after.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/interpreter/dialect.hpp"
#include "sim/interpreter/fanuc_flow.hpp"
#include "sim/interpreter/oword.hpp"
#include "sim/interpreter/word_lexer.hpp"

namespace volute::sim {

/// The modal motion: G0 to G3, none after G80, or a canned cycle (its code in tenths).
enum class MotionMode : std::uint8_t { none, rapid, line, clockwise, counter_clockwise, cycle };

/// "G43.4" for 434.
std::string code_name(char letter, int tenths);

class WordProgram final : public Dialect {
 public:
  explicit WordProgram(Reading& reading);
  bool advance() override;

 private:
  /// Codes of group 0, which use the block's axis words in their own way.
  enum class OneShot : std::uint8_t {
    none,
    dwell,
    set_data,
    reference,
    second_reference,
    machine_coordinates,
    shift_position,
    clear_shift,
    suspend_shift,
    restore_shift,
    local_shift,
    tool_offset
  };
  /// What one block asks for.
  struct Plan {
    std::uint32_t groups = 0;  ///< modal groups seen
    OneShot one_shot = OneShot::none;
    std::size_t column = 0;  ///< of the one-shot code
    std::size_t motion_column = 0;
    bool motion_named = false;
    bool exact_stop = false;
    int set_codes = 0;  ///< G10 L
  };

  // word_program.cpp: lines and blocks
  bool end_of_text();
  bool percent(std::string_view line, std::size_t at);
  bool execute();
  bool feed_speed_tool();
  bool leftovers();
  void read_tcp_switches(const std::vector<std::string>& lines, bool on);
  bool fault(std::size_t column, std::string_view code, const std::string& text) {
    return reading_.diagnosis.fault(column, code, text);
  }

  // word_codes.cpp: what the codes mean
  bool apply_g(Code code);
  bool apply_mode(Code code);
  bool apply_length(Code code);
  bool apply_path_mode(Code code);
  bool one_shot(Code code, OneShot what);
  bool set_group(Code code, int group);
  bool choose_work_offset(Code code);
  bool work_offset(Code code, int system);

  // word_m_codes.cpp
  bool apply_m_before(Code code);
  bool apply_m_after(Code code);
  bool machine_m(Code code, bool& known);
  bool refuse_g(Code code);
  [[nodiscard]] std::string unknown_code(const char* letter) const;
  bool switch_tcp(Code code, bool on);
  bool tool_change(Code code);

  // word_motion.cpp: where the words lead
  bool axis_words(MoveWords& out);
  bool motion();
  bool straight(MotionKind kind);
  bool arc(bool clockwise);
  bool run_one_shot();
  bool dwell();
  bool reference(bool second);
  bool shift_position();
  std::optional<double> stands_at(int axis, const char* code);
  bool tool_offset();
  bool refuse_tcp_with_offset(std::size_t column);
  bool set_data();
  bool tool_axis(MoveWords& out);
  void update_shift();

  // word_cycles.cpp: drilling
  struct Cycle {
    int code = 0;
    std::optional<double> r_mm, z_mm, q_mm;  ///< they hold from block to block
    double dwell_s = 0.0;
    std::optional<double> initial_z_mm;  ///< where Z stood before the first hole
  };
  bool begin_cycle(Code code);
  bool cycle_words(std::int64_t& repeats);
  bool drill();
  bool drill_hole();
  bool go_z(MotionKind kind, double z_mm);
  bool decimal_point(char letter);
  bool emit(bool ok, MotionBlock& block);

  Reading& reading_;
  MotionState& state_;
  kinematics::DialectFamily family_;
  bool linuxcnc_;
  Parameters parameters_;
  WordLexer lexer_;
  OwordFlow owords_;
  FanucFlow subprograms_;
  Block block_;
  Plan plan_;
  MotionMode mode_ = MotionMode::none;
  bool arc_centre_absolute_ = false;
  bool vector_words_ = false;  ///< I J K are the tool axis (G43.5)
  bool percent_open_ = false, any_block_ = false, program_number_seen_ = false;
  Cycle cycle_;
  bool return_to_r_ = false;  ///< G99: between holes Z returns to R, not to where it stood before
  int tool_prepared_ = 0;
  int work_system_ = 1;
  std::array<Shift, 10> work_;          ///< 1 .. 9: G54 .. G59.3
  Shift position_shift_;                ///< G92, G52
  Shift saved_shift_;                   ///< what G92.3 brings back
  Vec3 tool_offset_mm_ = Vec3::Zero();  ///< G43.1: what the control's length has more than the tool's
  std::vector<int> tcp_on_m_, tcp_off_m_;
  std::vector<std::array<double, 2>> tcp_on_outputs_, tcp_off_outputs_;  ///< M68 E Q
};

}  // namespace volute::sim
