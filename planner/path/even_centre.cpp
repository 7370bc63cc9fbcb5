#include "planner/path/even_centre.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "geometry/mesh_measure.hpp"
#include "planner/path/even_field.hpp"
#include "planner/path/even_path.hpp"
#include "planner/path/even_resample.hpp"
#include "planner/surface/condition.hpp"

namespace volute::planner {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

constexpr double hopeless = std::numeric_limits<double>::infinity();

/// Edge-path distance of every vertex from a set, mm; infinite where none is reached.
std::vector<double> distance_mm(const TriangleMesh& mesh, const std::vector<Index>& sources) {
  std::vector<std::vector<std::pair<double, Index>>> next(mesh.vertices_mm.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      const double length = (mesh.vertices_mm[at(a)] - mesh.vertices_mm[at(b)]).norm();
      next[at(a)].emplace_back(length, b);
      next[at(b)].emplace_back(length, a);
    }
  }
  std::vector<double> out(mesh.vertices_mm.size(), hopeless);
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>, std::greater<>> queue;
  for (Index v : sources) {
    out[at(v)] = 0.0;
    queue.emplace(0.0, v);
  }
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > out[at(v)]) continue;
    for (const auto& [length, w] : next[at(v)]) {
      if (distance + length >= out[at(w)]) continue;
      out[at(w)] = distance + length;
      queue.emplace(out[at(w)], w);
    }
  }
  return out;
}

struct Scored {
  double score = hopeless;
  Centre centre;
};

/// The search on the coarse mesh.
class CentreSearch {
 public:
  CentreSearch(const EvenSurface& coarse, const IntervalRule& rule, const CentreSearchOptions& options)
      : coarse_(coarse), rule_(rule), options_(options) {
    const auto& loops = coarse.topology.boundary_loops();
    depth_mm_ = distance_mm(coarse.mesh, loops[0].vertices);
    std::vector<Index> all;
    for (const auto& loop : loops) all.insert(all.end(), loop.vertices.begin(), loop.vertices.end());
    room_mm_ = distance_mm(coarse.mesh, all);
    deepest_mm_ = 0.0;
    for (Index v = 0; v < static_cast<Index>(depth_mm_.size()); ++v) {
      if (usable(v)) deepest_mm_ = std::max(deepest_mm_, depth_mm_[at(v)]);
    }
  }

  [[nodiscard]] Scored run() const {
    std::vector<Centre> first;
    for (Index loop = 1; loop < static_cast<Index>(coarse_.topology.boundary_loops().size()); ++loop)
      first.emplace_back(loop);
    const std::vector<Index> deep = deep_points();
    for (std::size_t i = 0; i < deep.size(); ++i) {
      for (std::size_t j = i + 1; j < deep.size(); ++j) first.emplace_back(Slit{deep[i], deep[j]});
    }
    std::vector<Scored> scored = scores(first);
    std::stable_sort(scored.begin(), scored.end(), [](const Scored& a, const Scored& b) { return a.score < b.score; });
    if (scored.empty()) return {};
    Scored best = scored.front();
    int started = 0;
    for (const Scored& s : scored) {
      if (!std::holds_alternative<Slit>(s.centre) || started == options_.starts) continue;
      ++started;
      const Scored moved = moved_ends(s);
      if (moved.score < best.score) best = moved;
    }
    return best;
  }

 private:
  /// A slit's end keeps off every boundary: the loops around it need room.
  [[nodiscard]] bool usable(Index v) const {
    return !coarse_.topology.is_boundary_vertex(v) && room_mm_[at(v)] >= 0.5 * rule_.interval_mm(0.0);
  }

  /// Points far from the outer boundary, each as far as can be from the others.
  [[nodiscard]] std::vector<Index> deep_points() const {
    constexpr double depth_share_min = 0.6;
    std::vector<Index> pool;
    Index deepest = geometry::no_index;
    for (Index v = 0; v < static_cast<Index>(depth_mm_.size()); ++v) {
      if (!usable(v) || depth_mm_[at(v)] < depth_share_min * deepest_mm_) continue;
      pool.push_back(v);
      if (deepest == geometry::no_index || depth_mm_[at(v)] > depth_mm_[at(deepest)]) deepest = v;
    }
    std::vector<Index> out;
    std::vector<double> far(pool.size(), hopeless);
    for (Index next = deepest; next != geometry::no_index && static_cast<int>(out.size()) < options_.deep_points;) {
      out.push_back(next);
      double farthest = 0.0;
      next = geometry::no_index;
      for (std::size_t i = 0; i < pool.size(); ++i) {
        far[i] =
            std::min(far[i], (coarse_.mesh.vertices_mm[at(pool[i])] - coarse_.mesh.vertices_mm[at(out.back())]).norm());
        if (far[i] <= farthest) continue;
        farthest = far[i];
        next = pool[i];
      }
    }
    return out;
  }

  [[nodiscard]] std::vector<Scored> scores(const std::vector<Centre>& centres) const {
    std::vector<Scored> out(centres.size());
    tbb::parallel_for(std::size_t{0}, centres.size(), [&](std::size_t i) { out[i] = {score(centres[i]), centres[i]}; });
    return out;
  }

  /// The path length that the field promises, mm.
  [[nodiscard]] double score(const Centre& centre) const {
    constexpr double settled_share = 0.93;  // of the needed gradient, reached on all but 0.5 % of the path
    constexpr double surcharge_pieces = 1.2;
    const auto domain = even_domain(coarse_, centre);
    if (!domain) return hopeless;
    const auto solver = EvenFieldSolver::build(*domain, rule_, {}, std::nullopt);
    if (!solver) return hopeless;
    EvenField field = solver->start();
    const std::vector<double> gain(domain->mesh.triangles.size(), 1.0);
    solver->improve(field, gain, options_.outer, options_.inner);
    const auto slopes = solver->slopes(field);
    double length = 0.5 * (domain->outer.length_mm + domain->centre.length_mm), along = 0.0;
    std::vector<std::pair<double, double>> reached;  // of the needed gradient, and the path length there
    for (std::size_t t = 0; t < slopes.size(); ++t) {
      const double slope = slopes[t].norm(), part = domain->operators[t].area_mm2 * slope;
      const Vec3 direction = domain->operators[t].to_space(slopes[t] / std::max(slope, 1e-12));
      reached.emplace_back(slope * domain->interval_mm(rule_, static_cast<Index>(t), direction), part);
      along += part;
    }
    std::sort(reached.begin(), reached.end());
    double passed = 0.0, share = 1.0;
    for (const auto& [ratio, part] : reached) {
      passed += part;
      share = ratio;
      if (passed >= 0.005 * along) break;
    }
    length = (length + along) / std::min(1.0, std::max(share, 0.05) / settled_share);
    return even_path(*domain, field).pieces == 1 ? length : surcharge_pieces * length;
  }

  /// The usable vertex nearest to a place.
  [[nodiscard]] Index nearest(const Vec3& place) const {
    Index out = geometry::no_index;
    double least = hopeless;
    for (Index v = 0; v < static_cast<Index>(room_mm_.size()); ++v) {
      const double d = (coarse_.mesh.vertices_mm[at(v)] - place).squaredNorm();
      if (d >= least || !usable(v)) continue;
      least = d;
      out = v;
    }
    return out;
  }

  /// The ends moved in six directions each, a few moves at a time; the step shrinks where no move helps.
  [[nodiscard]] Scored moved_ends(Scored best) const {
    constexpr double gain_min = 2e-3;
    constexpr std::size_t batch =
        4;  // tried together, whatever the number of threads: the choice must not depend on it
    const double step_min_mm = 0.06 * deepest_mm_;
    int tried = 0;
    for (double step_mm = 0.18 * deepest_mm_; step_mm >= step_min_mm; step_mm /= 1.8) {
      bool moved = true;
      while (moved && tried < options_.moves_max) {
        moved = false;
        const std::vector<Centre> moves = moves_of(std::get<Slit>(best.centre), step_mm);
        for (std::size_t begin = 0; begin < moves.size() && !moved; begin += batch) {
          const auto end = std::min(begin + batch, moves.size());
          const auto some = scores(
              {moves.begin() + static_cast<std::ptrdiff_t>(begin), moves.begin() + static_cast<std::ptrdiff_t>(end)});
          tried += static_cast<int>(some.size());
          for (const Scored& s : some) {
            if (s.score >= (1.0 - gain_min) * best.score) continue;
            best = s;
            moved = true;
          }
        }
      }
    }
    return best;
  }

  [[nodiscard]] std::vector<Centre> moves_of(const Slit& slit, double step_mm) const {
    std::vector<Centre> out;
    for (bool first : {true, false}) {
      const Index from = first ? slit.from : slit.to;
      const Vec3 normal = coarse_.vertex_normals[at(from)];
      const Vec3 u = normal.unitOrthogonal(), w = normal.cross(u);
      for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3.0;
        const Index to =
            nearest(coarse_.mesh.vertices_mm[at(from)] + step_mm * (std::cos(angle) * u + std::sin(angle) * w));
        const Slit moved = first ? Slit{to, slit.to} : Slit{slit.from, to};
        if (moved.from != moved.to && to != from) out.emplace_back(moved);
      }
    }
    return out;
  }

  const EvenSurface& coarse_;
  IntervalRule rule_;
  CentreSearchOptions options_;
  std::vector<double> depth_mm_, room_mm_;  ///< from the outer boundary; from any boundary
  double deepest_mm_ = 0.0;
};

/// The vertex nearest to a place; off the boundaries where asked.
Index nearest_vertex(const EvenSurface& surface, const Vec3& place, bool inside) {
  Index out = geometry::no_index;
  double least = hopeless;
  for (Index v = 0; v < static_cast<Index>(surface.mesh.vertices_mm.size()); ++v) {
    const double d = (surface.mesh.vertices_mm[at(v)] - place).squaredNorm();
    if (d >= least || surface.topology.is_boundary_vertex(v) == inside) continue;
    least = d;
    out = v;
  }
  return out;
}

}  // namespace

Result<EvenSurface> coarse_surface(const EvenSurface& surface, int triangles) {
  const double edge_mm = 1.25 * std::sqrt(geometry::area_mm2(surface.mesh) / triangles);
  const CoarseMesh coarse = coarser(surface.mesh, edge_mm, 0.1 * edge_mm);
  auto conditioned = condition(coarse.mesh, {.dihedral_max_rad = 0.8, .deviation_max_mm = 0.2 * edge_mm});
  if (!conditioned) return tl::unexpected(conditioned.error());
  return EvenSurface::build(conditioned->mesh);
}

Centre moved_centre(const EvenSurface& from, const Centre& centre, const EvenSurface& to) {
  if (const Slit* slit = std::get_if<Slit>(&centre)) {
    return Slit{nearest_vertex(to, from.mesh.vertices_mm[at(slit->from)], true),
                nearest_vertex(to, from.mesh.vertices_mm[at(slit->to)], true)};
  }
  const auto& loop = from.topology.boundary_loops()[at(std::get<Index>(centre))];
  const Index vertex = nearest_vertex(to, from.mesh.vertices_mm[at(loop.vertices.front())], false);
  const auto& loops = to.topology.boundary_loops();
  for (Index l = 1; l < static_cast<Index>(loops.size()); ++l) {
    const auto& v = loops[at(l)].vertices;
    if (std::find(v.begin(), v.end(), vertex) != v.end()) return l;
  }
  return centre;
}

Result<Centre> choose_centre(const EvenSurface& surface, const IntervalRule& rule, const PathOptions& options,
                             const CentreSearchOptions& search) {
  const auto loops = static_cast<int>(surface.topology.boundary_loops().size());
  if (options.centre_loop >= loops || options.centre_loop == 0) {
    return geometry::bad_input("path-centre-loop", "path.centre_loop = " + std::to_string(options.centre_loop) +
                                                       ": the surface has inner loops 1 to " +
                                                       std::to_string(loops - 1) +
                                                       "; leave the key out to have a centre chosen");
  }
  if (options.centre_loop > 0) return Centre(Index{options.centre_loop});
  const auto coarse = coarse_surface(surface, search.triangles);
  if (!coarse) return tl::unexpected(coarse.error());
  const Scored best = CentreSearch(*coarse, rule, search).run();
  if (!(best.score < hopeless)) {
    return geometry::bad_input(
        "surface-too-coarse",
        "no inner vertex has half a path interval of room around it: refine the mesh or lower the scallop");
  }
  return moved_centre(*coarse, best.centre, surface);
}

}  // namespace volute::planner
