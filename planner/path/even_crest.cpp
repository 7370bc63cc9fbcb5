#include "planner/path/even_crest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "planner/path/path_interval.hpp"

namespace volute::planner {

using geometry::at;

BallSteps ball_steps(const CcPiece& piece, double radius_mm, double step_mm) {
  BallSteps out;
  double s = 0.0;
  const auto add = [&](const Vec3& point, const Vec3& normal, double s_mm, double turn) {
    out.contact_mm.push_back(point);
    out.normal.push_back(normal.normalized());
    out.centre_mm.push_back(point + radius_mm * out.normal.back());
    out.s_mm.push_back(s_mm);
    out.turn.push_back(turn);
  };
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const CcPoint &a = piece.points[i], &b = piece.points[std::min(i + 1, piece.points.size() - 1)];
    const double span = (b.point_P_mm - a.point_P_mm).norm();
    const int parts = std::max(1, static_cast<int>(std::ceil(span / step_mm)));
    for (int k = 0; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      add(a.point_P_mm + share * (b.point_P_mm - a.point_P_mm), (1.0 - share) * a.normal_P + share * b.normal_P,
          s + share * span, a.turn + share * (b.turn - a.turn));
    }
    s += span;
  }
  return out;
}

Crests::Crests(const BallSteps& steps, const MendSurface& surface, double radius_mm, double scallop_mm)
    : steps_(steps),
      surface_(surface),
      radius_mm_(radius_mm),
      scallop_mm_(scallop_mm),
      interval_mm_(path_interval_mm(radius_mm, scallop_mm, 0.0)),
      grid_(steps.centre_mm, interval_mm_) {}

CrestRow Crests::row(std::size_t triangle, const Vec3& place, double ratio) const {
  constexpr double as_high = 0.15;  // allowed heights: passes that enter so little higher make the crest too
  std::vector<Foot> feet = feet_of(triangle, place);
  CrestRow out{ratio, {}};
  if (feet.empty()) return out;
  std::stable_sort(feet.begin(), feet.end(), [](const Foot& a, const Foot& b) { return a.height_mm < b.height_mm; });
  const double limit_mm = feet.front().height_mm + as_high * scallop_mm_;
  std::erase_if(feet, [&](const Foot& f) { return f.height_mm > limit_mm; });
  const auto weights = balanced(feet);
  for (std::size_t k = 0; k < feet.size(); ++k) {
    if (weights[k] <= 0.0) continue;
    out.by_shift.emplace_back(steps_.s_mm[feet[k].step], weights[k] * interval_mm_ / scallop_mm_ * feet[k].by_shift);
  }
  return out;
}

Vec3 Crests::normal_at(std::size_t triangle, const Vec3& place) const {
  const auto& c = surface_.mesh.triangles[triangle];
  const TriangleOperator& o = surface_.operators[triangle];
  Vec3 normal = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& other = surface_.mesh.vertices_mm[at(c[(k + 1) % 3])];
    normal += o.hat_per_mm[k].dot(o.to_plane(place - other)) * surface_.vertex_normals[at(c[k])];
  }
  return normal.normalized();
}

/// The lowest entry of each pass: passes are stretches of the path, apart along it.
std::vector<Crests::Foot> Crests::feet_of(std::size_t triangle, const Vec3& place) const {
  const Vec3 normal = normal_at(triangle, place), middle = place + radius_mm_ * normal;
  const double reach_mm = 2.0 * interval_mm_;
  std::vector<std::size_t> near;
  grid_.near(middle, reach_mm, [&](Index i) { near.push_back(at(i)); });
  std::sort(near.begin(), near.end());
  std::vector<Foot> feet;
  double last_s_mm = -std::numeric_limits<double>::infinity();
  for (std::size_t i : near) {
    const Vec3 to_centre = steps_.centre_mm[i] - place;
    const double along = to_centre.dot(normal);
    const double inside_sq = radius_mm_ * radius_mm_ - to_centre.squaredNorm() + along * along;
    if (inside_sq <= 0.0) continue;
    const double height_mm = along - std::sqrt(inside_sq);
    const bool same_pass = steps_.s_mm[i] - last_s_mm <= 0.5 * interval_mm_;
    last_s_mm = steps_.s_mm[i];
    if (same_pass && feet.back().height_mm <= height_mm) continue;
    if (!same_pass) feet.emplace_back();
    feet.back() = foot(i, height_mm, place + height_mm * normal - steps_.centre_mm[i], normal);
  }
  return feet;
}

/// |x + h n - c| = r: (x + h n - c) . (dx + n dh - dc) = 0. Slopes over 10 are taken as 10.
Crests::Foot Crests::foot(std::size_t i, double height_mm, const Vec3& from_centre, const Vec3& normal) const {
  constexpr double steepest = 10.0;
  const double down = std::min(from_centre.dot(normal), -radius_mm_ / steepest);
  const Vec3& here = steps_.normal[i];
  const Vec3 along_surface = from_centre - from_centre.dot(here) * here;
  return {i, height_mm, along_surface / down, -(from_centre - from_centre.dot(normal) * normal) / down};
}

/// Weights with which the slopes along the surface come nearest to cancelling (Gilbert's steps towards the shortest
/// vector of their hull).
std::vector<double> Crests::balanced(const std::vector<Foot>& feet) {
  constexpr int steps = 60;
  std::vector<double> weight(feet.size(), 0.0);
  weight.front() = 1.0;
  Vec3 sum = feet.front().by_place;
  for (int step = 0; step < steps; ++step) {
    std::size_t to = 0;
    for (std::size_t k = 1; k < feet.size(); ++k) {
      if (feet[k].by_place.dot(sum) < feet[to].by_place.dot(sum)) to = k;
    }
    const Vec3 way = feet[to].by_place - sum;
    const double length_sq = way.squaredNorm();
    if (!(length_sq > 0.0)) break;
    const double share = std::clamp(-sum.dot(way) / length_sq, 0.0, 1.0);
    if (share < 1e-6) break;
    for (double& w : weight) w *= 1.0 - share;
    weight[to] += share;
    sum += share * way;
  }
  return weight;
}

}  // namespace volute::planner
