#include "planner/path/even_fold_pull.hpp"

#include "geometry/index.hpp"
#include "planner/path/even_collar.hpp"
#include "planner/surface/tied_matrix.hpp"

namespace volute::planner {

using geometry::at;
namespace {

constexpr double passes_of_a_fold = 2.0;

/// The unknown of each vertex, as in the field's optimisation: the centre and its collar share one, each floating hole
/// has one, the outer boundary none.
Ties unknowns_of_phi(const EvenDomain& domain, const IntervalRule& rule) {
  constexpr int inner = -2;
  std::vector<int> unknown(domain.mesh.vertices_mm.size(), inner);
  int count = 0;
  for (Index v : domain.outer.vertices) unknown[at(v)] = -1;
  for (Index v : domain.centre.vertices) unknown[at(v)] = count;
  for (const CollarVertex& c : slit_collar(domain, rule)) unknown[at(c.vertex)] = count;
  ++count;
  for (const auto& loop : domain.floating) {
    for (Index v : loop.vertices) unknown[at(v)] = count;
    ++count;
  }
  for (int& u : unknown) u = u == inner ? count++ : u;
  return {unknown, count};
}

Eigen::VectorXd divergence_of(const EvenDomain& domain, const std::vector<Vec2>& flux) {
  const auto sum = divergence(domain.mesh, domain.operators, flux);
  return Eigen::Map<const Eigen::VectorXd>(sum.data(), static_cast<Eigen::Index>(sum.size()));
}

/// Takes off the gradient that carries the divergence at what phi is free in.
Result<void> take_off_divergence(const EvenDomain& domain, const SparseMatrix& laplacian, const Ties& ties,
                                 std::vector<Vec2>& flux) {
  const auto solver = SparseSolver::factor(tied(laplacian, ties));
  if (!solver) return tl::unexpected(solver.error());
  const Eigen::VectorXd source = solver->solve(tied(divergence_of(domain, flux), ties));
  std::vector<double> at_vertex(domain.mesh.vertices_mm.size(), 0.0);
  for (std::size_t v = 0; v < at_vertex.size(); ++v) {
    const int unknown = ties.unknown(static_cast<Eigen::Index>(v));
    if (unknown >= 0) at_vertex[v] = source[unknown];
  }
  const auto slope = gradient(domain.mesh, domain.operators, at_vertex);
  for (std::size_t t = 0; t < flux.size(); ++t) flux[t] -= slope[t];
  return {};
}

}  // namespace

Result<std::vector<double>> fold_pull_mm(const EvenDomain& domain, const IntervalRule& rule,
                                         const EvenFieldOptions& options, const EvenField& field) {
  std::vector<Vec2> flux(field.dual);
  for (std::size_t t = 0; t < flux.size(); ++t)
    flux[t] *= options.step * rule.interval_mm(0.5 * domain.curvature[t].trace());
  const SparseMatrix laplacian = cotan_laplacian(domain.mesh, domain.operators);
  if (auto done = take_off_divergence(domain, laplacian, unknowns_of_phi(domain, rule), flux); !done)
    return tl::unexpected(done.error());
  for (Vec2& f : flux) f = passes_of_a_fold * Vec2(-f.y(), f.x());
  const int anywhere = domain.outer.vertices.front();  // only differences count
  const auto pull =
      solve_with_fixed(laplacian, std::span(&anywhere, 1), Eigen::MatrixXd::Zero(1, 1), divergence_of(domain, flux));
  if (!pull) return tl::unexpected(pull.error());
  return std::vector<double>(pull->data(), pull->data() + pull->size());
}

}  // namespace volute::planner
