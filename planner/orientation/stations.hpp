// The path as the orientation sees it: arc length, smoothed feed frames, contact lifted where the ball does not fit.
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/tool.hpp"
#include "planner/contact.hpp"
#include "planner/interference.hpp"
#include "planner/path/cc_path.hpp"

namespace volute::planner {

struct Station {
  Vec3 contact_P_mm = Vec3::Zero();  ///< lifted along the normal where the ball would gouge
  Vec3 normal_P = Vec3::UnitZ();
  Vec3 feed_P = Vec3::UnitX();  ///< smoothed, unit, square to the normal
  double s_mm = 0.0;            ///< arc length of the contact path
  double turn = 0.0;
  double lift_mm = 0.0;
  bool link = false;
  int source = 0;        ///< index in the piece
  bool between = false;  ///< put in after `source`: the way to the next point would gouge
};

/// Points closer than a nanometre to the one before are left out. The feed is the chord over `window_mm` to both sides.
std::vector<Station> make_stations(const CcPiece& piece, double window_mm);

/// Keeps the ball of the cutter within `tolerance_mm` of the part (an inner corner narrower than the cutter, a chord
/// over a crest): no orientation could mend that. Contacts where it goes deeper than nine tenths of that are lifted
/// along the normal; where the way to the next one would go deeper than the whole, lifted stations are put in. Nothing
/// for flat and bull cutters, whose depth depends on the axis. Property, with a test of that name:
/// BallKeepsTheToleranceOnTheWholeWay: the centre of the ball, moved straight from station to station, comes nowhere
/// nearer to the part than its radius less `tolerance_mm` (but for ways under 0.01 mm).
void lift_out_of_part(std::vector<Station>& stations, const kinematics::Cutter& cutter,
                      const Interference& interference, double tolerance_mm);

}  // namespace volute::planner
