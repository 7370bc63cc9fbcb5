#include "planner/orientation_maps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <tbb/parallel_for.h>

namespace volute::planner {

using kinematics::OrientationMap;

namespace {

// Between stations that are asked for the worst, and between two of the worst, mm along the path.
constexpr double ask_every_mm = 1.0, apart_mm = 5.0;
// A share takes up to milliseconds: on long paths first so many places.
constexpr int places_max = 200;

struct CutPoint {
  kinematics::ToolPathPoint point;
  RotaryPair rotaries;
};

/// Stations of the plan's own contacts, which stand where the ball was lifted to.
std::vector<Station> stations_of(const std::vector<CutPoint>& cuts) {
  constexpr double feed_window_mm = 1.0;
  CcPiece piece;
  for (const CutPoint& cut : cuts) {
    CcPoint point;
    point.point_P_mm = cut.point.contact_P_mm;
    point.normal_P = cut.point.normal_P;
    point.turn = cut.point.turn;
    point.link = cut.point.move == kinematics::MoveKind::link;
    piece.points.push_back(point);
  }
  return make_stations(piece, feed_window_mm);
}

std::vector<CutPoint> cuts_of(const PlanResult& plan) {
  std::vector<CutPoint> cuts;
  const std::vector<char> on_surface = [&] {
    std::vector<char> marks;
    for (const auto& point : plan.tool_path.points)
      marks.push_back(point.move == kinematics::MoveKind::cut || point.move == kinematics::MoveKind::link ? 1 : 0);
    return marks;
  }();
  // The first point of a piece is reached by an approach, and has rotaries too.
  std::size_t rotary = 0;
  for (std::size_t k = 0; k < plan.tool_path.points.size() && rotary < plan.rotaries_rad.size(); ++k) {
    const bool first = on_surface[k] == 0 && k + 1 < on_surface.size() && on_surface[k + 1] != 0;
    if (on_surface[k] != 0 || first) cuts.push_back({plan.tool_path.points[k], plan.rotaries_rad[rotary++]});
  }
  return cuts;
}

/// Stations from `from_mm` to `to_mm`, none nearer than `step_mm` to the one before.
std::vector<int> places_every(const AllowedSet& allowed, double from_mm, double to_mm, double step_mm) {
  std::vector<int> places;
  double next_mm = from_mm;
  for (int i = 0; i < static_cast<int>(allowed.stations().size()); ++i) {
    const double s = allowed.stations()[static_cast<std::size_t>(i)].s_mm;
    if (s < next_mm || s > to_mm) continue;
    places.push_back(i);
    next_mm = s + step_mm;
  }
  return places;
}

/// Of the places that are no farther than `step_mm` from i, 1 mm apart, the narrowest.
int narrowest_beside(const AllowedSet& allowed, int i, double step_mm) {
  const double s = allowed.stations()[static_cast<std::size_t>(i)].s_mm;
  std::vector<int> places = places_every(allowed, s - step_mm, s + step_mm, ask_every_mm);
  places.push_back(i);
  return NarrowestSearch(allowed, places).next().value_or(i);
}

/// First all along the path, at most places_max, then round the narrowest of these.
std::vector<int> worst_points(const AllowedSet& allowed, std::vector<int> taken, int count) {
  std::vector<int> worst;
  if (count == 0) return worst;
  const double length_mm = allowed.stations().back().s_mm;
  const double step_mm = std::max(ask_every_mm, length_mm / places_max);
  const std::vector<int> asked = places_every(allowed, 0.0, length_mm, step_mm);
  NarrowestSearch search(allowed, asked);
  const auto s = [&](int i) { return allowed.stations()[static_cast<std::size_t>(i)].s_mm; };
  const auto is_beside = [&](int i) {
    return std::any_of(taken.begin(), taken.end(), [&](int other) { return std::abs(s(other) - s(i)) < apart_mm; });
  };
  while (static_cast<int>(worst.size()) < count) {
    const std::optional<int> narrow = search.next();
    if (!narrow) break;
    if (is_beside(*narrow)) continue;
    const int place = step_mm > ask_every_mm ? narrowest_beside(allowed, *narrow, step_mm) : *narrow;
    if (is_beside(place)) continue;
    worst.push_back(place);
    taken.push_back(place);
  }
  return worst;
}

/// Endless rotaries are drawn within one turn.
std::array<double, 2> drawn_rotaries(const RotaryChart& chart, const RotaryPair& at) {
  const auto drawn = [&](int k) {
    const double value = at[static_cast<std::size_t>(k)];
    return chart.is_endless(k) ? std::remainder(value, 2.0 * std::numbers::pi) : value;
  };
  return {drawn(1), drawn(0)};
}

/// What the plan chose at the point and round it, as seen from this point's feed frame.
void add_choice(const AllowedSet& allowed, const std::vector<CutPoint>& cuts, int i, double neighbours_mm,
                OrientationMap& map) {
  const auto stations = allowed.stations();
  const Station& here = stations[static_cast<std::size_t>(i)];
  for (std::size_t k = 0; k < stations.size(); ++k) {
    if (std::abs(stations[k].s_mm - here.s_mm) > neighbours_mm) continue;
    const CutPoint& cut = cuts[static_cast<std::size_t>(stations[k].source)];
    const FeedFrame frame = feed_frame(stations[k].feed_P, stations[k].normal_P);
    const Vec3& axis = cut.point.pose.axis_P;
    const std::array<double, 2> lean = {std::atan2(axis.dot(frame.across_P), axis.dot(frame.feed_P)),
                                        std::atan2(axis.cross(frame.normal_P).norm(), axis.dot(frame.normal_P))};
    map.lean.path.push_back(lean);
    map.rotaries.path.push_back(drawn_rotaries(allowed.chart(), cut.rotaries));
    if (static_cast<int>(k) != i) continue;
    map.lean.chosen = lean;
    map.rotaries.chosen = map.rotaries.path.back();
    map.margin_rad = free_turn_rad(allowed, i, axis);
  }
}

}  // namespace

geometry::Result<std::vector<OrientationMap>> orientation_maps(const PlanRequest& request, const PlanResult& plan,
                                                               const MapRequest& maps) {
  const std::vector<CutPoint> cuts = cuts_of(plan);
  const std::vector<Station> stations = stations_of(cuts);
  const Interference interference(request.scene, request.tool, &request.machine, &request.setup);
  const RotaryChart chart(request.machine, request.setup);
  const AllowedSet allowed(stations, request.tool, chart, interference, request.orientation);
  std::vector<int> wanted;
  for (const int cut : maps.cut_points) {
    const auto found =
        std::find_if(stations.begin(), stations.end(), [&](const Station& s) { return s.source >= cut; });
    if (cut < 0 || found == stations.end())
      return geometry::bad_input("map-point", "CC point " + std::to_string(cut) + " is not on the path, which has " +
                                                  std::to_string(cuts.size()) + " of them; choose one from 0 on");
    wanted.push_back(static_cast<int>(found - stations.begin()));
  }
  const std::vector<int> worst = worst_points(allowed, wanted, maps.worst);
  wanted.insert(wanted.end(), worst.begin(), worst.end());
  std::vector<OrientationMap> made(wanted.size());
  tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t k) {
    made[k] = orientation_map(allowed, wanted[k], maps.cspace);
    add_choice(allowed, cuts, wanted[k], maps.neighbours_mm, made[k]);
  });
  return made;
}

}  // namespace volute::planner
