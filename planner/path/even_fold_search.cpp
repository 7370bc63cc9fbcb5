#include "planner/path/even_fold_search.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/index.hpp"
#include "planner/path/even_centre.hpp"
#include "planner/path/even_collar.hpp"
#include "planner/path/even_fold.hpp"
#include "planner/path/even_fold_pull.hpp"
#include "planner/path/even_ridge.hpp"

namespace volute::planner {

using geometry::at;
namespace {

constexpr double hopeless_fold = std::numeric_limits<double>::infinity();
constexpr double room_least_intervals = 1.5;
constexpr double same_pass_turns = 1.5;       ///< ends of a fold lie on nearly the same pass: phi differs by no more
constexpr double ends_apart_intervals = 2.0;  ///< as lay_folds asks for

using Folds = std::vector<Fold>;

struct ScoredFolds {
  double score = hopeless_fold;
  Folds folds;
};

/// What the field of a centre tells of one fold more.
struct FoldLook {
  std::vector<double> phi, pull_mm;  ///< per vertex of the domain
  std::vector<Vec3> drawn;           ///< per vertex: along the gradient of the pull
};

/// Folds of one centre.
class FoldSearch {
 public:
  /// Requires: the domain of the centre, without folds; `room_mm` per vertex, from every boundary.
  FoldSearch(const EvenSurface& surface, const EvenDomain& domain, const IntervalRule& rule,
             const FoldSearchOptions& options, std::span<const double> room_mm)
      : surface_(surface), domain_(domain), rule_(rule), options_(options) {
    const double least_mm = room_least_intervals * rule.interval_mm(0.0);
    std::vector<char> given(domain.mesh.vertices_mm.size(), 0);
    for (const CollarVertex& c : slit_collar(domain, rule)) given[at(c.vertex)] = 1;
    for (Index v = 0; v < static_cast<Index>(room_mm.size()); ++v) {
      if (room_mm[at(v)] >= least_mm && given[at(v)] == 0 && !domain.topology.is_boundary_vertex(v)) pool_.push_back(v);
      roomiest_mm_ = std::max(roomiest_mm_, room_mm[at(v)]);
    }
  }

  /// Every number of folds, the most first, and none.
  [[nodiscard]] std::vector<ScoredFolds> run() const {
    std::vector<ScoredFolds> out{scored({})};
    int tried = options_.tried;
    while (!pool_.empty() && static_cast<int>(out.front().folds.size()) < options_.folds_max) {
      ScoredFolds next = one_more(out.front().folds, tried);
      if (next.score < hopeless_fold) next = moved_ends(std::move(next), next.folds.size() - 1);
      if (next.score < (1.0 - options_.gain_min) * out.front().score) {
        out.insert(out.begin(), std::move(next));
        tried = options_.tried;
        continue;
      }
      if (tried != options_.tried) break;
      tried = options_.tried_at_last;
      for (std::size_t k = 0; k < out.front().folds.size(); ++k) out.front() = moved_ends(std::move(out.front()), k);
    }
    return out;
  }

 private:
  struct Trial {
    EvenDomain domain;
    EvenField field;
    double length_mm = 0.0;
  };

  [[nodiscard]] std::optional<Trial> trial(const Folds& folds) const {
    Trial out{domain_, {}, 0.0};
    if (!lay_folds(out.domain, rule_, folds)) return {};
    const auto solver = EvenFieldSolver::build(out.domain, rule_, options_.field, std::nullopt);
    if (!solver) return {};
    out.field = solver->start();
    solver->improve(out.field, std::vector<double>(out.domain.mesh.triangles.size(), 1.0), options_.outer,
                    options_.inner);
    out.length_mm = promised_length_mm(out.domain, rule_, solver->slopes(out.field));
    return out;
  }

  [[nodiscard]] ScoredFolds scored(Folds folds) const {
    constexpr double surcharge_misfit = 0.02;
    const auto tried = trial(folds);
    if (!tried) return {hopeless_fold, std::move(folds)};
    return {tried->length_mm * (1.0 + surcharge_misfit * fold_misfit(tried->domain, tried->field)), std::move(folds)};
  }

  [[nodiscard]] ScoredFolds best_of(const std::vector<Folds>& choices) const {
    std::vector<ScoredFolds> all(choices.size());
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) { all[i] = scored(choices[i]); });
    if (all.empty()) return {};
    return *std::min_element(all.begin(), all.end(),
                             [](const ScoredFolds& a, const ScoredFolds& b) { return a.score < b.score; });
  }

  [[nodiscard]] std::optional<FoldLook> look_at(const Folds& folds) const {
    auto tried = trial(folds);
    if (!tried) return {};
    auto pull = fold_pull_mm(tried->domain, rule_, options_.field, tried->field);
    if (!pull) return {};
    FoldLook out{std::move(tried->field.phi), std::move(*pull), {}};
    out.drawn.assign(out.phi.size(), Vec3::Zero());
    const auto slope = gradient(domain_.mesh, domain_.operators, out.pull_mm);
    for (std::size_t t = 0; t < slope.size(); ++t) {
      for (Index v : domain_.mesh.triangles[t])
        out.drawn[at(v)] += domain_.operators[t].area_mm2 * domain_.operators[t].to_space(slope[t]);
    }
    return out;
  }

  [[nodiscard]] double apart_mm(Index a, Index b) const {
    return (surface_.mesh.vertices_mm[at(a)] - surface_.mesh.vertices_mm[at(b)]).norm();
  }

  /// Pairs of ends by what they promise, each another than those before it.
  [[nodiscard]] Folds promising(const Folds& folds, const FoldLook& look, int tried) const {
    const double least_mm = ends_apart_intervals * rule_.interval_mm(0.0), other_mm = 0.5 * roomiest_mm_;
    std::vector<Index> open;
    for (Index v : pool_) {
      const auto near = [&](const Fold& f) { return apart_mm(f.from, v) < least_mm || apart_mm(f.to, v) < least_mm; };
      if (std::none_of(folds.begin(), folds.end(), near)) open.push_back(v);
    }
    struct Pair {
      double saved_mm;
      Fold fold;
    };
    std::vector<Pair> pairs;
    for (Index from : open) {
      for (Index to : open) {
        const double saved_mm = look.pull_mm[at(to)] - look.pull_mm[at(from)];
        if (saved_mm <= 0.0 || std::abs(look.phi[at(from)] - look.phi[at(to)]) > same_pass_turns) continue;
        if (apart_mm(from, to) >= 2.0 * least_mm) pairs.push_back({saved_mm, {from, to}});
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
      return a.saved_mm != b.saved_mm ? a.saved_mm > b.saved_mm
                                      : std::pair(a.fold.from, a.fold.to) < std::pair(b.fold.from, b.fold.to);
    });
    Folds out;
    for (const Pair& p : pairs) {
      if (static_cast<int>(out.size()) == tried) break;
      const auto same = [&](const Fold& f) {
        return apart_mm(f.from, p.fold.from) < other_mm && apart_mm(f.to, p.fold.to) < other_mm;
      };
      if (std::none_of(out.begin(), out.end(), same)) out.push_back(p.fold);
    }
    return out;
  }

  /// The best of the `tried` that promise most.
  [[nodiscard]] ScoredFolds one_more(const Folds& folds, int tried) const {
    const auto look = look_at(folds);
    if (!look) return {};
    std::vector<Folds> more;
    for (const Fold& fold : promising(folds, *look, tried)) {
      more.push_back(folds);
      more.back().push_back(fold);
    }
    return best_of(more);
  }

  /// The ends of one fold moved to where they are drawn; the step shrinks where no move helps.
  [[nodiscard]] ScoredFolds moved_ends(ScoredFolds best, std::size_t fold) const {
    for (double step_mm = 0.5 * roomiest_mm_; step_mm >= 0.1 * roomiest_mm_; step_mm /= 1.8) {
      for (int moves = 0; moves < options_.moves_max; ++moves) {
        const auto look = look_at(best.folds);
        if (!look) return best;
        auto next = best_of(drawn(best.folds, *look, fold, step_mm));
        if (!(next.score < (1.0 - options_.move_gain_min) * best.score)) break;
        best = std::move(next);
      }
    }
    return best;
  }

  /// Either end, and both, a step along what draws them.
  [[nodiscard]] std::vector<Folds> drawn(const Folds& folds, const FoldLook& look, std::size_t fold,
                                         double step_mm) const {
    const Fold& here = folds[fold];
    const auto moved = [&](Index end, double sign) {
      const Vec3& along = look.drawn[at(end)];
      if (!(along.norm() > 0.0)) return end;
      return nearest_vertex(surface_.mesh, pool_,
                            surface_.mesh.vertices_mm[at(end)] + sign * step_mm * along.normalized());
    };
    const Index from = moved(here.from, -1.0), to = moved(here.to, 1.0);
    std::vector<Folds> out;
    for (const Fold& f : {Fold{from, to}, Fold{from, here.to}, Fold{here.from, to}}) {
      if ((f.from == here.from && f.to == here.to) || f.from == f.to) continue;
      out.push_back(folds);
      out.back()[fold] = f;
    }
    return out;
  }

  const EvenSurface& surface_;
  const EvenDomain& domain_;
  IntervalRule rule_;
  FoldSearchOptions options_;
  std::vector<Index> pool_;  ///< vertices at which folds may end
  double roomiest_mm_ = 0.0;
};

std::vector<double> room_of(const EvenSurface& surface) {
  std::vector<Index> rim;
  for (const auto& loop : surface.topology.boundary_loops())
    rim.insert(rim.end(), loop.vertices.begin(), loop.vertices.end());
  return RidgeWays(surface.mesh).distance_mm(rim);
}

}  // namespace

Result<std::vector<Centre>> with_folds(const EvenSurface& surface, const IntervalRule& rule,
                                       const FoldSearchOptions& options, const Centre& start) {
  const auto domain = even_domain(surface, start);
  if (!domain) return tl::unexpected(domain.error());
  auto found = FoldSearch(surface, *domain, rule, options, room_of(surface)).run();
  std::stable_sort(found.begin(), found.end(),
                   [](const ScoredFolds& a, const ScoredFolds& b) { return a.score < b.score; });
  std::vector<Centre> out;
  for (ScoredFolds& s : found) {
    out.push_back(start);
    out.back().folds = std::move(s.folds);
  }
  return out;
}

}  // namespace volute::planner
