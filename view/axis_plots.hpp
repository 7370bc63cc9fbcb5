// The axes over time as plots: the run for a person.
#pragma once

#include "view/plot.hpp"
#include "view/run_view.hpp"

namespace volute::view {

/// Position, velocity and acceleration of both rotary axes over time, with their limits. Requires: view.profile and a trace.
Plot rotary_plot(const RunView& view);
/// The same of X, Y and Z.
Plot linear_plot(const RunView& view);
/// Speed of the tip against the programmed feed over time.
Plot feed_plot(const RunView& view);

}  // namespace volute::view
