#include "planner/path/even_fold_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/index.hpp"
#include "planner/path/even_fold.hpp"

namespace volute::planner {

using geometry::at;
namespace {

constexpr double room_least_intervals = 1.5;
constexpr double same_pass_turns = 1.5;  ///< ends of a fold lie on nearly the same pass: phi differs by no more

class FoldSearch {
 public:
  FoldSearch(const EvenSurface& coarse, const IntervalRule& rule, const CentreSearchOptions& options,
             std::span<const double> room_mm, const ScoreCentres& score)
      : coarse_(coarse), rule_(rule), options_(options), score_(score) {
    const double least_mm = room_least_intervals * rule.interval_mm(0.0);
    for (Index v = 0; v < static_cast<Index>(room_mm.size()); ++v) {
      if (room_mm[at(v)] >= least_mm && !coarse.topology.is_boundary_vertex(v)) pool_.push_back(v);
      roomiest_mm_ = std::max(roomiest_mm_, room_mm[at(v)]);
    }
    spread_ends();
  }

  /// Each fold is the best of many, its ends then moved. For the first all pairs of ends are tried, for the others
  /// those that promised most before.
  [[nodiscard]] std::vector<ScoredCentre> run(ScoredCentre best) const {
    constexpr std::size_t settled_folds = 3;  // after so many all ends are moved again
    std::vector<ScoredCentre> out;
    std::vector<Fold> candidates = pairs(best.centre);
    bool all = true;  // the candidates are all pairs, and all ends stand where moving them has not helped
    while (static_cast<int>(best.centre.folds.size()) < options_.folds_max) {
      ScoredCentre next = one_more(best.centre, candidates);
      if (next.score < best.score) next = moved_ends(std::move(next), next.centre.folds.size() - 1);
      if (next.score < (1.0 - options_.fold_gain_min) * best.score) {
        best = std::move(next);
        if (best.centre.folds.size() % settled_folds == 0) best = all_moved(std::move(best));
        out.insert(out.begin(), best);
        all = false;
        continue;
      }
      if (all || out.empty()) break;
      out.front() = best = all_moved(std::move(best));
      candidates = pairs(best.centre);
      all = true;
    }
    return out;
  }

 private:
  /// Points far from each other, over all of the pool.
  void spread_ends() {
    const auto place = [&](Index v) -> const Vec3& { return coarse_.mesh.vertices_mm[at(v)]; };
    std::vector<double> far(pool_.size(), std::numeric_limits<double>::infinity());
    while (static_cast<int>(ends_.size()) < options_.fold_ends && !pool_.empty()) {
      const auto next = std::max_element(far.begin(), far.end()) - far.begin();
      if (!(far[static_cast<std::size_t>(next)] > 0.0)) break;
      ends_.push_back(pool_[static_cast<std::size_t>(next)]);
      for (std::size_t i = 0; i < pool_.size(); ++i)
        far[i] = std::min(far[i], (place(pool_[i]) - place(ends_.back())).norm());
    }
  }

  /// Any two ends that lie on nearly the same pass.
  [[nodiscard]] std::vector<Fold> pairs(const Centre& centre) const {
    const auto domain = even_domain(coarse_, centre);
    if (!domain) return {};
    const auto solver = EvenFieldSolver::build(*domain, rule_, options_.field, std::nullopt);
    if (!solver) return {};
    EvenField field = solver->start();
    solver->improve(field, std::vector<double>(domain->mesh.triangles.size(), 1.0), options_.outer, options_.inner);
    std::vector<Fold> out;
    for (Index from : ends_) {
      for (Index to : ends_) {
        if (from != to && std::abs(field.phi[at(from)] - field.phi[at(to)]) <= same_pass_turns)
          out.push_back({from, to});
      }
    }
    return out;
  }

  /// The centre with the best of the candidates; they are then sorted by what they promise, and the best kept.
  [[nodiscard]] ScoredCentre one_more(const Centre& centre, std::vector<Fold>& candidates) const {
    std::vector<Centre> more;
    for (const Fold& fold : candidates) {
      more.push_back(centre);
      more.back().folds.push_back(fold);
    }
    auto scored = score_(more);
    std::stable_sort(scored.begin(), scored.end(),
                     [](const ScoredCentre& a, const ScoredCentre& b) { return a.score < b.score; });
    candidates.clear();
    for (const ScoredCentre& s : scored) {
      if (static_cast<int>(candidates.size()) < options_.folds_kept) candidates.push_back(s.centre.folds.back());
    }
    return scored.empty() ? ScoredCentre{} : scored.front();
  }

  [[nodiscard]] ScoredCentre all_moved(ScoredCentre best) const {
    for (std::size_t k = best.centre.folds.size(); k-- > 0;) best = moved_ends(std::move(best), k);
    return best;
  }

  [[nodiscard]] ScoredCentre best_of(const std::vector<Centre>& centres) const {
    const auto scored = score_(centres);
    if (scored.empty()) return {};
    return *std::min_element(scored.begin(), scored.end(),
                             [](const ScoredCentre& a, const ScoredCentre& b) { return a.score < b.score; });
  }

  /// The ends of one fold moved in six directions each; the step shrinks where no move helps.
  [[nodiscard]] ScoredCentre moved_ends(ScoredCentre best, std::size_t fold) const {
    constexpr double gain_min = 2e-3;
    for (double step_mm = 0.5 * roomiest_mm_; step_mm >= 0.1 * roomiest_mm_; step_mm /= 1.8) {
      for (int moves = 0; moves < options_.moves_max; ++moves) {
        const auto next = best_of(moved(best.centre, fold, step_mm));
        if (!(next.score < (1.0 - gain_min) * best.score)) break;
        best = next;
      }
    }
    return best;
  }

  [[nodiscard]] std::vector<Centre> moved(const Centre& centre, std::size_t fold, double step_mm) const {
    std::vector<Centre> out;
    for (const bool first : {true, false}) {
      const Index node = first ? centre.folds[fold].from : centre.folds[fold].to;
      const Vec3 normal = coarse_.vertex_normals[at(node)];
      const Vec3 u = normal.unitOrthogonal(), w = normal.cross(u);
      for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3.0;
        const Index to =
            nearest(coarse_.mesh.vertices_mm[at(node)] + step_mm * (std::cos(angle) * u + std::sin(angle) * w));
        Centre next = centre;
        (first ? next.folds[fold].from : next.folds[fold].to) = to;
        if (to != node && next.folds[fold].from != next.folds[fold].to) out.push_back(std::move(next));
      }
    }
    return out;
  }

  [[nodiscard]] Index nearest(const Vec3& place) const {
    Index out = pool_.front();
    double least = std::numeric_limits<double>::infinity();
    for (Index v : pool_) {
      const double d = (coarse_.mesh.vertices_mm[at(v)] - place).squaredNorm();
      if (d >= least) continue;
      least = d;
      out = v;
    }
    return out;
  }

  const EvenSurface& coarse_;
  IntervalRule rule_;
  CentreSearchOptions options_;
  const ScoreCentres& score_;
  std::vector<Index> pool_, ends_;  ///< vertices at which folds may end; those that are tried first
  double roomiest_mm_ = 0.0;
};

}  // namespace

void add_folds(const EvenSurface& coarse, const IntervalRule& rule, const CentreSearchOptions& options,
               std::span<const double> room_mm, const ScoreCentres& score, std::vector<ScoredCentre>& found) {
  std::vector<ScoredCentre> starts;
  for (const bool loop : {false, true}) {
    const auto best =
        std::find_if(found.begin(), found.end(), [&](const ScoredCentre& s) { return s.centre.has_loop() == loop; });
    if (best != found.end()) starts.push_back(*best);
  }
  FoldSearch search(coarse, rule, options, room_mm, score);
  for (const ScoredCentre& start : starts) {
    const auto folded = search.run(start);
    found.insert(found.end(), folded.begin(), folded.end());
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const ScoredCentre& a, const ScoredCentre& b) { return a.score < b.score; });
}

}  // namespace volute::planner
