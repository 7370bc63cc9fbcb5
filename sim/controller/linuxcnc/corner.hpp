// What LinuxCNC's planner does with the corner between two segments.
#pragma once

#include <optional>

#include "sim/controller/linuxcnc/segment.hpp"

namespace volute::sim::linuxcnc {

/// The axes' limits on X Y Z and the planner's settings at their defaults.
struct PlannerLimits {
  Vec3 velocity = Vec3::Constant(no_limit), acceleration = Vec3::Constant(no_limit);
  double cycle_s = 0.001;
  double kink_ratio = 0.1;  ///< of the acceleration that a kink between near-tangent segments may take
  int gap_cycles = 4;       ///< a line shorter than this many cycles is taken into the blend after it
  double ramp_s = 0.01;     ///< tangent segments shorter than this use one acceleration
  int look_ahead = 50;
};

/// Speeds at which two segments may overlap, and the speed of the tool meanwhile.
struct Overlap {
  double before = 0.0, after = 0.0, together = 0.0;
};
Overlap overlap_speeds(const Segment& before, const Segment& after, double target_before, double target_after);

/// Decides how `last` (the newest in the queue) meets `next`, and changes both: tangent, an arc between them (returned;
/// both ends are cut back), overlapping, or stop. `consumed` is set when the arc has taken `last` into itself.
std::optional<Segment> join(Segment& last, Segment& next, const PlannerLimits& limits, bool& consumed);

// ---- arc_blend.cpp

struct ArcBlend {
  Segment segment;        ///< the arc
  Segment before, after;  ///< what is left of the neighbours
  bool consumed = false;
};
/// The arc between two segments of X Y Z, or nothing where none fits.
std::optional<ArcBlend> arc_between(const Segment& before, const Segment& after, const PlannerLimits& limits);

}  // namespace volute::sim::linuxcnc
