#include "planner/path/level_trace.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "geometry/index.hpp"

namespace volute::planner {
namespace {

using geometry::at;
using geometry::MeshTopology;
using geometry::no_index;

/// The levels between the corners of each triangle, and the walk along one of them.
class LevelWalker {
 public:
  LevelWalker(const TriangleMesh& mesh, const MeshTopology& topology, const CornerValues& values, double offset)
      : mesh_(mesh), topology_(topology), values_(values), offset_(offset), first_(mesh.triangles.size() + 1, 0) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Index corner = static_cast<Index>(3 * t);
      const auto [low, high] = std::minmax({cell(corner), cell(corner + 1), cell(corner + 2)});
      lowest_.push_back(low + 1);
      first_[t + 1] = first_[t] + static_cast<std::size_t>(high - low);
    }
    seen_.assign(first_.back(), 0);
  }

  std::vector<LevelLine> all() {
    std::vector<LevelLine> lines;
    // Open lines first, from the boundary edges where they come in; then what is left is closed.
    for (Index h = 0; h < static_cast<Index>(3 * mesh_.triangles.size()); ++h) {
      if (beyond(h) != no_index) continue;
      for (long level = cell(geometry::next_halfedge(h)) + 1; level <= cell(h); ++level)
        lines.push_back(walk(h, level));
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t s = first_[t]; s < first_[t + 1]; ++s) {
        if (seen_[s] != 0) continue;
        const long level = lowest_[t] + static_cast<long>(s - first_[t]);
        lines.push_back(walk(entry(static_cast<Index>(t), level), level));
      }
    }
    return lines;
  }

 private:
  /// Greatest whole number k with value(corner) >= k + offset; the corner's number is that of the halfedge leaving it.
  [[nodiscard]] long cell(Index corner) const {
    const Index vertex = mesh_.triangles[at(corner / 3)][at(corner % 3)];
    return std::lround(std::floor(values_.vertex[at(vertex)] - offset_)) - jump(corner);
  }
  [[nodiscard]] long jump(Index corner) const {
    return values_.jump.empty() ? 0 : std::lround(values_.jump[at(corner / 3)][at(corner % 3)]);
  }
  [[nodiscard]] bool falls(Index h, long level) const {
    return cell(h) >= level && cell(geometry::next_halfedge(h)) < level;
  }
  [[nodiscard]] bool rises(Index h, long level) const {
    return cell(h) < level && cell(geometry::next_halfedge(h)) >= level;
  }

  [[nodiscard]] Index beyond(Index h) const {
    for (Index edge : values_.torn) {
      if (topology_.edge(h) == edge) return no_index;
    }
    return topology_.opposite(h);
  }

  [[nodiscard]] Index entry(Index triangle, long level) const {
    for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
      if (falls(h, level)) return h;
    }
    VOLUTE_CHECK(false, triangle, level);
    return no_index;
  }

  /// Where the level crosses the halfedge, the edge's ends in rising vertex order so that both sides give the same
  /// bytes.
  [[nodiscard]] SurfacePoint crossing(Index h, long level) const {
    constexpr double end_share_min = 1e-7;
    const Index next = geometry::next_halfedge(h);
    SurfacePoint p{mesh_.triangles[at(h / 3)][at(h % 3)], mesh_.triangles[at(next / 3)][at(next % 3)], 0.0};
    double from = values_.vertex[at(p.a)] - static_cast<double>(level + jump(h)) - offset_;
    double to = values_.vertex[at(p.b)] - static_cast<double>(level + jump(next)) - offset_;
    if (p.a > p.b) {
      std::swap(p.a, p.b);
      std::swap(from, to);
    }
    p.t = std::clamp(from / (from - to), end_share_min, 1.0 - end_share_min);
    return p;
  }

  LevelLine walk(Index h, long level) {
    LevelLine line;
    line.points.push_back(crossing(h, level));
    line.from_halfedge = h;
    line.from_level = level;
    while (true) {
      const Index triangle = h / 3;
      char& seen = seen_[first_[at(triangle)] + static_cast<std::size_t>(level - lowest_[at(triangle)])];
      if (seen != 0) {
        line.closed = true;
        line.points.pop_back();
        break;
      }
      seen = 1;
      line.triangles.push_back(triangle);
      Index exit = geometry::next_halfedge(h);
      if (!rises(exit, level)) exit = geometry::next_halfedge(exit);
      line.points.push_back(crossing(exit, level));
      h = beyond(exit);
      if (h == no_index) {
        line.to_halfedge = exit;
        line.to_level = level;
        break;
      }
      level += jump(exit) - jump(geometry::next_halfedge(h));
    }
    measure(line);
    return line;
  }

  void measure(LevelLine& line) const {
    line.length_mm = planner::length_mm(mesh_, line.points);
    if (line.closed) {
      line.length_mm += (position_mm(mesh_, line.points.front()) - position_mm(mesh_, line.points.back())).norm();
    }
  }

  const TriangleMesh& mesh_;
  const MeshTopology& topology_;
  CornerValues values_;
  double offset_;
  std::vector<std::size_t> first_;  ///< number of the first (triangle, level) of each triangle
  std::vector<long> lowest_;
  std::vector<char> seen_;
};

}  // namespace

std::vector<LevelLine> trace_levels(const TriangleMesh& mesh, const MeshTopology& topology, const CornerValues& values,
                                    double offset) {
  VOLUTE_CHECK(values.vertex.size() == mesh.vertices_mm.size(), values.vertex.size());
  VOLUTE_CHECK(values.jump.empty() || values.jump.size() == mesh.triangles.size(), values.jump.size());
  auto lines = LevelWalker(mesh, topology, values, offset).all();
  std::stable_sort(lines.begin(), lines.end(),
                   [](const LevelLine& a, const LevelLine& b) { return a.length_mm > b.length_mm; });
  return lines;
}

}  // namespace volute::planner
