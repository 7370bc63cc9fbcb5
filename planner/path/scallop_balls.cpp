#include "planner/path/scallop_balls.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/index.hpp"

namespace volute::planner {

using geometry::at;
namespace {

constexpr double first_reach = 0.6;  ///< of an interval

/// Of point i of a piece and of the way to the next one.
int balls_from(const CcPiece& piece, std::size_t i, double spacing_mm) {
  if (i + 1 == piece.points.size()) return 1;
  const double span_mm = (piece.points[i + 1].point_P_mm - piece.points[i].point_P_mm).norm();
  return std::max(1, static_cast<int>(std::ceil(span_mm / spacing_mm)));
}

void put_balls(const CcPiece& piece, std::size_t i, double radius_mm, std::span<Vec3> centres) {
  const CcPoint& a = piece.points[i];
  centres.front() = a.point_P_mm + radius_mm * a.normal_P;
  for (std::size_t s = 1; s < centres.size(); ++s) {
    const CcPoint& b = piece.points[i + 1];
    const double share = static_cast<double>(s) / static_cast<double>(centres.size());
    const Vec3 normal = ((1.0 - share) * a.normal_P + share * b.normal_P).normalized();
    centres[s] = (1.0 - share) * a.point_P_mm + share * b.point_P_mm + radius_mm * normal;
  }
}

std::vector<Vec3> ball_centres(const CcPath& path, double radius_mm, double spacing_mm) {
  std::vector<Vec3> centres;
  for (const CcPiece& piece : path.pieces) {
    std::vector<std::size_t> first{centres.size()};
    for (std::size_t i = 0; i < piece.points.size(); ++i)
      first.push_back(first.back() + static_cast<std::size_t>(balls_from(piece, i, spacing_mm)));
    centres.resize(first.back());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, piece.points.size(), 512), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        put_balls(piece, i, radius_mm, std::span(centres).subspan(first[i], first[i + 1] - first[i]));
    });
  }
  return centres;
}

}  // namespace

ScallopBalls::ScallopBalls(const CcPath& path, double radius_mm, double interval_mm)
    : along_(ball_centres(path, radius_mm, interval_mm / 20.0)),
      radius_mm_(radius_mm),
      interval_mm_(interval_mm),
      cells_(along_, 0.3 * interval_mm) {
  in_cells_.reserve(along_.size());
  for (Index i : cells_.order()) in_cells_.push_back(along_[at(i)]);
  find_runs();
}

double ScallopBalls::height_mm(Index ball, const ScallopEntry& entry) const {
  const Vec3 to_centre = along_[at(ball)] - entry.point_mm;
  const double along = to_centre.dot(entry.normal);
  const double inside_sq = radius_mm_ * radius_mm_ - (to_centre.squaredNorm() - along * along);
  return inside_sq < 0.0 ? std::numeric_limits<double>::infinity() : along - std::sqrt(inside_sq);
}

/// Takes the ball's height where it is lower.
bool ScallopBalls::lower(const Vec3& centre_mm, Index ball, ScallopEntry& entry) const {
  const Vec3 to_centre = centre_mm - entry.point_mm;
  const double along = to_centre.dot(entry.normal);
  const double inside_sq = radius_mm_ * radius_mm_ - (to_centre.squaredNorm() - along * along);
  if (inside_sq < 0.0) return false;
  // along - sqrt(inside_sq) < height without the root, which few balls are worth.
  const double over = along - entry.height_mm;
  if (over >= 0.0 && inside_sq <= over * over) return false;
  const double height = along - std::sqrt(inside_sq);
  if (height >= entry.height_mm) return false;
  entry.height_mm = height;
  entry.ball = ball;
  return true;
}

[[gnu::flatten]] void ScallopBalls::follow(Index from, double enough_mm, ScallopEntry& entry,
                                           LookedAt& looked_at) const {
  const auto take = [&](Index i) {
    looked_at.extend(along_[at(i)]);
    return lower(along_[at(i)], i, entry);
  };
  take(from);
  for (const Index step : {Index{1}, Index{-1}}) {
    for (Index i = from + step; i >= 0 && i < static_cast<Index>(along_.size()); i += step) {
      if (entry.height_mm < enough_mm || !take(i)) break;
    }
  }
}

void ScallopBalls::begin_with(Index ball, ScallopEntry& entry) const {
  const Vec3 off = along_[at(ball)] - entry.point_mm - radius_mm_ * entry.normal;
  if (off.cwiseAbs().maxCoeff() <= first_reach * interval_mm_) lower(along_[at(ball)], ball, entry);
}

void ScallopBalls::search(double matters_mm, ScallopEntry& entry, LookedAt& looked_at) const {
  within(first_reach * interval_mm_, entry, looked_at);
  for (double reach = 2.0 * first_reach; entry.height_mm > matters_mm && reach < 5.0; reach *= 2.0) {
    const double before = entry.height_mm;
    within(reach * interval_mm_, entry, looked_at);
    if (entry.height_mm == before && before < radius_mm_) break;
  }
}

void ScallopBalls::find_runs() {
  constexpr std::size_t longest = 8;
  const auto& order = cells_.order();
  run_of_.resize(order.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    for (end = begin + 1; end < order.size() && end - begin < longest && order[end] == order[end - 1] + 1;) ++end;
    std::fill(run_of_.begin() + static_cast<std::ptrdiff_t>(begin), run_of_.begin() + static_cast<std::ptrdiff_t>(end),
              static_cast<Index>(run_begin_.size()));
    run_begin_.push_back(begin);
  }
  runs_.resize(run_begin_.size());
  run_begin_.push_back(order.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, runs_.size(), 512), [&](const auto& range) {
    for (std::size_t r = range.begin(); r < range.end(); ++r)
      runs_[r] = run_of(std::span(in_cells_).subspan(run_begin_[r], run_begin_[r + 1] - run_begin_[r]));
  });
}

ScallopBalls::Run ScallopBalls::run_of(std::span<const Vec3> balls) const {
  Run run{balls.front(), balls.back() - balls.front(), 0.0, 0.0};
  const double length_sq = run.chord_mm.squaredNorm();
  if (length_sq > 0.0) run.per_length_sq = 1.0 / length_sq;
  for (const Vec3& ball : balls) run.off_mm = std::max(run.off_mm, std::sqrt(chord_distance_sq(run, ball)));
  run.off_mm += 1e-9 * radius_mm_;  // rounding
  return run;
}

double ScallopBalls::chord_distance_sq(const Run& run, const Vec3& place_mm) {
  const Vec3 off = place_mm - run.from_mm;
  return (off - std::clamp(off.dot(run.chord_mm) * run.per_length_sq, 0.0, 1.0) * run.chord_mm).squaredNorm();
}

/// No ball of the run enters below the height found: all centres stand above it, and none is nearer to where the normal
/// is entered than the radius.
bool ScallopBalls::misses(const Run& run, const ScallopEntry& entry) const {
  const double from = (run.from_mm - entry.point_mm).dot(entry.normal), to = from + run.chord_mm.dot(entry.normal);
  if (std::min(from, to) - run.off_mm < entry.height_mm) return false;
  const double clear_mm = radius_mm_ + run.off_mm;
  return chord_distance_sq(run, entry.entered_mm()) >= clear_mm * clear_mm;
}

[[gnu::flatten]] void ScallopBalls::within(double reach_mm, ScallopEntry& entry, LookedAt& looked_at) const {
  const Vec3 middle_mm = entry.point_mm + radius_mm_ * entry.normal;
  const Vec3 reach = Vec3::Constant(reach_mm + cells_.cell_mm());
  looked_at.extend(middle_mm - reach).extend(middle_mm + reach);
  cells_.near_ranges(middle_mm, reach_mm, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = at(run_of_[begin]), last = at(run_of_[end - 1]); r <= last; ++r) {
      if (misses(runs_[r], entry)) continue;
      const std::size_t run_end = std::min(end, run_begin_[r + 1]);
      for (std::size_t i = std::max(begin, run_begin_[r]); i < run_end; ++i)
        lower(in_cells_[i], cells_.order()[i], entry);
    }
  });
}

}  // namespace volute::planner
