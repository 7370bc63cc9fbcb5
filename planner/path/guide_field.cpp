#include "planner/path/guide_field.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/index.hpp"
#include "geometry/number_text.hpp"
#include "planner/surface/operators.hpp"

namespace volute::planner {

using geometry::at;

namespace {

constexpr double length_ratio_max = 12.0;  ///< over the lower bound; above, the minimum of eq. 13 is not meant
constexpr double periodic_ratio_max = 5.0;
constexpr double least_quantile = 0.01;
constexpr int turn_bins = 256;

/// The rectangle map as coordinates of the ring: both copies of a seam vertex become one vertex and a jump.
PeriodicCoordinate around_of(const Annulus& annulus, const RectangleMap& map) {
  PeriodicCoordinate around;
  around.vertex.resize(annulus.ring.vertices_mm.size());
  std::vector<char> on_right(annulus.sheet.vertices_mm.size(), 0);
  for (Index v : annulus.right) on_right[at(v)] = 1;
  for (std::size_t v = 0; v < annulus.sheet_to_ring.size(); ++v)
    if (!on_right[v]) around.vertex[at(annulus.sheet_to_ring[v])] = map.u_mm[v] / map.width_mm;
  for (const geometry::Triangle& t : annulus.sheet.triangles) {
    around.jump.push_back({});
    for (std::size_t k = 0; k < 3; ++k) around.jump.back()[k] = on_right[at(t[k])] ? 1.0 : 0.0;
  }
  around.seam = annulus.seam;
  return around;
}

/// A triangle's increment and its weight in quantiles.
struct Increment {
  double value = 0.0, area_mm2 = 0.0;
};

/// Eq. 12 on each triangle: r_u, r_v from the map's gradients, feed along u (the slope of a guide line is one turn in
/// all turns).
std::vector<Increment> increments_eq12(const TriangleMesh& sheet, const RectangleMap& map,
                                       const IntervalField& intervals) {
  const auto operators = triangle_operators(sheet);
  const auto gradient_u = gradient(sheet, operators, map.u_mm), gradient_v = gradient(sheet, operators, map.v_mm);
  std::vector<Increment> increments;
  for (std::size_t t = 0; t < operators.size(); ++t) {
    const Vec2 &gu = gradient_u[t], &gv = gradient_v[t];
    const double det = gu.x() * gv.y() - gu.y() * gv.x();
    const Vec2 r_v = Vec2(-gu.y(), gu.x()) / det;
    const Vec2 b = gv.normalized();  // across the feed r_u
    const double allowed_mm = intervals.interval_mm(static_cast<Index>(t), operators[t].to_space(b));
    const double v_b = b.dot(gv);  // b = r_u u_b + r_v v_b
    increments.push_back({allowed_mm / (r_v.squaredNorm() * v_b), operators[t].area_mm2});
  }
  return increments;
}

/// The increment below which the given share of the area lies; 0: the minimum, eq. 13.
double quantile(std::vector<Increment> increments, double share) {
  std::sort(increments.begin(), increments.end(),
            [](const Increment& a, const Increment& b) { return a.value < b.value; });
  double total = 0.0, below = 0.0;
  for (const Increment& i : increments) total += i.area_mm2;
  for (const Increment& i : increments) {
    below += i.area_mm2;
    if (below > share * total) return i.value;
  }
  return increments.back().value;
}

/// Length of the level lines of v / delta - u / width: the integral of the gradient (coarea formula).
double path_length_mm(const TriangleMesh& sheet, const RectangleMap& map, double delta) {
  const auto operators = triangle_operators(sheet);
  const auto gradient_u = gradient(sheet, operators, map.u_mm), gradient_v = gradient(sheet, operators, map.v_mm);
  double length = 0.0;
  for (std::size_t t = 0; t < operators.size(); ++t)
    length += operators[t].area_mm2 * (gradient_v[t] / delta - gradient_u[t] / map.width_mm).norm();
  return length;
}

/// Eq. 13, or the quantile that keeps the path's length within reason.
double chosen_increment(const Annulus& annulus, const RectangleMap& map, const IntervalField& intervals,
                        GuideField& out) {
  const auto increments = increments_eq12(annulus.sheet, map, intervals);
  const double longest_mm = length_ratio_max * intervals.lower_bound_mm();
  const double least = quantile(increments, 0.0);
  if (path_length_mm(annulus.sheet, map, least) <= longest_mm) return least;
  double share = least_quantile, delta = quantile(increments, share);
  while (share < 0.5 && path_length_mm(annulus.sheet, map, delta) > longest_mm)
    delta = quantile(increments, share *= 1.5);
  out.notes.push_back(
      "paper: the smallest increment of eq. 13 would make " + geometry::short_text(map.height_mm / least, 4) +
      " turns, over " + geometry::short_text(length_ratio_max) + " times the shortest length; " +
      geometry::short_text(100.0 * share, 2) + " % of the area is left out of the minimum and keeps higher scallops");
  return delta;
}

/// How many turns lie outside each height, so that within a turn the widest demand is met: phi = F(height), F' = the
/// greatest 1 / (allowed interval * |grad height|) at that height.
class TurnProfile {
 public:
  TurnProfile(const TriangleMesh& ring, const std::vector<double>& height, const IntervalField& intervals)
      : demand_(turn_bins) {
    const auto operators = triangle_operators(ring);
    const auto slopes = gradient(ring, operators, height);
    for (std::size_t t = 0; t < operators.size(); ++t) {
      const double slope = slopes[t].norm();
      if (slope == 0.0) continue;
      const Vec3 across = operators[t].to_space(slopes[t] / slope);
      const double needed = 1.0 / (intervals.interval_mm(static_cast<Index>(t), across) * slope);
      const auto [low, high] = std::minmax(
          {height[at(ring.triangles[t][0])], height[at(ring.triangles[t][1])], height[at(ring.triangles[t][2])]});
      const int first = bin_of(low), last = bin_of(high);
      // The level lines' length inside the triangle (coarea formula), shared by the bins that it spans.
      const double length = operators[t].area_mm2 * slope / (last - first + 1);
      for (int bin = first; bin <= last; ++bin) demand_[at(bin)].push_back({needed, length});
    }
    for (auto& bin : demand_)
      std::sort(bin.begin(), bin.end(),
                [](const Demand& a, const Demand& b) { return a.turns_per_height > b.turns_per_height; });
  }

  /// Meets the demand of each height on all but a share of the level lines' length; 0: everywhere.
  void meet(double all_but_share) {
    turns_.assign(1, 0.0);
    length_mm_ = 0.0;
    for (const auto& bin : demand_) {
      const double turns = demanded(bin, all_but_share) / turn_bins;
      for (const Demand& d : bin) length_mm_ += d.length_mm * turns * turn_bins;
      turns_.push_back(turns_.back() + turns);
    }
  }
  [[nodiscard]] double turns(double height) const {
    const int bin = bin_of(height);
    const double share = height * turn_bins - bin;
    return turns_[at(bin)] + share * (turns_[at(bin + 1)] - turns_[at(bin)]);
  }
  /// Of the path along the level lines.
  [[nodiscard]] double length_mm() const { return length_mm_; }

 private:
  struct Demand {
    double turns_per_height = 0.0, length_mm = 0.0;
  };
  static int bin_of(double height) {
    return std::clamp(static_cast<int>(std::floor(height * turn_bins)), 0, turn_bins - 1);
  }

  static double demanded(const std::vector<Demand>& bin, double all_but_share) {
    double total = 0.0, above = 0.0;
    for (const Demand& d : bin) total += d.length_mm;
    for (const Demand& d : bin) {
      above += d.length_mm;
      if (above > all_but_share * total) return d.turns_per_height;
    }
    return bin.empty() ? 0.0 : bin.back().turns_per_height;
  }

  std::vector<std::vector<Demand>> demand_;  ///< by height, greatest first
  std::vector<double> turns_;                ///< at the bins' borders
  double length_mm_ = 0.0;
};

/// Meets every demand, or leaves out as small a share as keeps the length within reason.
void meet_demands(TurnProfile& profile, const IntervalField& intervals, GuideField& out) {
  const double longest_mm = periodic_ratio_max * intervals.lower_bound_mm();
  profile.meet(0.0);
  if (profile.length_mm() <= longest_mm) return;
  const double turns = profile.turns(1.0);
  double share = 0.001;
  for (profile.meet(share); share < 0.5 && profile.length_mm() > longest_mm; profile.meet(share)) share *= 1.5;
  out.notes.push_back("periodic: meeting the allowed interval everywhere takes " + geometry::short_text(turns, 4) +
                      " turns, over " + geometry::short_text(periodic_ratio_max) + " times the shortest length; " +
                      geometry::short_text(100.0 * share, 2) + " % of each turn keeps higher scallops");
}

}  // namespace

Result<GuideField> paper_guide(const Annulus& annulus, const IntervalField& intervals) {
  const auto map = rectangle_map(annulus);
  if (!map) return tl::unexpected(map.error());
  GuideField out;
  out.quality = map->quality;
  out.around = around_of(annulus, *map);
  const double delta = chosen_increment(annulus, *map, intervals, out);
  out.turn_count = map->height_mm / delta;
  out.turns.resize(annulus.ring.vertices_mm.size());
  for (std::size_t v = 0; v < annulus.sheet_to_ring.size(); ++v) {
    out.turns[at(annulus.sheet_to_ring[v])] = map->v_mm[v] / delta;
    out.map.emplace_back(map->u_mm[v], map->v_mm[v]);
  }
  return out;
}

Result<GuideField> periodic_guide(const Annulus& annulus, const IntervalField& intervals) {
  auto map = cylinder_map(annulus);
  if (!map) return tl::unexpected(map.error());
  GuideField out;
  out.quality = map->quality;
  TurnProfile profile(annulus.ring, map->height, intervals);
  meet_demands(profile, intervals, out);
  for (double h : map->height) out.turns.push_back(profile.turns(h));
  out.turn_count = profile.turns(1.0);
  out.map.resize(annulus.sheet.vertices_mm.size());
  for (std::size_t t = 0; t < annulus.sheet.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      out.map[at(annulus.sheet.triangles[t][k])] = {
          map->turn.at_corner(annulus.ring, static_cast<Index>(t), static_cast<int>(k)),
          map->height[at(annulus.ring.triangles[t][k])]};
  out.around = std::move(map->turn);
  return out;
}

}  // namespace volute::planner
