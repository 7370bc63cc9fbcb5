// The field of the even spiral: its gradient is everywhere at least one over the allowed interval, and hardly more.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/path/even_domain.hpp"
#include "planner/path/even_project.hpp"
#include "planner/path/path_interval.hpp"
#include "planner/surface/sparse_solver.hpp"

namespace volute::planner {

/// Whole values of phi - theta that hold the field to the path's levels.
struct HeldLevels {
  std::vector<double> floating;              ///< on each floating hole
  std::vector<std::array<double, 2>> folds;  ///< at either end of each fold
};

/// Weights of the field's optimisation. The defaults hold for every part; they are dimensionless.
struct EvenFieldOptions {
  double bend = 1.0;         ///< cost of |Laplacian|^2: higher gives rounder turns at the holes, and a longer path
  double excess = 0.05;      ///< mu: cost of (|q| L)^2 beside |q| L; a little keeps the optimum unique
  double step = 10.0;        ///< rho of ADMM: small, and directions turn freely; large, and few steps hold q . d >= g
  double relaxation = 1.7;   ///< of ADMM, 1 to 2: speed only
  double cone_rad = 1.2;     ///< the gradient stays this near the harmonic one: no critical points
  int direction_rounds = 2;  ///< averages of the direction over neighbours, per update
  bool creases = false;  ///< where directions around a triangle disagree, less is asked for: passes may have corners
};

/// The field and what the optimisation goes on from.
struct EvenField {
  std::vector<double> phi;        ///< per vertex: 0 on the outer loop, `turns` on the centre
  std::vector<Vec2> direction;    ///< per triangle, unit, in its frame: where phi is asked to grow
  std::vector<double> agreement;  ///< per triangle, of the directions around it: 1 where all point one way, 0 opposite
  std::vector<Vec2> dual;         ///< per triangle: ADMM's scaled multiplier
  double turns = 0.0;
  std::vector<double> float_levels;  ///< phi - theta on each floating hole
};

/// The optimisation on one domain: one factorisation, any number of improvements.
/// Minimises sum A (|q| + mu |q|^2 / 2 g) + bend |Laplacian (phi - theta)|^2 over q = grad (phi - theta), which the
/// path runs across, with q . d >= g = gain / L(d), by ADMM with the closed form in each triangle. With `creases` g is
/// multiplied by the length of the mean of the unit directions around: where passes turn a corner by 2 a, half of them
/// on either side, that is cos a, which is what either side's own gradient has along the bisector.
class EvenFieldSolver {
 public:
  /// `levels`: the values of phi - theta held; nothing: constant on each floating hole, but free.
  /// Errors: as SparseSolver::factor.
  /// `ready`: what factor() gave for this domain; requires levels.
  static Result<EvenFieldSolver> build(const EvenDomain& domain, const IntervalRule& rule,
                                       const EvenFieldOptions& options, const std::optional<HeldLevels>& levels,
                                       std::optional<SparseSolver> ready = std::nullopt);
  /// The factor for held levels, whatever they are, and whatever theta is turned by: it can be had before they are
  /// known. Errors: as SparseSolver::factor.
  static Result<SparseSolver> factor(const EvenDomain& domain, const IntervalRule& rule,
                                     const EvenFieldOptions& options);
  /// The factor, for another solver of this domain with other levels held.
  [[nodiscard]] SparseSolver factor() && { return std::move(*solver_); }

  /// Multiplies the cost of bending, vertex by vertex (1 each at first). Errors: as SparseSolver::factor.
  Result<void> stiffen(std::span<const double> bend_gain);

  /// Harmonic slit map (0 outside, 1 at the centre, no flux through the floating holes), its levels stretched so that
  /// the gradient reaches 1 / L on 99 % of each.
  [[nodiscard]] EvenField start() const;
  /// `outer` updates of the direction, `inner` steps of ADMM after each. `gain` per triangle multiplies g.
  /// The same bytes on any number of threads.
  void improve(EvenField& field, std::span<const double> gain, int outer, int inner) const;

  /// Gradient of phi - theta in each triangle: the path runs across it, one over its length is the interval.
  [[nodiscard]] std::vector<Vec2> slopes(const EvenField& field) const;

 private:
  EvenFieldSolver(const EvenDomain& domain, const IntervalRule& rule, const EvenFieldOptions& options);
  void number_unknowns(const std::optional<HeldLevels>& levels);
  void weigh();
  /// The matrix; constant_load_ too.
  [[nodiscard]] SparseMatrix assemble(std::span<const double> bend_gain);
  /// What a step reads of triangles that it takes together.
  struct Pack {
    std::array<std::array<Index, project_lanes>, 3> corner;  ///< vertices
    std::array<LaneVectors, 3> hat_per_mm;                   ///< as in the domain's operators
    LaneVectors theta_slope;
    Lanes weight, pull;  ///< as weight_; times the area
  };
  void pack();
  static LaneVectors slopes(const Pack& pack, const std::vector<double>& phi);
  void put_values(const Eigen::VectorXd& unknowns, std::vector<double>& phi) const;
  [[nodiscard]] Eigen::VectorXd load(std::span<const double> corner_load) const;
  void step_pack(std::size_t p, EvenField& field, std::span<const double> needed, bool dual_whole,
                 std::vector<double>& corner_load) const;
  void turn_directions(EvenField& field, std::span<const Vec2> gradient) const;
  void smooth_directions(EvenField& field) const;
  [[nodiscard]] std::vector<double> needed_gradient(std::span<const Vec2> direction,
                                                    std::span<const double> gain) const;

  const EvenDomain* domain_;
  IntervalRule rule_;
  EvenFieldOptions options_;
  VertexCorners corners_;
  std::vector<int> unknown_;  ///< per vertex, -1: held
  std::vector<double> held_;  ///< per vertex: added to the unknown (theta on floating holes)
  int unknown_count_ = 0, centre_unknown_ = 0;
  std::vector<std::size_t> free_, tied_;  ///< vertices with an unknown of their own; those that share one
  std::vector<Pack> packs_;
  std::vector<double> weight_;  ///< per triangle: rho times the interval at the mean curvature
  std::vector<Vec2> harmonic_direction_, theta_slope_;
  Eigen::VectorXd constant_load_;
  std::optional<SparseSolver> solver_;
};

}  // namespace volute::planner
