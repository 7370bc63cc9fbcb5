// The machine and the limits under which LinuxCNC itself was run, and a program on the model of its planner.
#pragma once

#include <array>
#include <cmath>

#include "tests/sim/controller/test_machines.hpp"

namespace volute::sim::test {

struct ModelRun {
  std::int64_t cycles = 0;                       ///< from the first to the last motion of an axis
  std::vector<std::array<double, 5>> positions;  ///< X Y Z mm, A C deg, each cycle from standstill on
};

/// X Y Z 200 mm/s and 1000 mm/s^2, A C 60 deg/s and 300 deg/s^2; all coordinates start at 0.
inline kinematics::Machine plain_five_axis_machine() {
  kinematics::Machine machine = head_machine();
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    const bool rotary = i >= 3;
    machine.axes[i].velocity_max = rotary ? 60 * degree : 200;
    machine.axes[i].acceleration_max = rotary ? 300 * degree : 1000;
  }
  return machine;
}

inline kinematics::Control linuxcnc_control() {
  kinematics::Control control;
  control.name = "linuxcnc";
  control.family = kinematics::DialectFamily::linuxcnc;
  control.linuxcnc_planner = true;
  control.look_ahead_blocks = 50;
  return control;
}

inline Result<ModelRun> run_on_model(std::string_view program_text) {
  const kinematics::Machine machine = plain_five_axis_machine();
  const kinematics::Control control = linuxcnc_control();
  ControlSetup setup;
  setup.machine = &machine;
  setup.control = &control;
  const AxisVector zero = kinematics::program_zero(machine, setup.setup, 0.0);
  setup.start = zero;
  // The real control knows where it stands; the text has to say it.
  const std::string text = "G21 G90 G0 X0 Y0 Z0 A0 C0\n" + std::string(program_text);
  ProgramReader reader(text, "program", machine, control);
  ModelRun run;
  const auto take = [&](std::span<const AxisSample> samples) {
    for (const AxisSample& sample : samples) {
      const AxisVector q = sample.position - zero;
      run.positions.push_back({q[0], q[1], q[2], q[3] / degree, q[4] / degree});
    }
  };
  if (auto report = run_program(reader, setup, take); !report) return tl::unexpected(report.error());
  std::size_t first = 0, last = 0;
  for (std::size_t k = 1; k < run.positions.size(); ++k) {
    if (run.positions[k] == run.positions[k - 1]) continue;
    if (last == 0) first = k - 1;
    last = k;
  }
  run.cycles = static_cast<std::int64_t>(last - first);
  run.positions.erase(run.positions.begin(), run.positions.begin() + static_cast<std::ptrdiff_t>(first));
  return run;
}

}  // namespace volute::sim::test
