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
  int source = 0;  ///< index in the piece
};

/// Points closer than a nanometre to the one before are left out. The feed is the chord over `window_mm` to both sides.
std::vector<Station> make_stations(const CcPiece& piece, double window_mm);

/// Lifts the contact along the normal where the ball of the cutter goes deeper than `tolerance_mm` into the part (an
/// inner corner narrower than the cutter): no orientation could mend that. Nothing for flat and bull cutters.
void lift_out_of_part(std::vector<Station>& stations, const kinematics::Cutter& cutter,
                      const Interference& interference, double tolerance_mm);

}  // namespace volute::planner
