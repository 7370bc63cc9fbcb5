// How far the path is at every point of the surface: phi counts the turns (or passes) from the outer boundary, the
// coordinate around says where in the turn. The guide lines are the level lines of phi - around ([Sun2016] section 4).
#pragma once

#include <string>
#include <vector>

#include "planner/path/path_interval.hpp"
#include "planner/surface/annulus.hpp"
#include "planner/surface/surface_map.hpp"

namespace volute::planner {

struct GuideField {
  std::vector<double> turns;  ///< phi by vertex of Annulus::ring: 0 on the outer boundary, turn_count on the inner one
  double turn_count = 0.0;
  PeriodicCoordinate around;  ///< by vertex of Annulus::ring: grows by one counter-clockwise around the outer boundary
  MapQuality quality;
  std::vector<geometry::Vec2> map;  ///< the map's vertices for drawings: of Annulus::sheet
  std::vector<std::string> notes;
};

/// [Sun2016]: rectangle map with a fixed seam, one increment for the whole surface, eq. 12 and 13 with the exact
/// interval. Departs from the source: where the smallest increment makes the path longer than 12 times its lower bound
/// (it tends to 0 where a bridge meets a hole, the more the finer the mesh), the smallest share of the area, 1 % at
/// least, that avoids this is left out of the minimum, and a note says so. Errors: as rectangle_map.
Result<GuideField> paper_guide(const Annulus& annulus, const IntervalField& intervals);

/// Cylinder map without a seam; the increment of each turn is the smallest that its own turn needs. Where that makes
/// the path longer than 5 times its lower bound, the smallest share of each turn that avoids it keeps higher scallops,
/// and a note says so. Errors: as cylinder_map.
Result<GuideField> periodic_guide(const Annulus& annulus, const IntervalField& intervals);

}  // namespace volute::planner
