#include "planner/orientation/stations.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace volute::planner {

namespace {

constexpr double least_step_mm = 1e-6;
constexpr int lift_rounds_max = 30;
// Of the gouge tolerance, what a point may use; the rest is for the ways between points.
constexpr double share_of_points = 0.9;
// Ways between points shorter than this are not halved, even where there is no tolerance.
constexpr double least_way_mm = 0.01;

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

Station midway(const Station& a, const Station& b, double ball_radius_mm) {
  Station middle = a;
  const Vec3 normal = a.normal_P + b.normal_P;
  if (normal.norm() > 1e-9) middle.normal_P = normal.normalized();
  const Vec3 centre_P_mm = 0.5 * (a.contact_P_mm + b.contact_P_mm + ball_radius_mm * (a.normal_P + b.normal_P));
  middle.contact_P_mm = centre_P_mm - ball_radius_mm * middle.normal_P;
  const auto square = [&](const Vec3& feed) { return Vec3(feed - feed.dot(middle.normal_P) * middle.normal_P); };
  Vec3 feed = square(a.feed_P + b.feed_P);
  if (feed.norm() < 1e-9) feed = square(a.feed_P);
  middle.feed_P = feed.norm() < 1e-9 ? any_tangent(middle.normal_P) : Vec3(feed.normalized());
  middle.s_mm = 0.5 * (a.s_mm + b.s_mm);
  middle.turn = 0.5 * (a.turn + b.turn);
  middle.link = b.link;
  middle.between = true;
  middle.lift_mm = 0.0;
  return middle;
}

/// Keeps the ball of a cutter out of the part, at stations and on the straight way of its centre between them.
class BallLift {
 public:
  BallLift(const kinematics::Cutter& cutter, const Interference& interference, double tolerance_mm)
      : cutter_(cutter), interference_(interference), tolerance_mm_(tolerance_mm) {}

  /// Lifts the contact along the normal until the ball is no deeper than a point may be; how deep it is then.
  double raise(Station& station) const {
    const double most = share_of_points * tolerance_mm_;
    double depth = depth_mm(station);
    for (int round = 0; round < lift_rounds_max && depth > most; ++round) {
      // Moving by the depth never overshoots where the surface is hit square on; on slanted walls it takes some rounds.
      const double step = depth - 0.5 * tolerance_mm_;
      station.contact_P_mm += step * station.normal_P;
      station.lift_mm += step;
      depth = depth_mm(station);
    }
    return depth;
  }

  /// Appends to `between` what has to stand between a and b, so that the whole way keeps the tolerance.
  void follow(const Station& a, double depth_a_mm, const Station& b, double depth_b_mm,
              std::vector<Station>& between) const {
    const double r = cutter_.radius_mm;
    const double way_mm = (a.contact_P_mm - b.contact_P_mm + r * (a.normal_P - b.normal_P)).norm();
    if (way_mm <= least_way_mm || deepest_mm(depth_a_mm, depth_b_mm, way_mm) <= tolerance_mm_) return;
    Station middle = midway(a, b, r);
    const double depth = raise(middle);
    const std::size_t before = between.size();
    follow(a, depth_a_mm, middle, depth, between);
    const std::size_t place = between.size();
    between.push_back(middle);
    follow(middle, depth, b, depth_b_mm, between);
    // What lies on a straight way that stays straight is not needed.
    if (middle.lift_mm == 0.0 && place == before && between.size() == place + 1) between.pop_back();
  }

 private:
  [[nodiscard]] double depth_mm(const Station& station) const {
    return interference_.tip_depth_mm(contact_pose(cutter_, station.contact_P_mm, station.normal_P, station.normal_P));
  }

  /// Bounds how deep the ball stands anywhere between two places. From any point of the part the squared distance to
  /// the centre is at t of the way the mean of its values at both ends less t (1 - t) way^2, so the least of them all
  /// is no less than that of the least ones.
  [[nodiscard]] double deepest_mm(double depth_a_mm, double depth_b_mm, double way_mm) const {
    const double r = cutter_.radius_mm, way_sq = way_mm * way_mm;
    const double a_sq = (r - depth_a_mm) * (r - depth_a_mm), b_sq = (r - depth_b_mm) * (r - depth_b_mm);
    const double t = std::clamp(0.5 - 0.5 * (b_sq - a_sq) / way_sq, 0.0, 1.0);
    return r - std::sqrt(std::max(a_sq + t * (b_sq - a_sq) - t * (1.0 - t) * way_sq, 0.0));
  }

  const kinematics::Cutter& cutter_;
  const Interference& interference_;
  double tolerance_mm_;
};

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
  if (cutter.shape != kinematics::CutterShape::ball && cutter.shape != kinematics::CutterShape::taper_ball) return;
  const BallLift lift(cutter, interference, tolerance_mm);
  std::vector<double> depth_mm(stations.size());
  tbb::parallel_for(std::size_t{0}, stations.size(), [&](std::size_t i) { depth_mm[i] = lift.raise(stations[i]); });
  std::vector<std::vector<Station>> between(stations.size());
  tbb::parallel_for(std::size_t{1}, stations.size(), [&](std::size_t i) {
    lift.follow(stations[i - 1], depth_mm[i - 1], stations[i], depth_mm[i], between[i]);
  });
  std::vector<Station> all;
  all.reserve(stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    all.insert(all.end(), between[i].begin(), between[i].end());
    all.push_back(stations[i]);
  }
  stations = std::move(all);
}

}  // namespace volute::planner
