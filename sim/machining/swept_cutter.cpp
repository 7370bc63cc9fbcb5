#include "sim/machining/swept_cutter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/machining/golden_section.hpp"

namespace volute::sim {
namespace {

using kinematics::CutterShape;

bool has_ball_nose(const kinematics::Cutter& cutter) {
  return cutter.shape == CutterShape::ball || cutter.shape == CutterShape::taper_ball;
}

/// Places this far apart leave cusps of tolerance_mm between round things of radius_mm.
double spacing_for_cusp(double radius_mm, double tolerance_mm) { return std::sqrt(8.0 * radius_mm * tolerance_mm); }

StandingCutter between(const StandingCutter& a, const StandingCutter& b, double share) {
  return {a.tip_mm + share * (b.tip_mm - a.tip_mm), ((1.0 - share) * a.axis + share * b.axis).normalized()};
}

/// Box of a disc.
void extend_by_disc(Box& box, const Vec3& centre, const Vec3& axis, double radius) {
  const Vec3 reach = radius * (Vec3::Ones() - axis.cwiseProduct(axis)).cwiseMax(0.0).cwiseSqrt();
  box.extend(Vec3(centre - reach));
  box.extend(Vec3(centre + reach));
}

/// Where a line crosses the plane of a cutter's bottom, above which all of the cutter stands.
double bottom_crossing_mm(const SweptCutter::Near::Stand& stand, const Vec3& point_mm) {
  constexpr double level = 1e-9;
  if (stand.rise <= level) return -std::numeric_limits<double>::infinity();
  return (stand.along_mm - point_mm.dot(stand.axis)) / stand.rise;
}

/// No lower than this is a convex function over [0, 1] with these values at 0, 1 - golden, golden and 1.
double lowest_between(double f0, double f1, double f2, double f3) {
  constexpr double x1 = 1.0 - golden, x2 = golden;
  const double inner = (f2 - f1) / (x2 - x1), outer1 = (f1 - f0) / x1, outer2 = (f3 - f2) / (1.0 - x2);
  const double left = std::min(f1 - inner * x1, f1), right = std::min(f2 + inner * (1.0 - x2), f2);
  const double middle = std::max(std::min(f1, f1 + outer1 * (x2 - x1)), std::min(f2, f2 - outer2 * (x2 - x1)));
  return std::min({left, middle, right});
}

/// A line enters a flank below the ball's own entry only where it comes from the side: above this cosine between the
/// surface normal and the axis the ball reaches lower.
constexpr double flank_cosine = 0.7;

}  // namespace

std::optional<double> capsule_entry_mm(const Vec3& from_mm, const Vec3& to_mm, double radius_mm, const Vec3& point_mm,
                                       const Vec3& direction, double limit_mm) {
  const Vec3 w = from_mm - point_mm, v = to_mm - from_mm;
  const double w_along = w.dot(direction), v_along = v.dot(direction);
  const Vec3 w_across = w - w_along * direction, v_across = v - v_along * direction;
  // The ball at share s begins at t(s) = w_along + s v_along - sqrt(q(s)), q(s) = top - k (s - middle)^2: convex where
  // q >= 0.
  const double k = v_across.squaredNorm();
  const double middle = k > 0.0 ? -w_across.dot(v_across) / k : 0.0;
  const double top =
      radius_mm * radius_mm - (k > 0.0 ? (w_across + middle * v_across).squaredNorm() : w_across.squaredNorm());
  if (top < 0.0) return std::nullopt;
  double share = 0.0;
  if (k > 0.0)
    share = std::clamp(middle - v_along * std::sqrt(top / (k * (k + v_along * v_along))), 0.0, 1.0);
  else
    share = v_along < 0.0 ? 1.0 : 0.0;
  const double q = k > 0.0 ? top - k * (share - middle) * (share - middle) : top;
  if (q < 0.0) return std::nullopt;
  const double entry = w_along + share * v_along - std::sqrt(q);
  if (entry > limit_mm) return std::nullopt;
  if (entry >= 0.0) return entry;
  const double length_sq = v.squaredNorm();
  const double nearest = length_sq > 0.0 ? std::clamp(-w.dot(v) / length_sq, 0.0, 1.0) : 0.0;
  if ((w + nearest * v).squaredNorm() > radius_mm * radius_mm)
    return std::nullopt;  // wholly below: the other side of a thin wall
  return entry;
}

SweptCutter::SweptCutter(const kinematics::Cutter& cutter, const std::vector<SweptPose>& poses, double tolerance_mm)
    : profile_(cutter), ball_nose_(has_ball_nose(cutter)), ball_radius_mm_(ball_nose_ ? cutter.radius_mm : 0.0) {
  if (ball_nose_) {
    centres_.reserve(poses.size());
    for (const auto& p : poses) centres_.push_back(p.pose.tip_P_mm + ball_radius_mm_ * p.pose.axis_P);
  }
  make_places(poses, tolerance_mm);
  make_trees();
}

void SweptCutter::make_places(const std::vector<SweptPose>& poses, double tolerance_mm) {
  // A sharp corner has no cusp formula of its own: the search between neighbours in refine() finds its lowest point.
  const double round =
      ball_nose_ || profile_.corner_radius_mm() == 0.0 ? profile_.greatest_radius_mm() : profile_.corner_radius_mm();
  const double spacing = spacing_for_cusp(round, tolerance_mm);
  // Of a ball nose the places only serve the flank, whose cusps are below the tolerance; the ball itself is swept
  // exactly.
  slack_mm_ = ball_nose_ ? 0.0 : profile_.corner_radius_mm() == 0.0 ? 0.25 * spacing : 2.0 * tolerance_mm;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const StandingCutter here{poses[i].pose.tip_P_mm, poses[i].pose.axis_P};
    if (i > 0) {
      const StandingCutter before{poses[i - 1].pose.tip_P_mm, poses[i - 1].pose.axis_P};
      const double tip = (here.tip_mm - before.tip_mm).norm();
      const double top =
          (here.tip_mm + profile_.length_mm() * here.axis - before.tip_mm - profile_.length_mm() * before.axis).norm();
      const int parts = static_cast<int>(std::ceil(std::max(tip, top) / spacing));
      for (int k = 1; k < parts; ++k) {
        places_.push_back({between(before, here, static_cast<double>(k) / parts), static_cast<std::int32_t>(i)});
      }
    }
    places_.push_back({here, static_cast<std::int32_t>(i)});
  }
}

void SweptCutter::make_trees() {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i + 1 < centres_.size() || (i == 0 && centres_.size() == 1); ++i) {
    Box box(centres_[i]);
    box.extend(centres_[std::min(i + 1, centres_.size() - 1)]);
    boxes.emplace_back(Vec3(box.min().array() - ball_radius_mm_), Vec3(box.max().array() + ball_radius_mm_));
  }
  move_tree_ = BoxTree(boxes);
  boxes.clear();
  boxes.reserve(places_.size());
  const double bottom = ball_nose_ ? profile_.flank_start().y() : 0.0;
  const double bottom_radius = ball_nose_ ? profile_.flank_start().x() : profile_.greatest_radius_mm();
  for (const Place& place : places_) {
    Box box;
    extend_by_disc(box, place.cutter.tip_mm + bottom * place.cutter.axis, place.cutter.axis, bottom_radius);
    extend_by_disc(box, place.cutter.tip_mm + profile_.length_mm() * place.cutter.axis, place.cutter.axis,
                   profile_.greatest_radius_mm());
    boxes.push_back(box);
  }
  place_tree_ = BoxTree(boxes);
}

void SweptCutter::find_near(const Vec3& centre_mm, double radius_mm, Near& out) const {
  out.clear();
  move_tree_.near(centre_mm, radius_mm, [&](std::int32_t move) { out.moves.push_back(move); });
  const double reach = radius_mm + profile_.greatest_radius_mm();
  place_tree_.near(centre_mm, radius_mm, [&](std::int32_t item) {
    const StandingCutter& cutter = places_[static_cast<std::size_t>(item)].cutter;
    const Vec3 w = centre_mm - cutter.tip_mm;
    const double along = std::clamp(w.dot(cutter.axis), 0.0, profile_.length_mm());
    if ((w - along * cutter.axis).squaredNorm() <= reach * reach) out.places.push_back(item);
  });
}

void SweptCutter::near(const Vec3& middle_mm, double size_mm, const Vec3& normal, double height_mm, Near& out) const {
  find_near(middle_mm + 0.5 * height_mm * normal, std::hypot(size_mm, 0.5 * height_mm) + 1e-9, out);
  for (const std::int32_t item : out.places) {
    const StandingCutter& cutter = places_[static_cast<std::size_t>(item)].cutter;
    const double rise = normal.dot(cutter.axis), across = std::sqrt(std::max(0.0, 1.0 - rise * rise));
    if (ball_nose_ && rise > flank_cosine) continue;
    const Vec2 lowest = profile_.support(-rise);
    const double depth = lowest.x() * across - lowest.y() * rise;
    const Near::Stand stand{cutter.axis, cutter.tip_mm.dot(cutter.axis), rise, cutter.tip_mm.dot(normal) - depth, item};
    // The crossing of the bottom's plane falls by across / rise on a way on the surface.
    const double crossing = bottom_crossing_mm(stand, middle_mm);
    const double above = crossing - height_mm - slack_mm_;
    if (above > 0.0 && rise * above > size_mm * across) continue;
    out.stands.push_back(stand);
  }
  std::sort(out.stands.begin(), out.stands.end(), [](const Near::Stand& a, const Near::Stand& b) {
    return a.lowest_mm != b.lowest_mm ? a.lowest_mm < b.lowest_mm : a.place < b.place;
  });
}

std::optional<SweptEntry> SweptCutter::entry(const Vec3& point_mm, const Vec3& normal, double limit_mm,
                                             const Near& near, double enough_mm) const {
  std::optional<SweptEntry> best;
  double limit = limit_mm;
  for (const std::int32_t move : near.moves) {
    const auto i = static_cast<std::size_t>(move);
    const std::size_t j = std::min(i + 1, centres_.size() - 1);
    if (const auto t = capsule_entry_mm(centres_[i], centres_[j], ball_radius_mm_, point_mm, normal, limit)) {
      best = SweptEntry{*t, static_cast<std::int32_t>(j)};
      limit = *t;
      if (limit <= enough_mm) return best;
    }
  }
  entry_of_places(point_mm, normal, limit, enough_mm, near, best);
  return best;
}

bool SweptCutter::within_reach(const StandingCutter& cutter, const Vec3& point_mm, const Vec3& normal,
                               double limit_mm) const {
  const double half = 0.5 * std::max(0.0, limit_mm);
  const Vec3 w = point_mm - cutter.tip_mm + half * normal;
  const double along = w.dot(cutter.axis), reach = profile_.greatest_radius_mm() + half;
  return (w - along * cutter.axis).squaredNorm() <= reach * reach;
}

void SweptCutter::entry_of_places(const Vec3& point_mm, const Vec3& normal, double limit_mm, double enough_mm,
                                  const Near& near, std::optional<SweptEntry>& best) const {
  struct Low {
    double height_mm;
    std::int32_t place;
  };
  std::vector<Low> low;
  double limit = limit_mm;
  const auto look = [&](const Near::Stand& stand) {
    const Place& place = places_[static_cast<std::size_t>(stand.place)];
    if (!within_reach(place.cutter, point_mm, normal, limit + slack_mm_)) return;
    const auto t = line_entry_mm(profile_, place.cutter, point_mm, normal, limit + slack_mm_);
    if (!t) return;
    low.push_back({*t, stand.place});
    if (*t >= limit) return;
    best = SweptEntry{*t, place.pose};
    limit = *t;
  };
  const double point_height_mm = point_mm.dot(normal);
  // The place that can be lowest comes first: its limit then refuses nearly all others without looking at them.
  const Near::Stand* first = nullptr;
  for (double lowest = limit + slack_mm_; const Near::Stand& stand : near.stands) {
    if (stand.lowest_mm - point_height_mm > lowest) break;
    const double height = std::max(stand.lowest_mm - point_height_mm, bottom_crossing_mm(stand, point_mm));
    if (height >= lowest) continue;
    lowest = height;
    first = &stand;
  }
  if (first != nullptr) look(*first);
  for (const Near::Stand& stand : near.stands) {
    if (limit <= enough_mm) return;
    if (stand.lowest_mm - point_height_mm > limit + slack_mm_) break;
    if (&stand != first && bottom_crossing_mm(stand, point_mm) <= limit + slack_mm_) look(stand);
  }
  // What lies between places can be lower by the slack. Along a straight move of a convex solid the entry is a convex
  // function of the way, so only about places lower than both their neighbours.
  std::erase_if(low, [&](const Low& l) { return l.height_mm > limit + slack_mm_; });
  std::sort(low.begin(), low.end(), [](const Low& a, const Low& b) { return a.place < b.place; });
  for (std::size_t i = 0; i < low.size(); ++i) {
    const bool before = i > 0 && low[i - 1].place == low[i].place - 1 && low[i - 1].height_mm <= low[i].height_mm;
    const bool behind =
        i + 1 < low.size() && low[i + 1].place == low[i].place + 1 && low[i + 1].height_mm < low[i].height_mm;
    if (!before && !behind) refine(low[i].place, low[i].height_mm, point_mm, normal, best);
  }
}

void SweptCutter::refine(std::int32_t place, double height_mm, const Vec3& point_mm, const Vec3& normal,
                         std::optional<SweptEntry>& best) const {
  for (const std::int32_t other : {place - 1, place + 1}) {
    if (other < 0 || other >= static_cast<std::int32_t>(places_.size())) continue;
    const Place& a = places_[static_cast<std::size_t>(place)];
    const Place& b = places_[static_cast<std::size_t>(other)];
    const double none = height_mm + 1.0;
    const auto height = [&](double share) {
      return line_entry_mm(profile_, between(a.cutter, b.cutter, share), point_mm, normal, none).value_or(none);
    };
    GoldenSection section(height, 0.0, 1.0);
    const double f1 = section.first(), f2 = section.second(), f3 = height(1.0);
    if (best && std::max({f1, f2, f3}) < none && lowest_between(height_mm, f1, f2, f3) >= best->height_mm) continue;
    section.narrow(14);
    if (const double found = section.least(); best && found < best->height_mm)
      best = SweptEntry{found, std::max(a.pose, b.pose)};
  }
}

}  // namespace volute::sim
