#include "planner/orientation/narrowest.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <tbb/parallel_for.h>

namespace volute::planner {

using geometry::Angle;

namespace {

constexpr double raster_rad = std::numbers::pi / 36.0;
// Asked at once of one station, and so many stations together.
constexpr int directions_at_once = 24;
constexpr std::size_t stations_at_once = 4;

template <typename Ask>
void for_raster(const AllowedSet& allowed, const Ask& ask) {
  const auto [least, most] = allowed.tilt_limits();
  for (double tilt = least; tilt <= most; tilt += raster_rad) {
    const int round = std::max(1, static_cast<int>(std::ceil(2.0 * std::numbers::pi * std::sin(tilt) / raster_rad)));
    for (int k = 0; k < round; ++k) ask(Angle::radians(tilt), Angle::radians(2.0 * std::numbers::pi * k / round));
  }
}

bool is_allowed(const AllowedSet& allowed, int i, Angle tilt, Angle yaw) {
  const Station& station = allowed.stations()[static_cast<std::size_t>(i)];
  return allowed.blocked(i, tool_axis(feed_frame(station.feed_P, station.normal_P), tilt, yaw)) == Blocked::no;
}

}  // namespace

double allowed_share(const AllowedSet& allowed, int i) {
  int tried = 0, found = 0;
  for_raster(allowed, [&](Angle tilt, Angle yaw) {
    ++tried;
    found += is_allowed(allowed, i, tilt, yaw) ? 1 : 0;
  });
  return tried > 0 ? static_cast<double>(found) / tried : 0.0;
}

NarrowestSearch::NarrowestSearch(const AllowedSet& allowed, std::span<const int> stations) : allowed_(allowed) {
  std::vector<Direction> rows;
  for_raster(allowed, [&](Angle tilt, Angle yaw) { rows.push_back({tilt, yaw}); });
  // In strides of the golden section, so that the first few are spread over all.
  const std::size_t count = rows.size();
  std::size_t stride = std::max<std::size_t>(1, static_cast<std::size_t>(0.618 * static_cast<double>(count)));
  while (std::gcd(stride, count) > 1) ++stride;
  for (std::size_t k = 0; k < count; ++k) raster_.push_back(rows[k * stride % count]);
  for (const int i : stations) heap_.push_back({i, static_cast<int>(heap_.size()), 0, 0});
}

bool NarrowestSearch::is_known(const Candidate& candidate) const {
  return candidate.asked == static_cast<int>(raster_.size());
}

int NarrowestSearch::asked() const { return asked_; }

void NarrowestSearch::ask_on(Candidate& candidate) const {
  const int last = std::min(candidate.asked + directions_at_once, static_cast<int>(raster_.size()));
  for (; candidate.asked < last; ++candidate.asked) {
    const Direction& at = raster_[static_cast<std::size_t>(candidate.asked)];
    candidate.free += is_allowed(allowed_, candidate.station, at.tilt, at.yaw) ? 1 : 0;
  }
}

std::optional<int> NarrowestSearch::next() {
  const auto later = [](const Candidate& a, const Candidate& b) {
    return a.free != b.free ? a.free > b.free : a.place > b.place;
  };
  std::make_heap(heap_.begin(), heap_.end(), later);
  std::vector<Candidate> batch;
  while (!heap_.empty()) {
    if (is_known(heap_.front())) {
      const int station = heap_.front().station;
      std::pop_heap(heap_.begin(), heap_.end(), later);
      heap_.pop_back();
      return station;
    }
    batch.clear();
    while (!heap_.empty() && !is_known(heap_.front()) && batch.size() < stations_at_once) {
      std::pop_heap(heap_.begin(), heap_.end(), later);
      batch.push_back(heap_.back());
      heap_.pop_back();
      asked_ -= batch.back().asked;
    }
    tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t k) { ask_on(batch[k]); });
    for (const Candidate& candidate : batch) {
      asked_ += candidate.asked;
      heap_.push_back(candidate);
      std::push_heap(heap_.begin(), heap_.end(), later);
    }
  }
  return std::nullopt;
}

}  // namespace volute::planner
