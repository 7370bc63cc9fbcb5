#include "planner/path/even_mend.hpp"

#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "planner/path/even_crest.hpp"
#include "planner/path/even_prolong.hpp"
#include "planner/path/path_interval.hpp"
#include "planner/path/point_grid.hpp"
#include "planner/surface/sparse_solver.hpp"

namespace volute::planner {

using geometry::at;
namespace {

/// The uniform cubic B-spline over [0, 1) of a span: weights of the knots k - 1 to k + 2.
std::array<double, 4> spline_weights(double u) {
  const double v = 1.0 - u;
  return {v * v * v / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0, (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0,
          u * u * u / 6.0};
}

/// Shifts along the path, in intervals: nothing but at the knots that are free.
class PathShift {
 public:
  PathShift(double last_mm, double knots_mm) : knots_mm_(knots_mm) {
    number_.assign(static_cast<std::size_t>(last_mm / knots_mm) + 4, -1);
  }
  [[nodiscard]] std::size_t knots() const { return number_.size(); }
  [[nodiscard]] long knot_at(double s_mm) const { return static_cast<long>(s_mm / knots_mm_); }
  void release(long knot) { number_[static_cast<std::size_t>(knot)] = 0; }
  void hold(long knot) { number_[static_cast<std::size_t>(knot)] = -1; }
  /// Numbers the free knots; returns how many there are.
  int count() {
    int next = 0;
    for (int& n : number_) n = n < 0 ? -1 : next++;
    shift_.assign(static_cast<std::size_t>(next), Vec3::Zero());
    return next;
  }
  /// Calls visit(number, weight) for the free knots whose splines reach s.
  template <class Visit>
  void at_length(double s_mm, Visit visit) const {
    const long knot = knot_at(s_mm);
    const auto weights = spline_weights(s_mm / knots_mm_ - static_cast<double>(knot));
    for (long k = 0; k < 4; ++k) {
      const int n = number(knot + k - 1);
      if (n >= 0) visit(n, weights[static_cast<std::size_t>(k)]);
    }
  }
  [[nodiscard]] int number(long knot) const {
    return knot < 0 || knot >= static_cast<long>(number_.size()) ? -1 : number_[static_cast<std::size_t>(knot)];
  }
  [[nodiscard]] Vec3& shift(int n) { return shift_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] Vec3 value(double s_mm) const {
    Vec3 sum = Vec3::Zero();
    at_length(s_mm, [&](int n, double w) { sum += w * shift_[static_cast<std::size_t>(n)]; });
    return sum;
  }

 private:
  double knots_mm_;
  std::vector<int> number_;  ///< of each knot; -1: held
  std::vector<Vec3> shift_;
};

/// Knots near the places, but for those that would move the path's ends or the run along the outer boundary.
int release_knots(const BallSteps& steps, std::span<const Vec3> places, double interval_mm, const MendOptions& options,
                  PathShift& shift) {
  const double reach_mm = options.reach_intervals * interval_mm;
  const PointGrid grid(steps.contact_mm, interval_mm);
  for (const Vec3& place : places) {
    grid.near(place, reach_mm, [&](Index i) {
      if ((steps.contact_mm[at(i)] - place).norm() <= reach_mm) shift.release(shift.knot_at(steps.s_mm[at(i)]));
    });
  }
  const auto hold_around = [&](double s_mm) {
    const long knot = shift.knot_at(s_mm);
    for (long k = std::max(0L, knot - 1); k <= std::min(knot + 2, static_cast<long>(shift.knots()) - 1); ++k)
      shift.hold(k);
  };
  for (std::size_t i = 0; i < steps.turn.size(); ++i) {
    if (steps.turn[i] <= options.turn_kept) hold_around(steps.s_mm[i]);
  }
  hold_around(0.0);
  hold_around(steps.s_mm.back());
  return shift.count();
}

/// The rows of the crests that the free knots reach, those over `mended_from` and those that might rise over it.
std::vector<CrestRow> rows_of(const Crests& crests, const ScallopMap& map, std::span<const Vec3> places,
                              double interval_mm, const MendOptions& options, const PathShift& shift) {
  constexpr double might_rise = 0.75;  // of the allowed height
  const double reach_mm = (options.reach_intervals + 2.0) * interval_mm;
  const PointGrid grid(places, interval_mm);
  std::vector<CrestRow> out;
  for (std::size_t t = 0; t < map.worst_ratio.size(); ++t) {
    if (map.worst_ratio[t] < might_rise) continue;
    const Vec3& place = map.worst_place_P_mm[t];
    bool near = false;
    grid.near(place, reach_mm, [&](Index i) { near = near || (places[at(i)] - place).norm() <= reach_mm; });
    if (!near) continue;
    CrestRow row = crests.row(t, place, map.worst_ratio[t]);
    bool moves = false;
    for (const auto& [s_mm, by_shift] : row.by_shift) shift.at_length(s_mm, [&](int, double) { moves = true; });
    if (moves) out.push_back(std::move(row));
  }
  return out;
}

using Triplets = std::vector<Eigen::Triplet<double>>;

/// sum |s|^2 and the bending of the shift.
Triplets stay_cost(const PathShift& shift, int free) {
  constexpr double bending = 4.0;
  Triplets out;
  for (int n = 0; n < 3 * free; ++n) out.emplace_back(n, n, 1.0);
  const std::array<double, 3> second{1.0, -2.0, 1.0};
  for (long k = -1; k <= static_cast<long>(shift.knots()); ++k) {
    for (long i = 0; i < 3; ++i) {
      for (long j = 0; j < 3; ++j) {
        const int a = shift.number(k + i - 1), b = shift.number(k + j - 1);
        if (a < 0 || b < 0) continue;
        const double cost = bending * second[static_cast<std::size_t>(i)] * second[static_cast<std::size_t>(j)];
        for (int d = 0; d < 3; ++d) out.emplace_back(3 * a + d, 3 * b + d, cost);
      }
    }
  }
  return out;
}

/// The rows as numbers: unknowns and their coefficients, each unknown once.
std::vector<std::map<int, double>> sparse_rows(std::span<const CrestRow> rows, const PathShift& shift) {
  std::vector<std::map<int, double>> out;
  for (const CrestRow& row : rows) {
    auto& numbers = out.emplace_back();
    for (const auto& [s_mm, by_shift] : row.by_shift) {
      shift.at_length(s_mm, [&, by = by_shift](int n, double w) {
        for (int d = 0; d < 3; ++d) numbers[3 * n + d] += w * by[d];
      });
    }
  }
  return out;
}

/// Newton's steps on a cost that is quadratic as long as the same rows are too high.
Result<void> solve_shift(std::span<const CrestRow> rows, double aim_ratio, int free, PathShift& shift) {
  constexpr double excess_cost = 1e4;
  constexpr int steps_max = 12;
  const Triplets stay = stay_cost(shift, free);
  const auto numbers = sparse_rows(rows, shift);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(3 * free);
  std::vector<char> high(rows.size(), 0), before;
  for (int step = 0; step < steps_max; ++step) {
    before = high;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      double height = rows[r].ratio;
      for (const auto& [n, by] : numbers[r]) height += by * x[n];
      high[r] = height > aim_ratio ? 1 : 0;
    }
    if (step > 0 && high == before) break;
    Triplets cost = stay;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * free);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (high[r] == 0) continue;
      for (const auto& [n, by] : numbers[r]) {
        right[n] += excess_cost * (aim_ratio - rows[r].ratio) * by;
        for (const auto& [m, other] : numbers[r]) cost.emplace_back(n, m, excess_cost * by * other);
      }
    }
    SparseMatrix matrix(3 * free, 3 * free);
    matrix.setFromTriplets(cost.begin(), cost.end());
    const auto solver = SparseSolver::factor(matrix);
    if (!solver) return tl::unexpected(solver.error());
    x = solver->solve(right);
  }
  for (int n = 0; n < free; ++n) shift.shift(n) = x.segment<3>(3 * n);
  return {};
}

/// A piece with points close enough for the shift, which of them move, and where they stood.
struct Shifted {
  CcPiece piece;
  std::vector<std::size_t> moved;
  std::vector<Vec3> from_mm, to_mm;
};

Shifted shifted(const CcPiece& piece, const PathShift& shift, double interval_mm, double longest_intervals) {
  constexpr double least = 1e-3;          // intervals: less is no shift
  constexpr double step_intervals = 0.3;  // between points that move; short steps cost feed
  Shifted out;
  const auto append = [&](const CcPoint& point, double s_mm, bool given) {
    Vec3 by = shift.value(s_mm);
    if (by.norm() < least) {
      if (given) out.piece.points.push_back(point);
      return;
    }
    if (by.norm() > longest_intervals) by *= longest_intervals / by.norm();
    out.moved.push_back(out.piece.points.size());
    out.from_mm.push_back(point.point_P_mm);
    out.to_mm.push_back(point.point_P_mm + interval_mm * by);
    out.piece.points.push_back(point);
  };
  double s = 0.0;
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const CcPoint& a = piece.points[i];
    append(a, s, true);
    if (i + 1 == piece.points.size()) break;
    const CcPoint& b = piece.points[i + 1];
    const double span = (b.point_P_mm - a.point_P_mm).norm();
    const int parts = static_cast<int>(std::ceil(span / (step_intervals * interval_mm)));
    for (int k = 1; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      CcPoint between = a;
      between.point_P_mm += share * (b.point_P_mm - a.point_P_mm);
      between.normal_P = ((1.0 - share) * a.normal_P + share * b.normal_P).normalized();
      between.turn += share * (b.turn - a.turn);
      append(between, s + share * span, false);
    }
    s += span;
  }
  return out;
}

}  // namespace

Result<void> mend_finished(CcPiece& piece, const ScallopMap& map, const MendSurface& surface, double radius_mm,
                           double scallop_mm, const MendOptions& options) {
  VOLUTE_CHECK(radius_mm > scallop_mm && scallop_mm > 0.0, radius_mm, scallop_mm);
  VOLUTE_CHECK(map.worst_ratio.size() == surface.mesh.triangles.size(), map.worst_ratio.size());
  const double interval_mm = path_interval_mm(radius_mm, scallop_mm, 0.0);
  std::vector<Vec3> places;
  for (std::size_t t = 0; t < map.worst_ratio.size(); ++t) {
    if (map.worst_ratio[t] > options.mended_from) places.push_back(map.worst_place_P_mm[t]);
  }
  if (piece.points.size() < 3 || places.empty()) return {};
  const BallSteps steps = ball_steps(piece, radius_mm, interval_mm / 20.0);
  PathShift shift(steps.s_mm.back(), options.knots_intervals * interval_mm);
  const int free = release_knots(steps, places, interval_mm, options, shift);
  if (free == 0) return {};
  const Crests crests(steps, surface, radius_mm, scallop_mm);
  const auto rows = rows_of(crests, map, places, interval_mm, options, shift);
  if (auto solved = solve_shift(rows, options.aim_ratio, free, shift); !solved) return solved;
  Shifted out = shifted(piece, shift, interval_mm, options.longest_intervals);
  const auto before = on_mesh(surface.mesh, surface.vertex_normals, surface.operators, out.from_mm),
             after = on_mesh(surface.mesh, surface.vertex_normals, surface.operators, out.to_mm);
  for (std::size_t k = 0; k < out.moved.size(); ++k) {
    CcPoint& p = out.piece.points[out.moved[k]];
    p.point_P_mm += after[k].point_P_mm - before[k].point_P_mm;
    p.normal_P = (p.normal_P + after[k].normal_P - before[k].normal_P).normalized();
  }
  piece = std::move(out.piece);
  return {};
}

}  // namespace volute::planner
