#include "planner/orientation/stations.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace volute::planner {

namespace {

constexpr double least_step_mm = 1e-6;
constexpr int lift_rounds_max = 30;

Vec3 any_tangent(const Vec3& normal) {
  const Vec3 helper = std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  return (helper - helper.dot(normal) * normal).normalized();
}

/// The point of the path at arc length s, from a place near `hint` on.
Vec3 point_at(const std::vector<Station>& stations, double s_mm, std::size_t& hint) {
  while (hint + 2 < stations.size() && stations[hint + 1].s_mm < s_mm) ++hint;
  const Station& a = stations[hint];
  const Station& b = stations[std::min(hint + 1, stations.size() - 1)];
  if (b.s_mm <= a.s_mm) return a.contact_P_mm;
  const double t = std::clamp((s_mm - a.s_mm) / (b.s_mm - a.s_mm), 0.0, 1.0);
  return a.contact_P_mm + t * (b.contact_P_mm - a.contact_P_mm);
}

void set_feeds(std::vector<Station>& stations, double window_mm) {
  std::size_t behind = 0, ahead = 0;
  Vec3 last = any_tangent(stations.front().normal_P);
  for (Station& station : stations) {
    const Vec3 chord =
        point_at(stations, station.s_mm + window_mm, ahead) - point_at(stations, station.s_mm - window_mm, behind);
    Vec3 along = chord - chord.dot(station.normal_P) * station.normal_P;
    if (along.norm() < 1e-3 * window_mm) along = last - last.dot(station.normal_P) * station.normal_P;
    if (along.norm() < 1e-9) along = any_tangent(station.normal_P);
    station.feed_P = last = along.normalized();
  }
}

}  // namespace

std::vector<Station> make_stations(const CcPiece& piece, double window_mm) {
  std::vector<Station> stations;
  stations.reserve(piece.points.size());
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const CcPoint& point = piece.points[i];
    Station station;
    station.contact_P_mm = point.point_P_mm;
    station.normal_P = point.normal_P.normalized();
    station.turn = point.turn;
    station.link = point.link;
    station.source = static_cast<int>(i);
    if (!stations.empty()) {
      const double step = (point.point_P_mm - stations.back().contact_P_mm).norm();
      if (step < least_step_mm) continue;
      station.s_mm = stations.back().s_mm + step;
    }
    stations.push_back(station);
  }
  if (!stations.empty()) set_feeds(stations, window_mm);
  return stations;
}

void lift_out_of_part(std::vector<Station>& stations, const kinematics::Cutter& cutter,
                      const Interference& interference, double tolerance_mm) {
  tbb::parallel_for(std::size_t{0}, stations.size(), [&](std::size_t i) {
    Station& station = stations[i];
    for (int round = 0; round < lift_rounds_max; ++round) {
      const double depth =
          interference.tip_depth_mm(contact_pose(cutter, station.contact_P_mm, station.normal_P, station.normal_P));
      if (depth <= tolerance_mm) return;
      // Moving by the depth never overshoots where the surface is hit square on; on slanted walls it takes some rounds.
      const double step = depth - 0.5 * tolerance_mm;
      station.contact_P_mm += step * station.normal_P;
      station.lift_mm += step;
    }
  });
}

}  // namespace volute::planner
