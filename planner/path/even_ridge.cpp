#include "planner/path/even_ridge.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "geometry/check.hpp"
#include "geometry/index.hpp"

namespace volute::planner {

using geometry::at;
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

struct Reached {
  std::vector<double> cost;
  std::vector<Index> before;  ///< no_index: a source, or not reached
};

/// Dijkstra's algorithm; `cost_of` takes an edge's length and its ends.
template <class Cost>
Reached least_cost(const std::vector<std::vector<std::pair<double, Index>>>& next, const std::vector<Index>& sources,
                   Cost cost_of) {
  Reached out{std::vector<double>(next.size(), unreached), std::vector<Index>(next.size(), geometry::no_index)};
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>, std::greater<>> queue;
  for (Index v : sources) {
    out.cost[at(v)] = 0.0;
    queue.emplace(0.0, v);
  }
  while (!queue.empty()) {
    const auto [cost, v] = queue.top();
    queue.pop();
    if (cost > out.cost[at(v)]) continue;
    for (const auto& [length, w] : next[at(v)]) {
      const double there = cost + cost_of(length, v, w);
      if (there >= out.cost[at(w)]) continue;
      out.cost[at(w)] = there;
      out.before[at(w)] = v;
      queue.emplace(there, w);
    }
  }
  return out;
}

double off_chord_mm(const Vec3& a, const Vec3& b, const Vec3& place) {
  const Vec3 along = b - a;
  const double length_sq = along.squaredNorm();
  const double share = length_sq > 0.0 ? std::clamp((place - a).dot(along) / length_sq, 0.0, 1.0) : 0.0;
  return (a + share * along - place).norm();
}

/// Corners kept between the first and the last, Douglas and Peucker.
void keep_corners(const TriangleMesh& mesh, const std::vector<Index>& way, std::size_t first, std::size_t last,
                  double kept_mm, std::vector<Index>& out) {
  double worst_mm = kept_mm;
  std::size_t worst = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off =
        off_chord_mm(mesh.vertices_mm[at(way[first])], mesh.vertices_mm[at(way[last])], mesh.vertices_mm[at(way[i])]);
    if (off <= worst_mm) continue;
    worst_mm = off;
    worst = i;
  }
  if (worst == first) {
    out.push_back(way[last]);
    return;
  }
  keep_corners(mesh, way, first, worst, kept_mm, out);
  keep_corners(mesh, way, worst, last, kept_mm, out);
}

}  // namespace

RidgeWays::RidgeWays(const TriangleMesh& mesh) : mesh_(&mesh), next_(mesh.vertices_mm.size()) {
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      const double length = (mesh.vertices_mm[at(a)] - mesh.vertices_mm[at(b)]).norm();
      next_[at(a)].emplace_back(length, b);
      next_[at(b)].emplace_back(length, a);
    }
  }
}

std::vector<double> RidgeWays::distance_mm(const std::vector<Index>& sources) const {
  return least_cost(next_, sources, [](double length, Index, Index) { return length; }).cost;
}

std::vector<Index> RidgeWays::way(const std::vector<Index>& sources, Index to, const std::vector<double>& room_mm,
                                  double kept_mm) const {
  VOLUTE_CHECK(room_mm.size() == next_.size(), room_mm.size(), next_.size());
  constexpr double narrowest_mm_sq = 1e-12;
  const Reached reached = least_cost(next_, sources, [&](double length, Index a, Index b) {
    const double room = 0.5 * (room_mm[at(a)] + room_mm[at(b)]);
    return length / std::max(room * room, narrowest_mm_sq);
  });
  if (reached.cost[at(to)] == unreached) return {};
  std::vector<Index> way{to};
  while (reached.before[at(way.back())] != geometry::no_index) way.push_back(reached.before[at(way.back())]);
  std::reverse(way.begin(), way.end());
  std::vector<Index> out{way.front()};
  if (way.size() > 1) keep_corners(*mesh_, way, 0, way.size() - 1, kept_mm, out);
  return out;
}

}  // namespace volute::planner
