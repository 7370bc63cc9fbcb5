#include "planner/orientation/turn_means.hpp"

#include <algorithm>
#include <cmath>

#include "planner/contact.hpp"
#include "planner/orientation/stations.hpp"

namespace volute::planner {

namespace {

/// A path whose turns fall by as much as this is no spiral (see reference.cpp, where the same holds for one piece).
constexpr double fall_most = 0.5, least_turns = 1.0;
constexpr double least_length_mm = 1e-6;

}  // namespace

std::optional<TurnMeans> TurnMeans::of(const CcPath& path, const OrientationOptions& options, double feed_window_mm) {
  if (path.pieces.size() < 2) return std::nullopt;
  struct Place {
    double turn, length_mm;
    Vec3 axis_P;
  };
  std::vector<Place> places;
  for (const CcPiece& piece : path.pieces) {
    if (piece.points.size() < 2) continue;
    const std::vector<Station> stations = make_stations(piece, feed_window_mm);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const Station& station = stations[i];
      if (!places.empty() && station.turn < places.back().turn - fall_most) return std::nullopt;
      const double before = i > 0 ? station.s_mm - stations[i - 1].s_mm : 0.0;
      const double behind = i + 1 < stations.size() ? stations[i + 1].s_mm - station.s_mm : 0.0;
      places.push_back({station.turn, std::max(0.5 * (before + behind), least_length_mm),
                        tool_axis(feed_frame(station.feed_P, station.normal_P), options.tilt, options.yaw)});
    }
  }
  if (places.empty() || places.back().turn - places.front().turn <= least_turns) return std::nullopt;
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.turn < b.turn; });
  TurnMeans means;
  means.lengths_.push_back(0.0);
  means.sums_.push_back(Vec3::Zero());
  for (const Place& place : places) {
    means.turns_.push_back(place.turn);
    means.lengths_.push_back(means.lengths_.back() + place.length_mm);
    means.sums_.push_back(means.sums_.back() + place.length_mm * place.axis_P);
  }
  return means;
}

Vec3 TurnMeans::mean(double turn) const {
  const auto from =
      static_cast<std::size_t>(std::lower_bound(turns_.begin(), turns_.end(), turn - 0.5) - turns_.begin());
  const auto to = static_cast<std::size_t>(std::upper_bound(turns_.begin(), turns_.end(), turn + 0.5) - turns_.begin());
  return (sums_[to] - sums_[from]) / std::max(lengths_[to] - lengths_[from], least_length_mm);
}

}  // namespace volute::planner
