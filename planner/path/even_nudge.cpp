#include "planner/path/even_nudge.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "planner/path/even_prolong.hpp"
#include "planner/path/point_grid.hpp"

namespace volute::planner {

using geometry::at;
namespace {

/// A shift of the path, the whole of it at `s_mm`.
struct Push {
  double s_mm;
  Vec3 shift_mm;
};

/// The path at even steps, and where along it each step stands.
struct Steps {
  std::vector<Vec3> places;
  std::vector<double> s_mm, turn;
};

Steps steps_of(const CcPiece& piece, double step_mm) {
  Steps out;
  double s = 0.0;
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const CcPoint& a = piece.points[i];
    out.places.push_back(a.point_P_mm);
    out.s_mm.push_back(s);
    out.turn.push_back(a.turn);
    if (i + 1 == piece.points.size()) break;
    const CcPoint& b = piece.points[i + 1];
    const double span = (b.point_P_mm - a.point_P_mm).norm();
    const int parts = static_cast<int>(std::ceil(span / step_mm));
    for (int k = 1; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      out.places.push_back(a.point_P_mm + share * (b.point_P_mm - a.point_P_mm));
      out.s_mm.push_back(s + share * span);
      out.turn.push_back(a.turn + share * (b.turn - a.turn));
    }
    s += span;
  }
  return out;
}

/// The nearest step of each pass within reach of a place: passes are stretches of the path, apart along it.
std::vector<std::size_t> feet_of(const Steps& steps, const PointGrid& grid, const Vec3& place, double reach_mm,
                                 double apart_mm) {
  std::vector<std::size_t> near;
  grid.near(place, reach_mm, [&](Index i) {
    if ((steps.places[at(i)] - place).norm() <= reach_mm) near.push_back(at(i));
  });
  std::sort(near.begin(), near.end());
  std::vector<std::size_t> feet;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const bool same_pass = k > 0 && steps.s_mm[near[k]] - steps.s_mm[near[k - 1]] <= apart_mm;
    if (!same_pass) {
      feet.push_back(near[k]);
    } else if ((steps.places[near[k]] - place).norm() < (steps.places[feet.back()] - place).norm()) {
      feet.back() = near[k];
    }
  }
  return feet;
}

std::vector<Push> pushes_for(const Steps& steps, std::span<const HighPlace> places, double interval_mm,
                             const NudgeOptions& options) {
  const PointGrid grid(steps.places, interval_mm);
  std::vector<Push> out;
  for (const HighPlace& high : places) {
    const Vec3& place = high.place_P_mm;
    const auto feet = feet_of(steps, grid, place, options.reach_intervals * interval_mm, 0.5 * interval_mm);
    const auto off_mm = [&](std::size_t foot) { return (steps.places[foot] - place).norm(); };
    double nearest_mm = options.reach_intervals * interval_mm;
    for (std::size_t foot : feet) nearest_mm = std::min(nearest_mm, off_mm(foot));
    const double share = 1.0 - std::sqrt(options.aim_ratio / std::max(high.ratio, options.aim_ratio));
    for (std::size_t foot : feet) {
      if (off_mm(foot) > options.beside * nearest_mm || steps.turn[foot] <= options.turn_kept) continue;
      out.push_back({steps.s_mm[foot], share * (place - steps.places[foot])});
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const Push& a, const Push& b) { return a.s_mm < b.s_mm; });
  return out;
}

/// The shift at s: those whose windows hold it, averaged by their weights; nothing where there is none.
class Shifts {
 public:
  Shifts(std::vector<Push> pushes, double window_mm, double last_mm)
      : pushes_(std::move(pushes)), window_mm_(window_mm), last_mm_(last_mm) {}

  [[nodiscard]] bool any(double s_mm) const { return first(s_mm) != pushes_.end() && weight_sum(s_mm) > 0.0; }
  [[nodiscard]] Vec3 at_mm(double s_mm) const {
    Vec3 sum = Vec3::Zero();
    for (auto p = first(s_mm); p != pushes_.end() && p->s_mm < s_mm + window_mm_; ++p)
      sum += weight(*p, s_mm) * weight(*p, s_mm) * p->shift_mm;
    // The ends of the path stay.
    const double to_end = std::clamp(std::min(s_mm, last_mm_ - s_mm) / window_mm_, 0.0, 1.0);
    return to_end * sum / weight_sum(s_mm);
  }

 private:
  [[nodiscard]] std::vector<Push>::const_iterator first(double s_mm) const {
    return std::lower_bound(pushes_.begin(), pushes_.end(), s_mm - window_mm_,
                            [](const Push& p, double s) { return p.s_mm < s; });
  }
  [[nodiscard]] double weight(const Push& push, double s_mm) const {
    const double off = (s_mm - push.s_mm) / window_mm_, share = std::max(0.0, 1.0 - off * off);
    return share * share;
  }
  [[nodiscard]] double weight_sum(double s_mm) const {
    double sum = 0.0;
    for (auto p = first(s_mm); p != pushes_.end() && p->s_mm < s_mm + window_mm_; ++p) sum += weight(*p, s_mm);
    return sum;
  }

  std::vector<Push> pushes_;
  double window_mm_, last_mm_;
};

/// A piece of which some points moved, and where each of its points stood before.
struct Nudged {
  CcPiece piece;
  std::vector<char> moved;
  std::vector<Vec3> from_mm;
};

Nudged nudged(const CcPiece& piece, std::span<const HighPlace> places, double interval_mm,
              const NudgeOptions& options) {
  const double step_mm = interval_mm / options.steps_per_interval;
  const Steps steps = steps_of(piece, std::min(step_mm, interval_mm / 12.0));
  const Shifts shifts(pushes_for(steps, places, interval_mm, options), options.window_intervals * interval_mm,
                      steps.s_mm.back());
  Nudged out;
  const auto append = [&](CcPoint point, double s_mm, bool shifted) {
    out.from_mm.push_back(point.point_P_mm);
    if (shifted) point.point_P_mm += shifts.at_mm(s_mm);
    out.piece.points.push_back(point);
    out.moved.push_back(shifted ? 1 : 0);
  };
  double s = 0.0;
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const CcPoint& a = piece.points[i];
    const bool stays = a.turn <= options.turn_kept;
    append(a, s, !stays && shifts.any(s));
    if (i + 1 == piece.points.size()) break;
    const CcPoint& b = piece.points[i + 1];
    const double span = (b.point_P_mm - a.point_P_mm).norm();
    const int parts = static_cast<int>(std::ceil(span / step_mm));
    for (int k = 1; k < parts && !stays; ++k) {
      const double share = static_cast<double>(k) / parts, here = s + share * span;
      if (!shifts.any(here)) continue;
      CcPoint between = a;
      between.point_P_mm += share * (b.point_P_mm - a.point_P_mm);
      between.normal_P = ((1.0 - share) * a.normal_P + share * b.normal_P).normalized();
      between.turn += share * (b.turn - a.turn);
      append(between, here, true);
    }
    s += span;
  }
  return out;
}

}  // namespace

std::vector<HighPlace> high_places(const ScallopMap& map, double ratio, double apart_mm) {
  std::vector<std::size_t> order;
  for (std::size_t t = 0; t < map.worst_ratio.size(); ++t) {
    if (map.worst_ratio[t] > ratio) order.push_back(t);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return map.worst_ratio[a] > map.worst_ratio[b]; });
  std::vector<HighPlace> out;
  for (std::size_t t : order) {
    const Vec3& place = map.worst_place_P_mm[t];
    const bool taken = std::any_of(out.begin(), out.end(),
                                   [&](const HighPlace& h) { return (h.place_P_mm - place).norm() < apart_mm; });
    if (!taken) out.push_back({place, map.worst_ratio[t]});
  }
  return out;
}

std::vector<char> nudge(CcPiece& piece, std::span<const HighPlace> places, double interval_mm,
                        const NudgeOptions& options) {
  VOLUTE_CHECK(interval_mm > 0.0 && options.aim_ratio > 0.0 && options.steps_per_interval > 0.0, interval_mm,
               options.aim_ratio, options.steps_per_interval);
  if (piece.points.size() < 3 || places.empty()) return std::vector<char>(piece.points.size(), 0);
  Nudged out = nudged(piece, places, interval_mm, options);
  piece = std::move(out.piece);
  return std::move(out.moved);
}

void nudge_finished(CcPiece& piece, std::span<const HighPlace> places, double interval_mm, const TriangleMesh& mesh,
                    std::span<const Vec3> vertex_normals, const std::vector<TriangleOperator>& operators) {
  // The spline leaves turns near 0 on the run along the boundary; few points a window, for short steps cost feed.
  constexpr NudgeOptions options{.aim_ratio = 1.03, .turn_kept = 0.02, .steps_per_interval = 4.0};
  if (piece.points.size() < 3 || places.empty()) return;
  Nudged out = nudged(piece, places, interval_mm, options);
  std::vector<Vec3> from, to;
  for (std::size_t i = 0; i < out.moved.size(); ++i) {
    if (out.moved[i] == 0) continue;
    from.push_back(out.from_mm[i]);
    to.push_back(out.piece.points[i].point_P_mm);
  }
  const auto before = on_mesh(mesh, vertex_normals, operators, from),
             after = on_mesh(mesh, vertex_normals, operators, to);
  for (std::size_t i = 0, k = 0; i < out.moved.size(); ++i) {
    if (out.moved[i] == 0) continue;
    CcPoint& p = out.piece.points[i];
    p.point_P_mm = out.from_mm[i] + (after[k].point_P_mm - before[k].point_P_mm);
    p.normal_P = (p.normal_P + after[k].normal_P - before[k].normal_P).normalized();
    ++k;
  }
  piece = std::move(out.piece);
}

}  // namespace volute::planner
