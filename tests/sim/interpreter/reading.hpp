// A program read whole, for tests: machines and controls made in code, so that no data file can hide a fault.
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/model/control.hpp"
#include "sim/interpreter/program.hpp"

namespace volute::sim::test {

constexpr double rad_per_deg = std::numbers::pi / 180.0;

inline kinematics::Machine machine_with(char first, char second) {
  kinematics::Machine machine;
  const std::string letters = std::string("XYZ") + first + second;
  for (std::size_t i = 0; i < 5; ++i) {
    machine.axes[i].letter = letters[i];
    machine.axes[i].kind = i < 3 ? kinematics::AxisKind::linear : kinematics::AxisKind::rotary;
  }
  machine.axes[3].travel_min = -110.0 * rad_per_deg;
  machine.axes[3].travel_max = 110.0 * rad_per_deg;
  return machine;
}

inline kinematics::Control control_of(kinematics::DialectFamily family, bool tcp = true) {
  kinematics::Control control;
  control.family = family;
  control.tcp = tcp;
  if (family == kinematics::DialectFamily::linuxcnc) {
    control.tcp_on = {"M428 (TCP on)"};
    control.tcp_off = {"M429 (TCP off)"};
  }
  return control;
}

struct Reading {
  std::vector<MotionBlock> blocks;
  std::optional<geometry::Error> error;
  std::vector<std::string> warnings;
  std::int64_t lines = 0;

  [[nodiscard]] std::string code() const { return error ? error->code : ""; }
  [[nodiscard]] std::string message() const { return error ? error->message : ""; }
};

inline Reading read(std::string_view text, const kinematics::Machine& machine, const kinematics::Control& control,
                    const ReaderOptions& options = {}, std::size_t most = 1'000'000) {
  ProgramReader reader(text, "p.nc", machine, control, options);
  Reading out;
  while (out.blocks.size() < most) {
    auto next = reader.next();
    if (!next) {
      out.error = next.error();
      break;
    }
    if (!*next) break;
    out.blocks.push_back(**next);
  }
  out.warnings = reader.warnings();
  out.lines = reader.lines_read();
  return out;
}

inline Reading read(std::string_view text, kinematics::DialectFamily family, char first = 'A', char second = 'C') {
  return read(text, machine_with(first, second), control_of(family));
}

/// For LinuxCNC, with a tool of that length and the axes at machine zero, where the program's zero is.
inline Reading read_with_tool(std::string_view text, double tool_length_mm) {
  ReaderOptions options;
  options.work_zero_machine_mm = Vec3::Zero();
  options.tool_length_mm = tool_length_mm;
  options.start = kinematics::AxisVector::Zero();
  return read(text, machine_with('A', 'C'), control_of(kinematics::DialectFamily::linuxcnc), options);
}

}  // namespace volute::sim::test
