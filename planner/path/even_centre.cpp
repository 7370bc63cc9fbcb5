#include "planner/path/even_centre.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/even_field.hpp"
#include "planner/path/even_path.hpp"
#include "planner/path/even_ridge.hpp"

namespace volute::planner {

using geometry::at;
namespace {
constexpr double hopeless = std::numeric_limits<double>::infinity();
constexpr double ridge_kept_share = 0.15;  ///< of the depth: ways along ridges are as straight as this lets them be

/// A centre and the path length that its field promises, mm; infinite where there is none.
struct Scored {
  double score = std::numeric_limits<double>::infinity();
  Centre centre;
};

/// The search on the coarse mesh.
class CentreSearch {
 public:
  CentreSearch(const EvenSurface& coarse, const IntervalRule& rule, const CentreSearchOptions& options)
      : coarse_(coarse), rule_(rule), options_(options), ways_(coarse.mesh) {
    depth_mm_ = ways_.distance_mm(coarse.topology.boundary_loops()[0].vertices);
    const auto& loops = coarse.topology.boundary_loops();
    loop_of_.assign(coarse.mesh.vertices_mm.size(), geometry::no_index);
    for (std::size_t l = 0; l < loops.size(); ++l) {
      for (Index v : loops[l].vertices) loop_of_[at(v)] = static_cast<Index>(l);
    }
    room_mm_ = room_but({});
    const double interval_mm = rule.interval_mm(0.0), roomiest_mm = *std::max_element(room_mm_.begin(), room_mm_.end());
    room_least_mm_ = std::max(0.5 * interval_mm, std::min(1.5 * interval_mm, 0.5 * roomiest_mm));
    for (Index v = 0; v < static_cast<Index>(depth_mm_.size()); ++v) {
      if (!usable(v)) continue;
      usable_.push_back(v);
      deepest_mm_ = std::max(deepest_mm_, depth_mm_[at(v)]);
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
      grow(s, found);
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
  /// Moves the ends of a start and adds arms; every step goes to `found`. A start far behind the best has its arms
  /// added first, where they stand, and is kept as it is where that does not bring it near.
  void grow(const Scored& start, std::vector<Scored>& found) {
    const auto best = std::min_element(found.begin(), found.end(),
                                       [](const Scored& a, const Scored& b) { return a.score < b.score; });
    const double near = best == found.end() ? hopeless : options_.grown_within * best->score;
    Scored grown = along_ridges(start);
    int arm = 0;
    const auto add_arm = [&] {
      const Scored more = one_arm_more(grown);
      const bool shorter = more.score < (1.0 - options_.arm_gain_min) * grown.score;
      if (shorter) grown = more;
      return shorter;
    };
    while (options_.ridges && grown.score > near && arm < options_.arms_max && add_arm()) ++arm;
    if (grown.score > near) {
      found.push_back(grown);
      return;
    }
    found.push_back(grown = moved_ends(grown));
    while (arm < options_.arms_max && add_arm()) {
      ++arm;
      found.push_back(grown = moved_ends(grown));
    }
  }

  /// A single slit laid along the ridge between its ends, where that is shorter.
  [[nodiscard]] Scored along_ridges(const Scored& straight) {
    if (!options_.ridges || straight.centre.arms.size() != 1 || straight.centre.has_loop()) return straight;
    const Arm& arm = straight.centre.arms.front();
    const auto bent = with_way({geometry::no_index, {}}, {arm.from}, arm.to);
    if (bent.arms.size() < 2) return straight;
    const Scored other = scores({bent}).front();
    return other.score < straight.score ? other : straight;
  }

  /// Distance from every boundary but those of the holes given, mm.
  [[nodiscard]] std::vector<double> room_but(const std::vector<Index>& held) const {
    std::vector<Index> sources;
    for (std::size_t v = 0; v < loop_of_.size(); ++v) {
      const Index loop = loop_of_[v];
      if (loop != geometry::no_index && std::find(held.begin(), held.end(), loop) == held.end())
        sources.push_back(static_cast<Index>(v));
    }
    return ways_.distance_mm(sources);
  }

  /// The centre with arms along the ridge from one of its nodes (or of `sources`) to a target.
  [[nodiscard]] Centre with_way(Centre base, const std::vector<Index>& sources, Index target) const {
    const double kept_mm = std::max(ridge_kept_share * deepest_mm_, 0.5 * rule_.interval_mm(0.0));
    std::vector<Index> held = loops_of(base);
    if (loop_of_[at(target)] != geometry::no_index) held.push_back(loop_of_[at(target)]);
    const auto way = ways_.way(sources, target, held.empty() ? room_mm_ : room_but(held), kept_mm);
    for (std::size_t i = 1; i < way.size(); ++i) base.arms.push_back({way[i - 1], way[i]});
    return base;
  }

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

  /// Ends of the arms, and the vertices of every hole that the centre holds.
  [[nodiscard]] std::vector<Index> nodes_of(const Centre& centre) const {
    const auto& loops = coarse_.topology.boundary_loops();
    std::vector<Index> out;
    for (const Index loop : loops_of(centre)) {
      const auto& vertices = loops[at(loop)].vertices;
      out.insert(out.end(), vertices.begin(), vertices.end());
    }
    for (const Arm& arm : centre.arms) {
      for (Index v : {arm.from, arm.to}) {
        if (std::find(out.begin(), out.end(), v) == out.end()) out.push_back(v);
      }
    }
    return out;
  }

  /// Holes that the centre holds: its loop, and those to which an arm leads.
  [[nodiscard]] std::vector<Index> loops_of(const Centre& centre) const {
    std::vector<Index> out;
    if (centre.has_loop()) out.push_back(centre.loop);
    for (const Arm& arm : centre.arms) {
      for (Index v : {arm.from, arm.to}) {
        const Index loop = loop_of_[at(v)];
        if (loop != geometry::no_index && std::find(out.begin(), out.end(), loop) == out.end()) out.push_back(loop);
      }
    }
    return out;
  }

  /// A vertex of each hole that the centre does not hold, the nearest to one of its nodes.
  [[nodiscard]] std::vector<Index> other_holes(const Centre& centre, const std::vector<Index>& nodes) const {
    const auto held = loops_of(centre);
    const auto& loops = coarse_.topology.boundary_loops();
    std::vector<Index> out;
    for (Index loop = 1; loop < static_cast<Index>(loops.size()); ++loop) {
      if (std::find(held.begin(), held.end(), loop) != held.end()) continue;
      Index nearest = geometry::no_index;
      double least = hopeless;
      for (Index v : loops[at(loop)].vertices) {
        for (Index node : nodes) {
          const double off = (coarse_.mesh.vertices_mm[at(v)] - coarse_.mesh.vertices_mm[at(node)]).squaredNorm();
          if (off >= least) continue;
          least = off;
          nearest = v;
        }
      }
      out.push_back(nearest);
    }
    return out;
  }

  /// The best centre with an arm more, from what is there to a far point (or to another hole). A single slit may be met
  /// in its middle.
  [[nodiscard]] Scored one_arm_more(const Scored& best) {
    std::vector<Centre> more;
    std::vector<Centre> bases = {best.centre};
    if (const auto bent = with_middle(best.centre)) bases.push_back(*bent);
    for (const Centre& base : bases) {
      const std::vector<Index> nodes = nodes_of(base);
      std::vector<Index> targets = far_points(nodes, 0.3, options_.arm_targets);
      const auto holes = options_.ridges ? other_holes(base, nodes) : std::vector<Index>{};
      targets.insert(targets.end(), holes.begin(), holes.end());
      for (Index target : targets) {
        const auto off = [&](Index v) {
          return (coarse_.mesh.vertices_mm[at(v)] - coarse_.mesh.vertices_mm[at(target)]).squaredNorm();
        };
        const Index from =
            *std::min_element(nodes.begin(), nodes.end(), [&](Index a, Index b) { return off(a) < off(b); });
        more.push_back(base);
        more.back().arms.push_back({from, target});
        if (!options_.ridges) continue;
        const Centre ridge = with_way(base, nodes, target);
        if (key_of(ridge) != key_of(more.back()) && ridge.arms.size() > base.arms.size()) more.push_back(ridge);
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
    auto domain = even_domain(coarse_, centre);
    if (!domain) return hopeless;
    const auto solver = EvenFieldSolver::build(*domain, rule_, options_.field, std::nullopt);
    if (!solver) return hopeless;
    EvenField field = solver->start();
    const std::vector<double> gain(domain->mesh.triangles.size(), 1.0);
    solver->improve(field, gain, options_.outer, options_.inner);
    const double length_mm = promised_length_mm(*domain, rule_, solver->slopes(field));
    return even_path(*domain, field, rule_.interval_mm(0.0)).pieces == 1 ? length_mm : surcharge_pieces * length_mm;
  }

  [[nodiscard]] Index nearest(const Vec3& place) const { return nearest_vertex(coarse_.mesh, usable_, place); }

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
  RidgeWays ways_;
  std::vector<Index> usable_;               ///< vertices at which a slit may end
  std::vector<Index> loop_of_;              ///< per vertex: the boundary loop it lies on
  std::vector<double> depth_mm_, room_mm_;  ///< from the outer boundary; from any boundary
  double deepest_mm_ = 0.0, room_least_mm_ = 0.0;
  std::map<std::vector<Index>, double> known_;  ///< scores by loop and arms
};

}  // namespace

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
