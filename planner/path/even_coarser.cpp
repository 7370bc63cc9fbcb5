#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>

#include "planner/path/even_resample.hpp"

#include "geometry/index.hpp"

namespace volute::planner {
namespace {

using geometry::at;
using geometry::no_index;
using geometry::Triangle;
using geometry::Vec3;

struct Candidate {
  double length_mm;
  Index gone, kept;
  bool operator>(const Candidate& o) const {
    if (length_mm != o.length_mm) return length_mm > o.length_mm;
    return gone != o.gone ? gone > o.gone : kept > o.kept;
  }
};

/// A mesh under half-edge collapses: triangles by vertex, dead ones dropped as they are met.
class Collapser {
 public:
  Collapser(const TriangleMesh& mesh, double edge_mm, double boundary_mm)
      : position_(mesh.vertices_mm),
        triangle_(mesh.triangles),
        edge_mm_(edge_mm),
        boundary_mm_(boundary_mm),
        around_(mesh.vertices_mm.size()),
        loop_of_(mesh.vertices_mm.size(), no_index) {
    for (std::size_t t = 0; t < triangle_.size(); ++t) {
      for (Index v : triangle_[t]) around_[at(v)].push_back(static_cast<Index>(t));
    }
    if (const auto topology = geometry::MeshTopology::build(mesh)) {
      for (const auto& loop : topology->boundary_loops()) {
        for (Index v : loop.vertices) loop_of_[at(v)] = static_cast<Index>(loop_size_.size());
        loop_size_.push_back(loop.vertices.size());
      }
    }
  }

  void run() {
    queue_all();
    Candidate refused{0.0, no_index, no_index};  // an edge is queued by each change beside it: once is enough to ask
    while (const std::optional<Candidate> next = pop()) {
      const Candidate& c = *next;
      if (around_[at(c.gone)].empty() || around_[at(c.kept)].empty()) continue;
      if (c.gone == refused.gone && c.kept == refused.kept) continue;
      if (!allowed(c.gone, c.kept)) {
        refused = c;
        continue;
      }
      refused = {0.0, no_index, no_index};
      collapse(c.gone, c.kept);
      push(c.kept);
    }
  }

  [[nodiscard]] CoarseMesh result() const {
    CoarseMesh out;
    std::vector<Index> number(position_.size(), no_index);
    for (std::size_t v = 0; v < position_.size(); ++v) {
      if (around_[v].empty()) continue;
      number[v] = static_cast<Index>(out.original.size());
      out.original.push_back(static_cast<Index>(v));
      out.mesh.vertices_mm.push_back(position_[v]);
    }
    for (const Triangle& t : triangle_) {
      if (t[0] != no_index) out.mesh.triangles.push_back({number[at(t[0])], number[at(t[1])], number[at(t[2])]});
    }
    return out;
  }

 private:
  [[nodiscard]] bool on_boundary(Index v) const { return loop_of_[at(v)] != no_index; }

  /// Neighbours of v, each as often as an edge to it has a triangle: once marks a boundary edge.
  void neighbours(Index v, std::vector<Index>& out) const {
    out.clear();
    for (Index t : around_[at(v)]) {
      for (Index w : triangle_[at(t)]) {
        if (w != v) out.push_back(w);
      }
    }
    std::sort(out.begin(), out.end());
  }

  /// The edges of the given mesh, sorted once: a heap of them all would be walked from end to end of memory.
  void queue_all() {
    for (Index v = 0; v < static_cast<Index>(position_.size()); ++v) {
      neighbours(v, near_gone_);
      near_gone_.erase(std::unique(near_gone_.begin(), near_gone_.end()), near_gone_.end());
      for (Index w : near_gone_) {
        const double length = (position_[at(v)] - position_[at(w)]).norm();
        if (length < edge_mm_) given_.push_back({length, v, w});
      }
    }
    tbb::parallel_sort(given_.begin(), given_.end(), [](const Candidate& a, const Candidate& b) { return b > a; });
  }

  /// The shortest edge queued, given or later; nothing where none is left.
  [[nodiscard]] std::optional<Candidate> pop() {
    const bool given = next_given_ < given_.size();
    if (given && (queue_.empty() || queue_.top() > given_[next_given_])) return given_[next_given_++];
    if (queue_.empty()) return {};
    const Candidate out = queue_.top();
    queue_.pop();
    return out;
  }

  void push(Index v) {
    std::vector<Index>& near = near_gone_;
    neighbours(v, near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (Index w : near) {
      const double length = (position_[at(v)] - position_[at(w)]).norm();
      if (length >= edge_mm_) continue;
      queue_.push({length, v, w});
      queue_.push({length, w, v});
    }
  }

  [[nodiscard]] bool boundary_keeps_shape(Index gone, Index kept, const std::vector<Index>& near_gone) const {
    if (loop_size_[at(loop_of_[at(gone)])] <= 8) return false;
    for (Index w : near_gone) {
      if (w == kept || std::count(near_gone.begin(), near_gone.end(), w) != 1) continue;
      const Vec3 chord = position_[at(kept)] - position_[at(w)], to = position_[at(gone)] - position_[at(w)];
      return to.cross(chord).norm() <= boundary_mm_ * chord.norm() && to.dot(chord) > 0.0;
    }
    return false;
  }

  [[nodiscard]] bool allowed(Index gone, Index kept) {
    std::vector<Index>&near_gone = near_gone_, &near_kept = near_kept_, &shared = shared_;
    neighbours(gone, near_gone);
    const auto edge_triangles = std::count(near_gone.begin(), near_gone.end(), kept);
    if (edge_triangles == 0) return false;
    if (on_boundary(gone) && (edge_triangles != 1 || !boundary_keeps_shape(gone, kept, near_gone))) return false;
    // Link condition: the two vertices share no more neighbours than the edge has triangles.
    neighbours(kept, near_kept);
    shared.clear();
    std::set_intersection(near_gone.begin(), near_gone.end(), near_kept.begin(), near_kept.end(),
                          std::back_inserter(shared));
    shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
    if (static_cast<std::ptrdiff_t>(shared.size()) != edge_triangles) return false;
    for (Index t : around_[at(gone)]) {
      const Triangle& old = triangle_[at(t)];
      if (std::find(old.begin(), old.end(), kept) == old.end() && !stays_sound(old, gone, kept)) return false;
    }
    return true;
  }

  [[nodiscard]] bool stays_sound(const Triangle& old, Index gone, Index kept) const {
    constexpr double turn_cosine_min = 0.7071;  // 45 degrees
    constexpr double height_share_min = 0.2;    // least height over longest edge
    std::array<Vec3, 3> p, q;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = position_[at(old[k])];
      q[k] = position_[at(old[k] == gone ? kept : old[k])];
    }
    const Vec3 before = (p[1] - p[0]).cross(p[2] - p[0]), after = (q[1] - q[0]).cross(q[2] - q[0]);
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, (q[(k + 1) % 3] - q[k]).norm());
    if (longest > 2.0 * edge_mm_) return false;
    if (before.dot(after) < turn_cosine_min * before.norm() * after.norm()) return false;
    return after.norm() >= height_share_min * longest * longest ||
           after.norm() * longest >= before.norm() * 4.0 * edge_mm_;
  }

  void collapse(Index gone, Index kept) {
    if (on_boundary(gone)) --loop_size_[at(loop_of_[at(gone)])];
    for (Index t : around_[at(gone)]) {
      Triangle& corners = triangle_[at(t)];
      if (std::find(corners.begin(), corners.end(), kept) != corners.end()) {
        for (Index w : corners) {
          if (w != gone) std::erase(around_[at(w)], t);
        }
        corners = {no_index, no_index, no_index};
        continue;
      }
      std::replace(corners.begin(), corners.end(), gone, kept);
      around_[at(kept)].push_back(t);
    }
    around_[at(gone)].clear();
  }

  std::vector<Vec3> position_;
  std::vector<Triangle> triangle_;
  double edge_mm_, boundary_mm_;
  std::vector<std::vector<Index>> around_;
  std::vector<Index> loop_of_;
  std::vector<std::size_t> loop_size_;
  std::vector<Index> near_gone_, near_kept_, shared_;  ///< workspace
  std::vector<Candidate> given_;
  std::size_t next_given_ = 0;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

CoarseMesh coarser(const TriangleMesh& mesh, double edge_mm, double boundary_mm) {
  Collapser collapser(mesh, edge_mm, boundary_mm);
  collapser.run();
  return collapser.result();
}

}  // namespace volute::planner
