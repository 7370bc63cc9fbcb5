// The axes over time as plots: the run for a person.
#pragma once

#include "view/plot.hpp"
#include "view/run_view.hpp"

namespace volute::view {

/// Position, velocity, acceleration and jerk of both rotary axes over time, with their limits. Requires: view.profile
/// and a trace.
Plot rotary_plot(const RunView& view);
/// The same of X, Y and Z.
Plot linear_plot(const RunView& view);
/// Speed of the tip over time.
Plot feed_plot(const RunView& view);
/// Speed of the tip, and velocity and acceleration of both rotary axes, over the length of the cutting path ([Sun2016]
/// Fig. 20).
Plot path_plot(const RunView& view);
/// Force of every linear drive and torque of every rotary one over time. Requires: a machine with masses.
Plot loads_plot(const RunView& view);
/// How much of the surface has which deviation. Requires: view.cut with a histogram.
Plot deviation_plot(const RunView& view);

}  // namespace volute::view
