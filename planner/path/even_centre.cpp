#include "planner/path/even_centre.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <queue>

#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/even_field.hpp"
#include "planner/path/even_path.hpp"
#include "planner/path/even_resample.hpp"
#include "planner/surface/condition.hpp"

namespace volute::planner {

using geometry::at;
namespace {

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
    const double interval_mm = rule.interval_mm(0.0), roomiest_mm = *std::max_element(room_mm_.begin(), room_mm_.end());
    room_least_mm_ = std::max(0.5 * interval_mm, std::min(1.5 * interval_mm, 0.5 * roomiest_mm));
    for (Index v = 0; v < static_cast<Index>(depth_mm_.size()); ++v) {
      if (usable(v)) deepest_mm_ = std::max(deepest_mm_, depth_mm_[at(v)]);
    }
  }

  /// Every centre that was grown, with every number of arms; the best comes first.
  [[nodiscard]] std::vector<Scored> run() {
    std::vector<Centre> first;
    for (Index loop = 1; loop < static_cast<Index>(coarse_.topology.boundary_loops().size()); ++loop)
      first.push_back({loop, {}});
    const std::vector<Index> deep = far_points({}, 0.6, options_.deep_points);
    for (std::size_t i = 0; i < deep.size(); ++i) {
      for (std::size_t j = i + 1; j < deep.size(); ++j) first.push_back({geometry::no_index, {{deep[i], deep[j]}}});
    }
    std::vector<Scored> scored = scores(first);
    std::stable_sort(scored.begin(), scored.end(), [](const Scored& a, const Scored& b) { return a.score < b.score; });
    std::vector<Scored> found;
    int slits = 0, loops = 0;
    for (const Scored& s : scored) {
      int& started = s.centre.has_loop() ? loops : slits;
      if (!(s.score < hopeless) || started == (s.centre.has_loop() ? options_.loop_starts : options_.starts)) continue;
      ++started;
      const auto best = std::min_element(found.begin(), found.end(),
                                         [](const Scored& a, const Scored& b) { return a.score < b.score; });
      if (best != found.end() && s.score > options_.grown_within * best->score) {
        found.push_back(s);
        continue;
      }
      found.push_back(moved_ends(s));
      for (int arm = 0; arm < options_.arms_max; ++arm) {
        const Scored more = one_arm_more(found.back());
        if (!(more.score < (1.0 - options_.arm_gain_min) * found.back().score)) break;
        found.push_back(moved_ends(more));
      }
    }
    std::stable_sort(found.begin(), found.end(), [](const Scored& a, const Scored& b) { return a.score < b.score; });
    return found;
  }

  /// Equal for equal centres.
  static std::vector<Index> key_of(const Centre& centre) {
    std::vector<Index> key{centre.loop};
    for (const Arm& arm : centre.arms) key.insert(key.end(), {arm.from, arm.to});
    return key;
  }

 private:
  /// A slit's end keeps off every boundary: the turns around it need room, as much as there is in narrow parts.
  [[nodiscard]] bool usable(Index v) const {
    return !coarse_.topology.is_boundary_vertex(v) && room_mm_[at(v)] >= room_least_mm_;
  }

  /// Points at least `depth_share_min` as far from the outer boundary as the deepest one, each as far as can be from
  /// those before it and from `from`; the deepest comes first where there is no `from`.
  [[nodiscard]] std::vector<Index> far_points(const std::vector<Index>& from, double depth_share_min, int count) const {
    std::vector<Index> pool;
    for (Index v = 0; v < static_cast<Index>(depth_mm_.size()); ++v) {
      if (usable(v) && depth_mm_[at(v)] >= depth_share_min * deepest_mm_) pool.push_back(v);
    }
    const auto place = [&](Index v) -> const Vec3& { return coarse_.mesh.vertices_mm[at(v)]; };
    std::vector<double> far(pool.size(), hopeless);
    for (std::size_t i = 0; i < pool.size(); ++i) {
      for (Index v : from) far[i] = std::min(far[i], (place(pool[i]) - place(v)).norm());
    }
    std::vector<Index> out;
    while (static_cast<int>(out.size()) < count && !pool.empty()) {
      const auto better = [&](std::size_t a, std::size_t b) {
        return far[a] != far[b] ? far[a] > far[b] : depth_mm_[at(pool[a])] > depth_mm_[at(pool[b])];
      };
      std::size_t next = 0;
      for (std::size_t i = 1; i < pool.size(); ++i) next = better(i, next) ? i : next;
      if (!(far[next] > 0.0)) break;
      out.push_back(pool[next]);
      for (std::size_t i = 0; i < pool.size(); ++i)
        far[i] = std::min(far[i], (place(pool[i]) - place(out.back())).norm());
    }
    return out;
  }

  /// Ends of the arms, and the loop's vertices where the centre has one.
  [[nodiscard]] std::vector<Index> nodes_of(const Centre& centre) const {
    std::vector<Index> out;
    if (centre.has_loop()) out = coarse_.topology.boundary_loops()[at(centre.loop)].vertices;
    for (const Arm& arm : centre.arms) {
      for (Index v : {arm.from, arm.to}) {
        if (std::find(out.begin(), out.end(), v) == out.end()) out.push_back(v);
      }
    }
    return out;
  }

  /// The best centre with an arm more, from what is there to a far point. A single slit may be met in its middle.
  [[nodiscard]] Scored one_arm_more(const Scored& best) {
    std::vector<Centre> more;
    std::vector<Centre> bases = {best.centre};
    if (const auto bent = with_middle(best.centre)) bases.push_back(*bent);
    for (const Centre& base : bases) {
      const std::vector<Index> nodes = nodes_of(base);
      for (Index target : far_points(nodes, 0.3, options_.arm_targets)) {
        const auto off = [&](Index v) {
          return (coarse_.mesh.vertices_mm[at(v)] - coarse_.mesh.vertices_mm[at(target)]).squaredNorm();
        };
        const Index from =
            *std::min_element(nodes.begin(), nodes.end(), [&](Index a, Index b) { return off(a) < off(b); });
        more.push_back(base);
        more.back().arms.push_back({from, target});
      }
    }
    const std::vector<Scored> scored = scores(more);
    if (scored.empty()) return {};
    return *std::min_element(scored.begin(), scored.end(),
                             [](const Scored& a, const Scored& b) { return a.score < b.score; });
  }

  /// A single slit as two arms from its middle.
  [[nodiscard]] std::optional<Centre> with_middle(const Centre& centre) const {
    if (centre.has_loop() || centre.arms.size() != 1) return {};
    const Arm& arm = centre.arms.front();
    const Index middle = nearest(0.5 * (coarse_.mesh.vertices_mm[at(arm.from)] + coarse_.mesh.vertices_mm[at(arm.to)]));
    if (middle == arm.from || middle == arm.to) return {};
    return Centre{geometry::no_index, {{middle, arm.from}, {middle, arm.to}}};
  }

  /// Each centre is tried once, however often the moves lead to it.
  [[nodiscard]] std::vector<Scored> scores(const std::vector<Centre>& centres) {
    std::vector<Scored> out(centres.size());
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < centres.size(); ++i) {
      out[i].centre = centres[i];
      const auto known = known_.find(key_of(centres[i]));
      if (known != known_.end()) {
        out[i].score = known->second;
      } else {
        open.push_back(i);
      }
    }
    tbb::parallel_for(std::size_t{0}, open.size(),
                      [&](std::size_t k) { out[open[k]].score = score(centres[open[k]]); });
    for (std::size_t i : open) known_[key_of(centres[i])] = out[i].score;
    return out;
  }

  /// The path length that the field promises, mm.
  [[nodiscard]] double score(const Centre& centre) const {
    constexpr double surcharge_pieces = 1.2;
    const auto domain = even_domain(coarse_, centre);
    if (!domain) return hopeless;
    const auto solver = EvenFieldSolver::build(*domain, rule_, options_.field, std::nullopt);
    if (!solver) return hopeless;
    EvenField field = solver->start();
    const std::vector<double> gain(domain->mesh.triangles.size(), 1.0);
    solver->improve(field, gain, options_.outer, options_.inner);
    const double length_mm = promised_length_mm(*domain, rule_, solver->slopes(field));
    return even_path(*domain, field, rule_.interval_mm(0.0)).pieces == 1 ? length_mm : surcharge_pieces * length_mm;
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
  [[nodiscard]] Scored moved_ends(Scored best) {
    constexpr double gain_min = 2e-3;
    constexpr std::size_t batch =
        4;  // tried together, whatever the number of threads: the choice must not depend on it
    const double step_min_mm = 0.06 * deepest_mm_;
    int tried = 0;
    for (double step_mm = 0.18 * deepest_mm_; step_mm >= step_min_mm; step_mm /= 1.8) {
      bool moved = true;
      while (moved && tried < options_.moves_max) {
        moved = false;
        const std::vector<Centre> moves = moves_of(best.centre, step_mm);
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

  [[nodiscard]] std::vector<Centre> moves_of(const Centre& centre, double step_mm) const {
    std::vector<Centre> out;
    for (Index node : nodes_of({geometry::no_index, centre.arms})) {
      if (coarse_.topology.is_boundary_vertex(node)) continue;
      const Vec3 normal = coarse_.vertex_normals[at(node)];
      const Vec3 u = normal.unitOrthogonal(), w = normal.cross(u);
      for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3.0;
        const Index to =
            nearest(coarse_.mesh.vertices_mm[at(node)] + step_mm * (std::cos(angle) * u + std::sin(angle) * w));
        Centre moved = centre;
        for (Arm& arm : moved.arms) {
          if (arm.from == node) arm.from = to;
          if (arm.to == node) arm.to = to;
        }
        const auto no_length = [](const Arm& arm) { return arm.from == arm.to; };
        if (to == node || std::any_of(moved.arms.begin(), moved.arms.end(), no_length)) continue;
        out.push_back(std::move(moved));
      }
    }
    return out;
  }

  const EvenSurface& coarse_;
  IntervalRule rule_;
  CentreSearchOptions options_;
  std::vector<double> depth_mm_, room_mm_;  ///< from the outer boundary; from any boundary
  double deepest_mm_ = 0.0, room_least_mm_ = 0.0;
  std::map<std::vector<Index>, double> known_;  ///< scores by loop and arms
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

double promised_length_mm(const EvenDomain& domain, const IntervalRule& rule, std::span<const Vec2> slopes) {
  constexpr double settled_share = 0.93;  // of the needed gradient, reached on all but 0.5 % of the path
  double along_mm = 0.0;
  std::vector<std::pair<double, double>> reached;  // of the needed gradient, and the path length there
  for (std::size_t t = 0; t < slopes.size(); ++t) {
    const double slope = slopes[t].norm(), part_mm = domain.operators[t].area_mm2 * slope;
    const Vec3 direction = domain.operators[t].to_space(slopes[t] / std::max(slope, 1e-12));
    reached.emplace_back(slope * domain.interval_mm(rule, static_cast<Index>(t), direction), part_mm);
    along_mm += part_mm;
  }
  std::sort(reached.begin(), reached.end());
  double passed_mm = 0.0, share = 1.0;
  for (const auto& [ratio, part_mm] : reached) {
    passed_mm += part_mm;
    share = ratio;
    if (passed_mm >= 0.005 * along_mm) break;
  }
  const double ends_mm = 0.5 * (domain.outer.length_mm + domain.centre.length_mm);
  return (ends_mm + along_mm) / std::min(1.0, std::max(share, 0.05) / settled_share);
}

Result<EvenSurface> coarse_surface(const EvenSurface& surface, int triangles) {
  const double edge_mm = 1.25 * std::sqrt(geometry::area_mm2(surface.mesh) / triangles);
  const CoarseMesh coarse = coarser(surface.mesh, edge_mm, 0.1 * edge_mm);
  auto conditioned = condition(coarse.mesh, {.dihedral_max_rad = 0.8, .deviation_max_mm = 0.2 * edge_mm});
  if (!conditioned) return tl::unexpected(conditioned.error());
  return EvenSurface::build(conditioned->mesh);
}

Centre moved_centre(const EvenSurface& from, const Centre& centre, const EvenSurface& to) {
  Centre out;
  for (const Arm& arm : centre.arms) {
    const auto moved = [&](Index v) {
      return nearest_vertex(to, from.mesh.vertices_mm[at(v)], !from.topology.is_boundary_vertex(v));
    };
    const Arm there{moved(arm.from), moved(arm.to)};
    if (there.from != there.to) out.arms.push_back(there);
  }
  if (!centre.has_loop()) return out;
  const auto& loop = from.topology.boundary_loops()[at(centre.loop)];
  const Index vertex = nearest_vertex(to, from.mesh.vertices_mm[at(loop.vertices.front())], false);
  const auto& loops = to.topology.boundary_loops();
  for (Index l = 1; l < static_cast<Index>(loops.size()); ++l) {
    const auto& v = loops[at(l)].vertices;
    if (std::find(v.begin(), v.end(), vertex) != v.end()) out.loop = l;
  }
  return out;
}

Result<std::vector<Centre>> choose_centres(const EvenSurface& surface, const IntervalRule& rule,
                                           const PathOptions& options, const CentreSearchOptions& search) {
  const auto loops = static_cast<int>(surface.topology.boundary_loops().size());
  if (options.centre_loop >= loops || options.centre_loop == 0) {
    return geometry::bad_input("path-centre-loop", "path.centre_loop = " + std::to_string(options.centre_loop) +
                                                       ": the surface has inner loops 1 to " +
                                                       std::to_string(loops - 1) +
                                                       "; leave the key out to have a centre chosen");
  }
  if (options.centre_loop > 0) return std::vector<Centre>{{Index{options.centre_loop}, {}}};
  const auto coarse = coarse_surface(surface, search.triangles);
  if (!coarse) return tl::unexpected(coarse.error());
  const std::vector<Scored> found = CentreSearch(*coarse, rule, search).run();
  if (found.empty()) {
    return geometry::bad_input(
        "surface-too-coarse",
        "no inner vertex has half a path interval of room around it: refine the mesh or lower the scallop");
  }
  std::vector<Centre> out;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto same = [&](const Scored& s) {
      return CentreSearch::key_of(s.centre) == CentreSearch::key_of(found[i].centre);
    };
    const auto here = found.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::none_of(found.begin(), here, same)) out.push_back(moved_centre(*coarse, found[i].centre, surface));
  }
  return out;
}

}  // namespace volute::planner
