#include "planner/path/even_ending.hpp"

#include <algorithm>

#include "geometry/check.hpp"

namespace volute::planner {
namespace {

/// A tip of the slit and the direction in which the slit leads from it, over half an interval.
struct Tip {
  Vec3 place_mm, inward;
};

Tip tip_of(const std::vector<Vec3>& line_mm, double interval_mm) {
  std::size_t i = 1;
  while (i + 1 < line_mm.size() && (line_mm[i] - line_mm[0]).norm() < 0.5 * interval_mm) ++i;
  return {line_mm[0], (line_mm[i] - line_mm[0]).normalized()};
}

/// Does the turn pass from beside the slit to beyond the tip between these points?
bool passes(const Tip& tip, const Vec3& before, const Vec3& after, double reach_mm) {
  return (before - tip.place_mm).dot(tip.inward) > 0.0 && (after - tip.place_mm).dot(tip.inward) <= 0.0 &&
         (after - tip.place_mm).norm() < reach_mm;
}

Vec3 bezier(const std::array<Vec3, 4>& p, double t) {
  const double s = 1.0 - t;
  return s * s * s * p[0] + 3.0 * s * s * t * p[1] + 3.0 * s * t * t * p[2] + t * t * t * p[3];
}

}  // namespace

std::vector<Index> slit_line(const EvenDomain& domain) {
  std::vector<Index> line;
  if (domain.slits.empty()) return line;
  line = domain.slits.front();
  for (std::size_t i = 1; i < domain.slits.size(); ++i) {
    const auto& arm = domain.slits[i];
    if (arm.front() == line.front()) std::reverse(line.begin(), line.end());
    if (arm.front() != line.back()) return {};
    line.insert(line.end(), arm.begin() + 1, arm.end());
  }
  // A slit that grows out of a hole is shorter than the loop around it.
  const std::size_t both_sides = 2 * (line.size() - 1);
  return domain.centre.vertices.size() == both_sides ? line : std::vector<Index>{};
}

SlitEnding slit_ending(const std::vector<Vec3>& line_mm, const LastTurn& turn, double interval_mm) {
  VOLUTE_CHECK(line_mm.size() >= 3 && turn.points_mm.size() >= 3, line_mm.size(), turn.points_mm.size());
  const std::vector<Vec3> backward(line_mm.rbegin(), line_mm.rend());
  const std::size_t n = turn.points_mm.size();
  const double reach_mm = 3.0 * interval_mm;
  const auto point = [&](std::size_t step) -> const Vec3& { return turn.points_mm[(turn.begin + step) % n]; };
  SlitEnding out;
  for (std::size_t step = n; step < 2 * n; ++step) {
    for (const std::vector<Vec3>* line : {&line_mm, &backward}) {
      const Tip tip = tip_of(*line, interval_mm);
      if (!passes(tip, point(step), point(step + 1), reach_mm)) continue;
      out.steps = step;
      const Vec3 along = (point(step) - point(step - 1)).normalized();
      const double off_mm = (point(step) - tip.place_mm).norm(), lever_mm = 0.8 * off_mm;
      const std::array<Vec3, 4> curve = {point(step), point(step) + lever_mm * along,
                                         tip.place_mm - lever_mm * tip.inward, tip.place_mm};
      constexpr int parts = 12;
      for (int k = 1; k < parts; ++k) out.points_mm.push_back(bezier(curve, static_cast<double>(k) / parts));
      out.points_mm.insert(out.points_mm.end(), line->begin(), line->end());
      return out;
    }
  }
  return out;
}

}  // namespace volute::planner
