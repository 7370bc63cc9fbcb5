// Machines and programs that the controller's tests share.
#pragma once

#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "sim/controller/control_run.hpp"
#include "tests/cases.hpp"

namespace volute::sim::test {

inline constexpr double degree = std::numbers::pi / 180.0;

inline kinematics::Axis linear_axis(char letter, const Vec3& direction, double velocity, double acceleration,
                                    double jerk) {
  kinematics::Axis axis;
  axis.letter = letter;
  axis.direction_M = direction;
  axis.velocity_max = velocity;
  axis.acceleration_max = acceleration;
  axis.jerk_max = jerk;
  return axis;
}

inline kinematics::Axis rotary_axis(char letter, const Vec3& direction, const Vec3& point, double velocity,
                                    double acceleration, double jerk) {
  kinematics::Axis axis = linear_axis(letter, direction, velocity, acceleration, jerk);
  axis.kind = kinematics::AxisKind::rotary;
  axis.point_M_mm = point;
  return axis;
}

/// Head-head: X Y Z carry C, C carries A, the pivot 150 mm above the gauge line.
inline kinematics::Machine head_machine() {
  kinematics::Machine machine;
  machine.name = "test-head";
  machine.axes = {linear_axis('X', Vec3::UnitX(), 500, 3000, 60000), linear_axis('Y', Vec3::UnitY(), 500, 3000, 60000),
                  linear_axis('Z', Vec3::UnitZ(), 400, 2500, 50000),
                  rotary_axis('A', Vec3::UnitX(), {0, 0, 150}, 1.5, 10, 300),
                  rotary_axis('C', Vec3::UnitZ(), {0, 0, 150}, 2.0, 12, 400)};
  machine.chain = {0, 1, 2, 4, 3};
  machine.rapid_mm_s = 400;
  return machine;
}

/// Table-table: the workpiece stands on C, C on A; positive means tool against workpiece.
inline kinematics::Machine table_machine() {
  kinematics::Machine machine = head_machine();
  machine.name = "test-table";
  machine.axes[3].point_M_mm = {0, 0, -50};
  machine.axes[4].point_M_mm = {0, 0, 0};
  machine.chain = {4, 3, 0, 1, 2};
  machine.table_axes = 2;
  machine.gauge_at_zero_M.translation() = Vec3(0, 0, 300);
  return machine;
}

inline kinematics::Control plain_control() {
  kinematics::Control control;
  control.name = "test";
  control.corner_tolerance_mm = 0.01;
  control.corner_tolerance_rad = 0.001;
  control.acceleration_profile = kinematics::AccelerationProfile::s_curve;
  return control;
}

inline MotionBlock line_to(const Vec3& xyz, double feed, double a = 0.0, double c = 0.0, bool tcp = false) {
  MotionBlock block;
  block.kind = MotionKind::line;
  block.tcp = tcp;
  block.tool_length_active = true;
  block.xyz_mm = xyz;
  block.xyz_programmed = block.xyz_known = {true, true, true};
  block.rotary_rad = {a, c};
  block.rotary_programmed = block.rotary_known = {true, true};
  block.feed = feed;
  return block;
}

inline MotionSource source_of(std::vector<MotionBlock> blocks) {
  return [blocks = std::move(blocks), next = std::size_t{0}]() mutable -> Result<std::optional<MotionBlock>> {
    if (next == blocks.size()) return std::optional<MotionBlock>();
    MotionBlock block = blocks[next++];
    if (block.line == 0) block.line = static_cast<std::int64_t>(next);
    return std::optional<MotionBlock>(block);
  };
}

struct Ran {
  RunReport report;
  std::vector<AxisSample> samples;
};

/// `start` nothing: where the program's origin is.
inline Ran run_blocks(const kinematics::Machine& machine, const kinematics::Control& control,
                      std::vector<MotionBlock> blocks) {
  ControlSetup setup;
  setup.machine = &machine;
  setup.control = &control;
  setup.tool_length_mm = 100.0;
  setup.start = kinematics::program_zero(machine, setup.setup, setup.tool_length_mm);
  Ran run;
  auto report = run_motions(source_of(std::move(blocks)), setup, [&](std::span<const AxisSample> chunk) {
    run.samples.insert(run.samples.end(), chunk.begin(), chunk.end());
  });
  if (!report) std::abort();
  run.report = *report;
  return run;
}

}  // namespace volute::sim::test
