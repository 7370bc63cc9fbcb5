// Rotary positions as the control takes them. Private to post.
#pragma once

#include "kinematics/inverse/inverse.hpp"
#include "kinematics/model/control.hpp"

namespace volute::post {

/// The number that the program carries for a rotary position, degrees: the position itself, or, where the control takes
/// a rotary without ends modulo one turn (Control::rotary_shortest_way), its place in [0, 360).
double rotary_word_deg(const kinematics::Control& control, const kinematics::Axis& axis, double position_rad);

/// Such a control goes the short way: steps of half a turn or more are cut into shorter ones, else it would turn
/// backwards.
kinematics::AxisPath split_long_turns(const kinematics::Machine& machine, const kinematics::Setup& setup,
                                      double tool_length_mm, const kinematics::AxisPath& path);

}  // namespace volute::post
