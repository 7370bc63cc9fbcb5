// A program under LinuxCNC's own planner.
#pragma once

#include "sim/controller/control_run.hpp"

namespace volute::sim::linuxcnc {

/// As run_motions, moved as LinuxCNC 2.9 moves: its planner on tip (TCP) or axis coordinates, then each joint through
/// the control's interpolator, (p[k-1] + 4 p[k] + p[k+1]) / 6, two cycles behind. The queue is taken to be always full:
/// programs whose blocks are shorter than the interpreter can feed them are slower on the real control. Departs from
/// the source: no feed override, no spindle-synchronised motion, no jerk limit (the control has none), and under TCP
/// the axes' limits may be exceeded, as they are there.
Result<RunReport> run_motions(const MotionSource& next, const ControlSetup& setup, const SampleSink& sink,
                              const std::function<void(std::int64_t line)>& progress);

}  // namespace volute::sim::linuxcnc
