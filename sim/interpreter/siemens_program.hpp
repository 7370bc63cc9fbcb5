// Siemens SINUMERIK 840D programs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/interpreter/dialect.hpp"
#include "sim/interpreter/formula.hpp"

namespace volute::sim {

/// How the value of an axis is meant: by G90 and G91, AC, IC, DC, ACP, ACN.
enum class SiemensValue : std::uint8_t { modal, absolute, incremental, direct, positive, negative };

struct SiemensAxisWord {
  double value = 0.0;
  SiemensValue mode = SiemensValue::modal;
  std::size_t column = 0;
  bool given = false;
};

class SiemensProgram final : public Dialect {
 public:
  explicit SiemensProgram(Reading& reading) : reading_(reading), state_(reading.state) {}
  bool advance() override;

 private:
  enum class Motion : std::uint8_t { none, rapid, line, clockwise, counter_clockwise };
  /// The words of one block.
  struct Words {
    std::array<SiemensAxisWord, 5> axes;
    std::array<SiemensAxisWord, 3> centre;
    std::array<std::optional<double>, 3> vector;
    std::optional<double> radius, opening, turn, feed, speed;
    std::size_t column = 0, vector_column = 0, feed_column = 0, motion_column = 0;
    bool machine = false, exact_stop = false, dwell = false, motion_named = false;
    bool frame = false, frame_adds = false;
    std::vector<int> m_after;
  };

  // siemens_words.cpp: the line as words
  bool words(std::string_view line, std::size_t at);
  bool word(std::string_view line, std::size_t& at);
  bool address(char letter, double value, std::size_t column);
  bool assignment(std::string_view line, std::size_t& at, const std::string& name, std::size_t column);
  bool axis_value(std::string_view line, std::size_t& at, SiemensAxisWord& out);
  bool string_value(std::string_view line, std::size_t& at, std::string& out);
  bool indexed(const std::string& name, std::size_t column);
  bool call(std::string_view line, std::size_t& at, const std::string& name, std::size_t column);
  bool arguments(std::string_view line, std::size_t& at, std::vector<std::string_view>& out);
  bool tolerance_cycle(const std::vector<std::string_view>& arguments, std::size_t column);
  int axis_of(char letter) const;

  // siemens_codes.cpp: what the codes mean
  bool g_code(double number, std::size_t column);
  bool mode_code(int number, std::size_t column);
  bool m_code(double number, std::size_t column);
  bool keyword(const std::string& name, std::size_t column);
  bool transformation(bool on, std::size_t column);
  bool tool_number(double number, std::size_t column);

  // siemens_program.cpp: blocks as motions
  bool execute();
  bool motion();
  bool frame();
  bool move_words(MoveWords& out);
  bool rotary_word(int rotary, const SiemensAxisWord& word, MoveWords& out);
  bool tool_axis(MoveWords& out);
  bool arc(const MoveWords& moves);
  bool fault(std::size_t column, std::string_view code, const std::string& text) {
    return reading_.diagnosis.fault(column, code, text);
  }
  bool unknown(std::size_t column, const std::string& name, const std::string& why) {
    return fault(column, "program-unknown-word", name + ": " + why);
  }

  Reading& reading_;
  MotionState& state_;
  Variables variables_;
  Words words_;
  Motion mode_ = Motion::none;
  bool feed_in_inches_ = false;
  int tool_prepared_ = 0;
};

}  // namespace volute::sim
