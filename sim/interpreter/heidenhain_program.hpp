// Heidenhain conversational programs (iTNC 530, TNC 640, TNC 7).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/interpreter/dialect.hpp"
#include "sim/interpreter/formula.hpp"

namespace volute::sim {

class HeidenhainProgram final : public Dialect {
 public:
  explicit HeidenhainProgram(Reading& reading) : reading_(reading), state_(reading.state) {}
  bool advance() override;

 private:
  /// One coordinate of a block.
  struct Coordinate {
    double value = 0.0;
    bool given = false, incremental = false;
    std::size_t column = 0;
  };
  /// The words of a positioning block.
  struct Words {
    std::array<Coordinate, 5> axes;
    std::array<std::optional<double>, 3> normal, tool;
    std::optional<double> feed, radius;
    std::optional<bool> clockwise;
    bool rapid = false, machine = false, reduce_turns = false, tcp_here = false;
    std::size_t vector_column = 0, feed_column = 0;
    std::vector<int> after;
  };
  struct Call {
    LineMark back;
  };

  // heidenhain_words.cpp: tokens
  void skip_blanks();
  [[nodiscard]] bool at_end();
  std::string name();  ///< the letters here, upper case; `at_` behind them
  bool number(double& out);
  bool integer(std::int64_t& out, std::int64_t least, std::int64_t most);
  bool expect_end();
  bool accept(std::string_view text);  ///< moves over `text` (any case) when it stands here as a whole word
  bool words(bool straight);
  bool word(bool straight);
  bool coordinate(const std::string& name, std::size_t column);
  bool feed(std::size_t column);
  bool m_function(std::size_t column);
  bool m_mode(int number, std::size_t column);

  // heidenhain_program.cpp: blocks
  bool statement();
  bool begin_program();
  bool end_program();
  bool straight_line();
  bool circle(bool by_radius);
  bool circle_centre();
  bool finish_block();
  bool move_words(MoveWords& out);
  bool tool_axis(MoveWords& out);
  void reduce_turns();
  bool tool_call();
  bool stop();

  // heidenhain_flow.cpp: functions, cycles, labels, Q parameters
  bool function();
  bool tcpm();
  bool plane();
  bool cycle_definition();
  bool tolerance(std::int64_t part);
  bool datum_shift(std::int64_t part);
  bool label();
  bool call();
  bool q_function();
  bool q_assignment();
  bool q_jump(std::int64_t which);
  bool go_to_label(const std::string& label, LineMark& out);
  bool label_name(std::string& out);
  bool jump(LineMark mark);
  bool set_tcp(bool on, std::size_t column);

  bool fault(std::size_t column, std::string_view code, const std::string& text) {
    return reading_.diagnosis.fault(column, code, text);
  }
  bool unknown(std::size_t column, const std::string& name, const std::string& why) {
    return fault(column, "program-unknown-word", name + ": " + why);
  }

  Reading& reading_;
  MotionState& state_;
  std::string_view line_;
  std::size_t at_ = 0;
  Variables variables_;
  Words words_;
  std::array<std::optional<double>, 2> pole_mm_;
  bool shortest_way_ = false;
  bool begun_ = false;
  double dwell_s_ = 0.0;
  // labels and calls
  bool labels_indexed_ = false;
  std::map<std::string, LineMark> labels_;
  std::vector<Call> calls_;
  std::map<std::int64_t, std::int64_t> repeats_;  ///< line of the call: how often still
  std::int64_t jumps_ = 0;
};

}  // namespace volute::sim
