// What every control model does around its own work.
#pragma once

#include "sim/controller/control_run.hpp"

namespace volute::sim {

/// Where the axes stand at the machine's zero pose.
inline AxisVector zero_position(const kinematics::Machine& machine) {
  AxisVector q;
  for (int i = 0; i < kinematics::axis_count; ++i) q[i] = machine.axes[static_cast<std::size_t>(i)].zero;
  return q;
}

/// Where the axes stand before the program.
inline AxisVector start_position(const ControlSetup& setup) {
  return setup.start ? *setup.start : zero_position(*setup.machine);
}

/// Feeds `run` (with `Result<void> add(const MotionBlock&)` and `RunReport finish()`) with the whole program.
template <typename Run>
Result<RunReport> run_all(Run&& run, const MotionSource& next, const std::function<void(std::int64_t line)>& progress) {
  constexpr std::int64_t blocks_between_progress = 4096;
  for (std::int64_t count = 1;; ++count) {
    const auto block = next();
    if (!block) return tl::unexpected(block.error());
    if (!*block) return run.finish();
    if (auto done = run.add(**block); !done) return tl::unexpected(done.error());
    if (progress && count % blocks_between_progress == 0) progress((*block)->line);
  }
}

}  // namespace volute::sim
