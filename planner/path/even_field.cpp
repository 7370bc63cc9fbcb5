#include "planner/path/even_field.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "planner/path/even_collar.hpp"
#include "planner/surface/tied_matrix.hpp"

namespace volute::planner {

using geometry::at;
namespace {

constexpr std::size_t grain = 2048;

template <class Body>
void for_each_index(std::size_t count, Body body, std::size_t least = grain) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, least),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
                    });
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Vec2 across(const Vec2& v) { return {-v.y(), v.x()}; }

Vec2 unit_or(const Vec2& v, const Vec2& otherwise) {
  const double norm = v.norm();
  return norm > 1e-12 ? Vec2(v / norm) : otherwise;
}

/// v stretched level by level: its slope at a level is what `share` of the level's length needs.
std::vector<double> stretched(const EvenDomain& domain, const std::vector<double>& v,
                              const std::vector<double>& slope_needed, const std::vector<double>& weight,
                              double share) {
  constexpr std::size_t bins = 200;
  std::vector<std::vector<std::size_t>> members(bins);
  const auto bin_of = [](double value) {
    return std::clamp(static_cast<std::ptrdiff_t>(value * bins), std::ptrdiff_t{0}, std::ptrdiff_t{bins - 1});
  };
  for (std::size_t t = 0; t < domain.mesh.triangles.size(); ++t) {
    const auto& c = domain.mesh.triangles[t];
    const auto [low, high] = std::minmax({v[at(c[0])], v[at(c[1])], v[at(c[2])]});
    for (auto b = bin_of(low); b <= bin_of(high); ++b) members[static_cast<std::size_t>(b)].push_back(t);
  }
  std::array<double, bins + 1> sum{};
  double last = 0.0;
  for (std::size_t b = 0; b < bins; ++b) {
    auto& m = members[b];
    std::sort(m.begin(), m.end(), [&](std::size_t i, std::size_t j) { return slope_needed[i] < slope_needed[j]; });
    double total = 0.0, reached = 0.0;
    for (std::size_t t : m) total += weight[t];
    for (std::size_t t : m) {
      last = slope_needed[t];
      reached += weight[t];
      if (reached >= share * total) break;
    }
    sum[b + 1] = sum[b] + last / bins;
  }
  std::vector<double> out(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double x = std::clamp(v[i], 0.0, 1.0) * bins;
    const auto b = std::min(static_cast<std::size_t>(x), bins - 1);
    out[i] = sum[b] + (x - static_cast<double>(b)) * (sum[b + 1] - sum[b]);
  }
  return out;
}

}  // namespace

EvenFieldSolver::EvenFieldSolver(const EvenDomain& domain, const IntervalRule& rule, const EvenFieldOptions& options)
    : domain_(&domain), rule_(rule), options_(options), corners_(domain.mesh) {}

void EvenFieldSolver::number_unknowns(const std::optional<HeldLevels>& levels) {
  const EvenDomain& domain = *domain_;
  constexpr int inner = -2;
  unknown_.assign(domain.mesh.vertices_mm.size(), inner);
  held_.assign(domain.mesh.vertices_mm.size(), 0.0);
  for (Index v : domain.outer.vertices) unknown_[at(v)] = -1;
  for (Index v : domain.centre.vertices) unknown_[at(v)] = -1;
  for (const auto& loop : domain.floating) {
    for (Index v : loop.vertices) unknown_[at(v)] = -1;
  }
  unknown_count_ = 0;
  centre_unknown_ = unknown_count_++;
  for (Index v : domain.centre.vertices) unknown_[at(v)] = centre_unknown_;
  for (const CollarVertex& c : slit_collar(domain, rule_)) {
    unknown_[at(c.vertex)] = centre_unknown_;
    held_[at(c.vertex)] = -c.turns_before;
  }
  for (std::size_t f = 0; levels && f < domain.folds.size(); ++f) {
    for (const std::size_t end : {0, 1}) {
      const auto& fold = domain.folds[f];
      const Index core = end == 0 ? fold.front() : fold.back(), beside = end == 0 ? fold[1] : fold[fold.size() - 2];
      unknown_[at(core)] = unknown_[at(beside)] = -1;
      held_[at(core)] = domain.theta.vertex[at(core)] + levels->folds[f][end];
      held_[at(beside)] = domain.theta.vertex[at(beside)] + levels->folds[f][end] + 1.0;
    }
  }
  for (std::size_t v = 0; v < unknown_.size(); ++v) {
    if (unknown_[v] == inner) {
      unknown_[v] = unknown_count_++;
      free_.push_back(v);
    }
  }
  for (std::size_t i = 0; i < domain.floating.size(); ++i) {
    const int tied = levels ? -1 : unknown_count_++;
    for (Index v : domain.floating[i].vertices) {
      unknown_[at(v)] = tied;
      held_[at(v)] = domain.theta.vertex[at(v)] + (levels ? levels->floating[i] : 0.0);
    }
  }
  std::vector<char> is_free(unknown_.size(), 0);
  for (const std::size_t v : free_) is_free[v] = 1;
  for (std::size_t v = 0; v < unknown_.size(); ++v) {
    if (unknown_[v] >= 0 && is_free[v] == 0) tied_.push_back(v);
  }
}

void EvenFieldSolver::weigh() {
  const EvenDomain& domain = *domain_;
  const std::size_t triangles = domain.mesh.triangles.size();
  for (std::size_t t = 0; t < triangles; ++t) {
    const double usual_mm = rule_.interval_mm(0.5 * domain.curvature[t].trace());
    weight_.push_back(options_.step * usual_mm);
    const auto corner = [&](int k) { return domain.theta.at_corner(domain.mesh, static_cast<Index>(t), k); };
    theta_slope_.push_back(domain.operators[t].gradient(corner(0), corner(1), corner(2)));
  }
  harmonic_direction_ = gradient(domain.mesh, domain.operators, domain.harmonic);
  for (Vec2& d : harmonic_direction_) d = unit_or(d, Vec2(1.0, 0.0));
  pack();
}

void EvenFieldSolver::pack() {
  const EvenDomain& domain = *domain_;
  constexpr std::size_t lanes = project_lanes;
  packs_.resize((weight_.size() + lanes - 1) / lanes);
  for (std::size_t i = 0; i < lanes * packs_.size(); ++i) {
    const std::size_t t = std::min(i, weight_.size() - 1);  // the last triangle fills the last pack
    const auto lane = static_cast<Eigen::Index>(i % lanes);
    Pack& pack = packs_[i / lanes];
    for (std::size_t k = 0; k < 3; ++k) {
      pack.corner[k][i % lanes] = domain.mesh.triangles[t][k];
      pack.hat_per_mm[k].x[lane] = domain.operators[t].hat_per_mm[k].x();
      pack.hat_per_mm[k].y[lane] = domain.operators[t].hat_per_mm[k].y();
    }
    pack.theta_slope.x[lane] = theta_slope_[t].x();
    pack.theta_slope.y[lane] = theta_slope_[t].y();
    pack.weight[lane] = weight_[t];
    pack.pull[lane] = weight_[t] * domain.operators[t].area_mm2;
  }
}

SparseMatrix EvenFieldSolver::assemble(std::span<const double> bend_gain) {
  const EvenDomain& domain = *domain_;
  const double usual_mm = median(weight_) / options_.step;
  const double bend = options_.bend * usual_mm * usual_mm * usual_mm;
  const auto areas = vertex_areas_mm2(domain.mesh);
  Eigen::VectorXd inner = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(areas.size()));
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (!domain.topology.is_boundary_vertex(static_cast<Index>(v)))
      inner[static_cast<Eigen::Index>(v)] = bend * bend_gain[v] / areas[v];
  }
  const Ties ties(unknown_, unknown_count_);
  const SparseMatrix laplacian = cotan_laplacian(domain.mesh, domain.operators),
                     weighted = cotan_laplacian(domain.mesh, domain.operators, weight_);
  const SparseMatrix reduced = tied_columns(laplacian, ties);
  const SparseMatrix matrix = plus_square(tied(weighted, ties), reduced, inner);
  // What the held values and theta put on the right side: the unknowns make phi - theta - held.
  const auto as_vector = [](const std::vector<double>& v) {
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())));
  };
  std::vector<Vec2> weighted_slope(theta_slope_);
  for (std::size_t t = 0; t < weighted_slope.size(); ++t) weighted_slope[t] *= weight_[t];
  const Eigen::VectorXd held = as_vector(held_);
  const Eigen::VectorXd bent = as_vector(divergence(domain.mesh, domain.operators, theta_slope_)) - laplacian * held;
  const Eigen::VectorXd grown = as_vector(divergence(domain.mesh, domain.operators, weighted_slope)) - weighted * held;
  constant_load_ = reduced.transpose() * Eigen::VectorXd(inner.asDiagonal() * bent) + tied(grown, ties);
  return matrix;
}

Result<void> EvenFieldSolver::stiffen(std::span<const double> bend_gain) {
  VOLUTE_CHECK(bend_gain.size() == unknown_.size(), bend_gain.size(), unknown_.size());
  return solver_->refactor(assemble(bend_gain));
}

Result<SparseSolver> EvenFieldSolver::factor(const EvenDomain& domain, const IntervalRule& rule,
                                             const EvenFieldOptions& options) {
  auto solver = build(domain, rule, options,
                      HeldLevels{std::vector<double>(domain.floating.size(), 0.0),
                                 std::vector<std::array<double, 2>>(domain.folds.size())});
  if (!solver) return tl::unexpected(solver.error());
  return std::move(*solver->solver_);
}

Result<EvenFieldSolver> EvenFieldSolver::build(const EvenDomain& domain, const IntervalRule& rule,
                                               const EvenFieldOptions& options, const std::optional<HeldLevels>& levels,
                                               std::optional<SparseSolver> ready) {
  VOLUTE_CHECK(!levels || levels->floating.size() == domain.floating.size(), domain.floating.size());
  VOLUTE_CHECK(!levels || levels->folds.size() == domain.folds.size(), domain.folds.size());
  EvenFieldSolver out(domain, rule, options);
  out.number_unknowns(levels);
  out.weigh();
  const SparseMatrix matrix = out.assemble(std::vector<double>(domain.mesh.vertices_mm.size(), 1.0));
  out.solver_ = std::move(ready);
  if (out.solver_) return out;
  auto solver = SparseSolver::factor(matrix);
  if (!solver) return tl::unexpected(solver.error());
  out.solver_ = std::move(*solver);
  return out;
}

EvenField EvenFieldSolver::start() const {
  const EvenDomain& domain = *domain_;
  const auto slopes = gradient(domain.mesh, domain.operators, domain.harmonic);
  const std::vector<double> ones(slopes.size(), 1.0);
  std::vector<double> slope_needed = needed_gradient(harmonic_direction_, ones), weight(slopes.size());
  for (std::size_t t = 0; t < slopes.size(); ++t) {
    const double slope = std::max(slopes[t].norm(), 1e-12);
    slope_needed[t] /= slope;
    weight[t] = domain.operators[t].area_mm2 * slope;
  }
  EvenField field;
  field.phi = stretched(domain, domain.harmonic, slope_needed, weight, 0.99);
  field.turns = field.phi[at(domain.centre.vertices.front())];
  field.dual.assign(slopes.size(), Vec2::Zero());
  field.direction = gradient(domain.mesh, domain.operators, field.phi);
  for (std::size_t t = 0; t < slopes.size(); ++t)
    field.direction[t] = unit_or(field.direction[t], harmonic_direction_[t]);
  return field;
}

void EvenFieldSolver::put_values(const Eigen::VectorXd& unknowns, std::vector<double>& phi) const {
  for (std::size_t v = 0; v < phi.size(); ++v) phi[v] = unknown_[v] >= 0 ? held_[v] + unknowns[unknown_[v]] : held_[v];
}

Eigen::VectorXd EvenFieldSolver::load(std::span<const double> corner_load) const {
  const auto at_vertex = [&](std::size_t v) {
    double sum = 0.0;
    for (Index corner : corners_.of(static_cast<Index>(v))) sum += corner_load[at(corner)];
    return sum;
  };
  Eigen::VectorXd out = constant_load_;
  for_each_index(free_.size(), [&](std::size_t i) { out[unknown_[free_[i]]] += at_vertex(free_[i]); });
  for (const std::size_t v : tied_) out[unknown_[v]] += at_vertex(v);
  return out;
}

std::vector<double> EvenFieldSolver::needed_gradient(std::span<const Vec2> direction,
                                                     std::span<const double> gain) const {
  std::vector<double> out(direction.size());
  for_each_index(out.size(), [&](std::size_t t) {
    const Vec3 d = domain_->operators[t].to_space(direction[t]);
    out[t] = gain[t] / domain_->interval_mm(rule_, static_cast<Index>(t), d);
  });
  return out;
}

void EvenFieldSolver::smooth_directions(EvenField& field) const {
  constexpr double one_way = 0.97;  // of a bend that the mesh resolves
  const EvenDomain& domain = *domain_;
  std::vector<Vec3> at_vertex(domain.mesh.vertices_mm.size());
  std::vector<Vec2> mean = field.direction;
  for (int round = 0; round < options_.direction_rounds; ++round) {
    for_each_index(at_vertex.size(), [&](std::size_t v) {
      Vec3 sum = Vec3::Zero();
      double area = 0.0;
      for (Index corner : corners_.of(static_cast<Index>(v))) {
        const TriangleOperator& o = domain.operators[at(corner / 3)];
        sum += o.area_mm2 * o.to_space(mean[at(corner / 3)]);
        area += o.area_mm2;
      }
      at_vertex[v] = area > 0.0 ? Vec3(sum / area) : Vec3(Vec3::Zero());
    });
    for_each_index(mean.size(), [&](std::size_t t) {
      const auto& c = domain.mesh.triangles[t];
      const Vec2 sum = domain.operators[t].to_plane(at_vertex[at(c[0])] + at_vertex[at(c[1])] + at_vertex[at(c[2])]);
      mean[t] = options_.creases ? Vec2(sum / 3.0) : unit_or(sum, mean[t]);
    });
  }
  field.agreement.assign(mean.size(), 1.0);
  if (options_.creases) {
    for_each_index(mean.size(), [&](std::size_t t) {
      field.agreement[t] = std::min(1.0, mean[t].norm() / one_way);
      mean[t] = unit_or(mean[t], field.direction[t]);
    });
  }
  field.direction = std::move(mean);
}
void EvenFieldSolver::turn_directions(EvenField& field, std::span<const Vec2> gradient) const {
  constexpr double turn_cosine_min =
      0.2;  // a gradient that left its direction this far says that the triangle is not settled
  for_each_index(gradient.size(), [&](std::size_t t) {
    const Vec2 now = unit_or(gradient[t], field.direction[t]);
    if (now.dot(field.direction[t]) > turn_cosine_min) field.direction[t] = now;
  });
  smooth_directions(field);
  const double cone_cosine = std::cos(options_.cone_rad), cone_sine = std::sin(options_.cone_rad);
  for_each_index(gradient.size(), [&](std::size_t t) {
    const Vec2& axis = harmonic_direction_[t];
    Vec2& d = field.direction[t];
    if (d.dot(axis) >= cone_cosine) return;
    const Vec2 side = across(axis);
    d = cone_cosine * axis + (d.dot(side) < 0.0 ? -cone_sine : cone_sine) * side;
  });
}

std::vector<Vec2> EvenFieldSolver::slopes(const EvenField& field) const {
  std::vector<Vec2> out = gradient(domain_->mesh, domain_->operators, field.phi);
  for (std::size_t t = 0; t < out.size(); ++t) out[t] -= theta_slope_[t];
  return out;
}

LaneVectors EvenFieldSolver::slopes(const Pack& pack, const std::vector<double>& phi) {
  std::array<Lanes, 3> value;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t lane = 0; lane < project_lanes; ++lane)
      value[k][static_cast<Eigen::Index>(lane)] = phi[at(pack.corner[k][lane])];
  }
  const auto& hat = pack.hat_per_mm;
  return {value[0] * hat[0].x + value[1] * hat[1].x + value[2] * hat[2].x - pack.theta_slope.x,
          value[0] * hat[0].y + value[1] * hat[1].y + value[2] * hat[2].y - pack.theta_slope.y};
}

/// The triangles of pack p. In the first step after an update of the directions the dual is whole, later the slope of
/// the solve before is to be added.
[[gnu::flatten]] void EvenFieldSolver::step_pack(std::size_t p, EvenField& field, std::span<const double> needed,
                                                 bool dual_whole, std::vector<double>& corner_load) const {
  const Pack& pack = packs_[p];
  const std::size_t first = p * project_lanes;
  const auto count = static_cast<Eigen::Index>(std::min<std::size_t>(project_lanes, needed.size() - first));
  LaneVectors dual;
  Allowed allowed{{}, {}, options_.excess, pack.weight};
  for (Eigen::Index lane = 0; lane < project_lanes; ++lane) {
    const std::size_t t = first + static_cast<std::size_t>(std::min(lane, count - 1));
    dual.x[lane] = field.dual[t].x();
    dual.y[lane] = field.dual[t].y();
    allowed.d.x[lane] = field.direction[t].x();
    allowed.d.y[lane] = field.direction[t].y();
    allowed.needed[lane] = needed[t];
  }
  const LaneVectors now = slopes(pack, field.phi);
  if (!dual_whole) dual = {dual.x + now.x, dual.y + now.y};
  const LaneVectors nearest = nearest_allowed({now.x + dual.x, now.y + dual.y}, allowed);
  const double taken = options_.relaxation, left = 1.0 - options_.relaxation;
  const LaneVectors q{taken * nearest.x + left * now.x, taken * nearest.y + left * now.y};
  const LaneVectors flux{(q.x - dual.x) * pack.pull, (q.y - dual.y) * pack.pull};
  dual = {dual.x - q.x, dual.y - q.y};
  for (std::size_t k = 0; k < 3; ++k) {
    const Lanes load = flux.x * pack.hat_per_mm[k].x + flux.y * pack.hat_per_mm[k].y;
    for (Eigen::Index lane = 0; lane < count; ++lane)
      corner_load[3 * (first + static_cast<std::size_t>(lane)) + k] = load[lane];
  }
  for (Eigen::Index lane = 0; lane < count; ++lane)
    field.dual[first + static_cast<std::size_t>(lane)] = Vec2(dual.x[lane], dual.y[lane]);
}

void EvenFieldSolver::improve(EvenField& field, std::span<const double> gain, int outer, int inner) const {
  const EvenDomain& domain = *domain_;
  const std::size_t triangles = domain.mesh.triangles.size();
  VOLUTE_CHECK(field.phi.size() == domain.mesh.vertices_mm.size() && gain.size() == triangles, field.phi.size(),
               gain.size());
  VOLUTE_CHECK(outer > 0 && inner > 0, outer, inner);
  std::vector<double> corner_load(3 * triangles);
  Eigen::VectorXd unknowns;
  for (int o = 0; o < outer; ++o) {
    std::vector<double> needed = needed_gradient(field.direction, gain);
    for (std::size_t t = 0; t < field.agreement.size(); ++t) needed[t] *= field.agreement[t];
    for (int i = 0; i < inner; ++i) {
      for_each_index(
          packs_.size(), [&](std::size_t p) { step_pack(p, field, needed, i == 0, corner_load); },
          grain / project_lanes);
      unknowns = solver_->solve(load(corner_load));
      put_values(unknowns, field.phi);
    }
    const std::vector<Vec2> now = slopes(field);
    for (std::size_t t = 0; t < triangles; ++t) field.dual[t] += now[t];
    turn_directions(field, now);
  }
  field.turns = unknowns[centre_unknown_];
  field.float_levels.clear();
  for (const auto& loop : domain.floating) {
    const std::size_t v = at(loop.vertices.front());
    field.float_levels.push_back(field.phi[v] - domain.theta.vertex[v]);
  }
}

}  // namespace volute::planner
