#include "planner/path/even_collar.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/index.hpp"
#include "planner/path/point_grid.hpp"

namespace volute::planner {

using geometry::at;
namespace {

constexpr double reach_turns = 1.3;  ///< the turn one interval outside the slit lies inside the collar
constexpr double trusted_share = 0.95;
constexpr double joint_reaches = 1.8;

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& place) {
  const Vec3 along = b - a;
  const double length_sq = along.squaredNorm();
  const double share = length_sq > 0.0 ? std::clamp((place - a).dot(along) / length_sq, 0.0, 1.0) : 0.0;
  return a + share * along;
}

/// From the nearest point of the centre (slits, and the hole that they grow out of) to a place.
Vec3 away_from_centre(const EvenDomain& domain, const Vec3& place) {
  const auto& loop = domain.centre.vertices;
  const auto& vertices = domain.mesh.vertices_mm;
  Vec3 least = Vec3::Constant(1e100);
  double least_sq = least.squaredNorm();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 away =
        place - nearest_on_segment(vertices[at(loop[i])], vertices[at(loop[(i + 1) % loop.size()])], place);
    if (away.squaredNorm() >= least_sq) continue;
    least = away;
    least_sq = away.squaredNorm();
  }
  return least;
}

/// Where arms meet each other or the hole: cut there, the surface has more than one copy of the place.
std::vector<Vec3> joints_of(const EvenDomain& domain) {
  const auto& vertices = domain.mesh.vertices_mm;
  std::vector<Vec3> out;
  for (const auto& slit : domain.slits) {
    for (const Vec3& end : {vertices[at(slit.front())], vertices[at(slit.back())]}) {
      const auto copies = std::count_if(domain.centre.vertices.begin(), domain.centre.vertices.end(),
                                        [&](Index v) { return vertices[at(v)] == end; });
      if (copies > 1) out.push_back(end);
    }
  }
  return out;
}

struct Near {
  Index vertex;
  Vec3 away_mm;
};

/// Vertices within reach of the slits, nearer to them than to any other boundary.
std::vector<Near> near_slits(const EvenDomain& domain, double reach_mm) {
  const auto& vertices = domain.mesh.vertices_mm;
  std::vector<Vec3> slit_places, other_places;
  std::vector<char> on_boundary(vertices.size(), 0);
  for (const auto& slit : domain.slits) {
    for (Index v : slit) slit_places.push_back(vertices[at(v)]);
  }
  for (const auto& loop : domain.topology.boundary_loops()) {
    const bool centre = loop.vertices.front() == domain.centre.vertices.front();
    for (Index v : loop.vertices) {
      on_boundary[at(v)] = 1;
      if (!centre) other_places.push_back(vertices[at(v)]);
    }
  }
  const PointGrid slits(slit_places, reach_mm), others(other_places, reach_mm);
  const auto joints = joints_of(domain);
  std::vector<Near> out;
  for (Index v = 0; v < static_cast<Index>(vertices.size()); ++v) {
    bool close = false;
    slits.near(vertices[at(v)], reach_mm, [&](Index) { close = true; });
    if (!close || on_boundary[at(v)] != 0) continue;
    const Vec3 away = away_from_centre(domain, vertices[at(v)]);
    const double off_mm = away.norm();
    if (off_mm > reach_mm) continue;
    bool other_nearer = false;
    others.near(vertices[at(v)], off_mm, [&](Index i) {
      other_nearer = other_nearer || (other_places[at(i)] - vertices[at(v)]).norm() <= off_mm;
    });
    const bool at_joint = std::any_of(joints.begin(), joints.end(), [&](const Vec3& joint) {
      return (joint - vertices[at(v)]).norm() < joint_reaches * reach_mm;
    });
    if (!other_nearer && !at_joint) out.push_back({v, away});
  }
  return out;
}

}  // namespace

std::vector<CollarVertex> slit_collar(const EvenDomain& domain, const IntervalRule& rule) {
  if (domain.slits.empty()) return {};
  const auto near = near_slits(domain, reach_turns * rule.interval_mm(0.0));
  std::vector<double> interval_mm;
  for (const Near& n : near) {
    const Index triangle = domain.topology.outgoing(n.vertex).front() / 3;
    if (n.away_mm.norm() > 1e-9) interval_mm.push_back(domain.interval_mm(rule, triangle, n.away_mm.normalized()));
  }
  if (interval_mm.empty()) return {};
  std::sort(interval_mm.begin(), interval_mm.end(), std::greater<>());
  const double held_mm =
      std::min(interval_mm[static_cast<std::size_t>(trusted_share * static_cast<double>(interval_mm.size() - 1))],
               rule.interval_mm(0.0));
  std::vector<CollarVertex> out;
  for (const Near& n : near) {
    const double turns = n.away_mm.norm() / held_mm;
    if (turns <= reach_turns) out.push_back({n.vertex, turns});
  }
  return out;
}

}  // namespace volute::planner
