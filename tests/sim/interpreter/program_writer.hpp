// Programs at random, seeded, for comparing two interpreters.
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "geometry/number_text.hpp"

namespace volute::sim::test {

using geometry::fixed_text;

/// Writes programs at random: every modal group that finishing programs use, arcs, parameters, loops, drilling.
class ProgramWriter {
 public:
  explicit ProgramWriter(unsigned seed) : random_(seed) {}

  std::string write() {
    out_ = "G21 G90 G94 G17 G40 G49 G80 G92.1\nG43.1 Z0\nG0 X0 Y0 Z10 A0 C0\nG1 F100 X1\n";
    for (int i = 0; i < 60; ++i) line();
    return out_ + "M2\n";
  }

 private:
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  double number(double most) { return std::uniform_real_distribution<double>(-most, most)(random_); }
  std::string text(double most) {
    const double value = number(most);
    switch (pick(6)) {
      case 0:
        return "[" + fixed_text(value, 2) + "+" + fixed_text(number(5.0), 2) + "*2]";
      case 1:
        return "#7";
      case 2:
        return "[sin[" + fixed_text(value, 1) + "]*" + fixed_text(most, 1) + "]";
      default:
        return fixed_text(value, 3);
    }
  }
  void feed() {
    if (inverse_) out_ += " F" + fixed_text(std::abs(number(30.0)) + 1.0, 2);
    if (!inverse_ && pick(4) == 0) out_ += " F" + fixed_text(std::abs(number(900.0)) + 1.0, 1);
  }
  void straight() {
    const bool cuts = pick(2) == 0;
    out_ += cuts ? "G1" : "G0";
    if (cuts) feed();
    bool any = false;
    for (const char letter : std::string("XYZAC"))
      if (pick(5) < 2) out_ += ' ' + std::string(1, letter) + text(letter < 'X' ? 90.0 : 40.0), any = true;
    if (!any) out_ += " X" + text(40.0);
  }
  void arc() {
    const int plane = pick(3);
    out_ += plane == 0 ? "G17 " : plane == 1 ? "G18 " : "G19 ";
    out_ += pick(2) == 0 ? "G2" : "G3";
    feed();
    const std::array<const char*, 3> axes{"XYZ", "ZXY", "YZX"};
    const std::array<const char*, 3> offsets{"IJ", "KI", "JK"};
    const auto in = static_cast<std::size_t>(plane);
    const double radius = std::abs(number(9.0)) + 0.5;
    if (pick(3) == 0) {  // a full circle, or several
      out_ += std::string(" ") + offsets[in][0] + fixed_text(radius, 3);
      if (pick(2) == 0) out_ += " P" + std::to_string(1 + pick(3));
      return;
    }
    const double angle = number(3.0);
    const double first = radius * (1.0 - std::cos(angle)), second = -radius * std::sin(angle);
    const auto end = [&](char letter, double distance) {
      const std::string value = fixed_text(distance, 5);
      return std::string(" ") + letter +
             (incremental_ ? value : "[#" + std::to_string(5420 + letter - 'X') + "+" + value + "]");
    };
    out_ += end(axes[in][0], first) + end(axes[in][1], second) + " " + offsets[in][0] + fixed_text(radius, 5);
    if (pick(3) == 0) out_ += std::string(" ") + axes[in][2] + (incremental_ ? "1.5" : fixed_text(number(9.0), 3));
    if (pick(4) == 0) out_ += " C" + fixed_text(number(90.0), 3);
  }
  void modes() {
    switch (pick(13)) {
      case 0:
        // rs274 without a control behind it takes an offset that is in force for one in the new unit.
        out_ += std::string("G43.1 X0 Y0 Z0\n") + (pick(2) == 0 ? "G20" : "G21");
        break;
      case 1:
        incremental_ = pick(2) == 0;
        out_ += incremental_ ? "G91" : "G90";
        break;
      case 2:
        inverse_ = pick(2) == 0;
        out_ += inverse_ ? "G93" : "G94 F" + fixed_text(std::abs(number(500.0)) + 1.0, 1);
        break;
      case 3:
        out_ += "G92 X" + text(20.0) + " C" + text(90.0);
        break;
      case 4:
        out_ += "G4 P" + fixed_text(std::abs(number(2.0)), 2);
        break;
      case 5:
        out_ += "#7=" + text(20.0);
        break;
      case 6:
        out_ += "G92.1";
        break;
      case 7:
        out_ += pick(2) == 0 ? "G92.2" : "G92.3";
        break;
      case 8:
        out_ += "G92 Y" + text(20.0) + " A" + text(90.0);
        break;
      case 9:
        out_ += "G43.1 Z" + text(60.0);
        break;
      case 10:
        out_ += "G43.1 X" + text(3.0) + " Y" + text(3.0);
        break;
      case 11:
        out_ += pick(2) == 0 ? "G61" : "G64 P0.01";
        break;
      default:
        out_ += "(a remark) T1 S500 M3 M8";
        break;
    }
  }
  void loop() {
    const std::string label = "o" + std::to_string(100 + labels_++) + " ";
    out_ += label + "repeat [" + std::to_string(pick(4)) + "]\n";
    straight();
    out_ += "\n" + label + "endrepeat";
  }
  void branch() {
    const std::string label = "o" + std::to_string(100 + labels_++) + " ";
    out_ += label + "if [#7 gt " + fixed_text(number(9.0), 1) + "]\n";
    straight();
    out_ += "\n" + label + "else\n";
    straight();
    out_ += "\n" + label + "endif";
  }
  void drill() {
    if (incremental_ || inverse_) return;
    const std::array<const char*, 5> cycles{"G81", "G82 P0.5", "G83 Q1.7", "G73 Q1.7", "G85"};
    out_ += std::string("G17 ") + (pick(2) == 0 ? "G98 " : "G99 ") + cycles[static_cast<std::size_t>(pick(5))] + " X" +
            text(30.0) + " Z" + fixed_text(-3.0 - pick(4), 2) + " R" + fixed_text(1.0 + pick(3), 2) + "\nX" +
            text(30.0) + " Y" + text(30.0) + "\nG80";
  }
  void line() {
    const int kind = pick(12);
    if (kind < 5)
      straight();
    else if (kind < 7)
      arc();
    else if (kind < 9)
      modes();
    else if (kind == 9)
      loop();
    else if (kind == 10)
      branch();
    else
      drill();
    out_ += '\n';
  }

  std::mt19937 random_;
  std::string out_;
  bool incremental_ = false, inverse_ = false;
  int labels_ = 0;
};

}  // namespace volute::sim::test
