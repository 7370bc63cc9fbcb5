// The end of a spiral in a slit: from the last turn around the slit into it, and along it.
#pragma once

#include <vector>

#include "planner/path/cc_path.hpp"
#include "planner/path/even_domain.hpp"

namespace volute::planner {

/// The slit as one line of vertices, from tip to tip; empty where the centre is a loop or branches.
std::vector<Index> slit_line(const EvenDomain& domain);

/// A closed turn around a slit, one interval outside it, points in the path's order (the slit on the left); the spiral
/// arrives at `begin`.
struct LastTurn {
  std::vector<Vec3> points_mm;
  std::size_t begin = 0;
};

/// Where the path leaves the last turn, and what follows.
struct SlitEnding {
  std::size_t steps = 0;  ///< on from `begin`, more than once around: the last point that still belongs to the turn
  std::vector<Vec3> points_mm;  ///< from there: a half turn to the nearer tip, then the slit to its other tip
};

/// Once around, then on to the first place abreast of a tip and on its far side; from there a Bezier half turn into the
/// slit. The points of the half turn lie near the surface, not on it. Requires: three points at least in `line`; the
/// turn is closed. Properties: 1. Every point of the turn is passed once at least. 2. The path has no reversal: chords
/// of the half turn never point back.
SlitEnding slit_ending(const std::vector<Vec3>& line_mm, const LastTurn& turn, double interval_mm);

}  // namespace volute::planner
