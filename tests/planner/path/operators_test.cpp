#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geometry/mesh_measure.hpp"
#include "planner/surface/operators.hpp"
#include "planner/surface/periodic_coordinate.hpp"
#include "planner/surface/sparse_solver.hpp"
#include "planner/surface/tied_matrix.hpp"
#include "tests/cases.hpp"

namespace volute::planner {
namespace {

using geometry::MeshTopology;
using geometry::TriangleMesh;

/// A flat ring between two radii, vertices shaken inside by `shake` of their spacing.
TriangleMesh ring(int around, int across, double inner_mm, double outer_mm, double shake, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-shake, shake);
  TriangleMesh mesh;
  for (int j = 0; j <= across; ++j) {
    const double share = static_cast<double>(j) / across;
    const double radius = inner_mm * std::pow(outer_mm / inner_mm, share);
    for (int i = 0; i < around; ++i) {
      const double inside = j == 0 || j == across ? 0.0 : radius * 2.0 * std::numbers::pi / around;
      const double angle = 2.0 * std::numbers::pi * i / around;
      mesh.vertices_mm.emplace_back(radius * std::cos(angle) + inside * move(random),
                                    radius * std::sin(angle) + inside * move(random), 0.0);
    }
  }
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around, c = a + around, d = b + around;
      mesh.triangles.push_back({a, d, b});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

PeriodicCoordinate angle_coordinate(const TriangleMesh& mesh, Index seam_vertex_from) {
  const auto topology = MeshTopology::build(mesh);
  EXPECT_TRUE(topology.has_value());
  const auto& loops = topology->boundary_loops();
  geometry::BoundaryLoop from = loops[0];
  if (seam_vertex_from != geometry::no_index) from.vertices = {seam_vertex_from};
  const auto seam = seam_between(mesh, *topology, from, loops[1]);
  EXPECT_TRUE(seam.has_value());
  auto theta = periodic_harmonic(mesh, *topology, *seam);
  EXPECT_TRUE(theta.has_value());
  return *theta;
}

TEST(Operators, LaplacianIsSymmetricAndKillsConstants) {
  for (int seed = 0; seed < cases(8); ++seed) {
    SCOPED_TRACE(seed);
    const TriangleMesh mesh = ring(40, 8, 5.0, 20.0, 0.2, static_cast<unsigned>(seed));
    const SparseMatrix laplacian = cotan_laplacian(mesh);
    EXPECT_LT(SparseMatrix(laplacian - SparseMatrix(laplacian.transpose())).norm(), 1e-12);
    EXPECT_LT((laplacian * Eigen::VectorXd::Ones(laplacian.rows())).norm(), 1e-11);
  }
}

TEST(Operators, LinearFunctionsHaveTheirGradientAndNoLaplacianInside) {
  const TriangleMesh mesh = ring(40, 8, 5.0, 20.0, 0.2, 3);
  const Vec3 slope(0.7, -1.3, 0.0);
  std::vector<double> values;
  for (const Vec3& p : mesh.vertices_mm) values.push_back(slope.dot(p) + 4.0);
  const auto operators = triangle_operators(mesh);
  const auto gradients = gradient(mesh, operators, values);
  for (std::size_t t = 0; t < gradients.size(); ++t)
    EXPECT_LT((operators[t].to_space(gradients[t]) - slope).norm(), 1e-12);
  const auto topology = MeshTopology::build(mesh);
  const auto laplacian = divergence(mesh, operators, gradients);
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (topology->is_boundary_vertex(static_cast<Index>(v))) continue;
    EXPECT_NEAR(laplacian[v], 0.0, 1e-11);
  }
}

TEST(Operators, DivergenceOfGradientIsLaplacian) {
  const TriangleMesh mesh = ring(24, 5, 5.0, 20.0, 0.25, 11);
  std::mt19937 random(5);
  std::vector<double> values(mesh.vertices_mm.size());
  for (double& v : values) v = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  const auto operators = triangle_operators(mesh);
  const auto by_gradient = divergence(mesh, operators, gradient(mesh, operators, values));
  const Eigen::VectorXd by_matrix =
      cotan_laplacian(mesh) *
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  for (std::size_t v = 0; v < values.size(); ++v)
    EXPECT_NEAR(by_gradient[v], by_matrix[static_cast<Eigen::Index>(v)], 1e-12);
}

TEST(Operators, VertexAreasSumToArea) {
  const TriangleMesh mesh = ring(24, 5, 5.0, 20.0, 0.25, 2);
  double sum = 0.0;
  for (double a : vertex_areas_mm2(mesh)) sum += a;
  EXPECT_NEAR(sum, geometry::area_mm2(mesh), 1e-9);
}

TEST(SparseSolver, SolvesToRoundingAndRefactorsToTheSame) {
  const TriangleMesh mesh = ring(60, 20, 5.0, 20.0, 0.2, 1);
  SparseMatrix matrix = cotan_laplacian(mesh);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) += 0.1;
  const Eigen::MatrixXd right = Eigen::MatrixXd::Random(matrix.rows(), 3);
  auto solver = SparseSolver::factor(matrix);
  ASSERT_TRUE(solver.has_value());
  const Eigen::MatrixXd together = solver->solve(right);
  EXPECT_LT((matrix * together - right).norm(), 1e-10 * right.norm());
  const Eigen::VectorXd alone = solver->solve(Eigen::VectorXd(right.col(1)));
  EXPECT_EQ((alone - together.col(1)).cwiseAbs().maxCoeff(), 0.0);
  ASSERT_TRUE(solver->refactor(SparseMatrix(2.0 * matrix)).has_value());
  EXPECT_LT((2.0 * solver->solve(Eigen::VectorXd(right.col(0))) - together.col(0)).norm(), 1e-12);
}

TEST(SparseSolver, SaysWhenMatrixIsNotPositiveDefinite) {
  SparseMatrix matrix(2, 2);
  matrix.insert(0, 0) = 1.0;
  matrix.insert(1, 1) = -1.0;
  matrix.makeCompressed();
  const auto solver = SparseSolver::factor(matrix);
  ASSERT_FALSE(solver.has_value());
  EXPECT_EQ(solver.error().code, "matrix-not-positive-definite");
}

// Closed form: on a ring the harmonic function with period 1 and no flux is angle / (2 pi), with |gradient| = 1 / (2 pi
// r).
TEST(PeriodicCoordinate, IsTheAngleOnARing) {
  const TriangleMesh mesh = ring(180, 40, 5.0, 20.0, 0.0, 0);
  const PeriodicCoordinate theta = angle_coordinate(mesh, geometry::no_index);
  const double zero = std::atan2(mesh.vertices_mm[static_cast<std::size_t>(theta.seam[0])].y(),
                                 mesh.vertices_mm[static_cast<std::size_t>(theta.seam[0])].x());
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
    const double angle = std::atan2(mesh.vertices_mm[v].y(), mesh.vertices_mm[v].x()) - zero;
    const double off = theta.vertex[v] - angle / (2.0 * std::numbers::pi);
    EXPECT_NEAR(off - std::round(off), 0.0, 2e-4);
  }
}

TEST(PeriodicCoordinate, GradientDoesNotDependOnSeam) {
  for (int seed = 0; seed < cases(8); ++seed) {
    SCOPED_TRACE(seed);
    const TriangleMesh mesh = ring(50, 12, 5.0, 20.0, 0.25, static_cast<unsigned>(seed));
    const auto first = static_cast<Index>(12 * 50);  // the outer loop's first vertex
    const PeriodicCoordinate a = angle_coordinate(mesh, first + 7), b = angle_coordinate(mesh, first + 31);
    const auto operators = triangle_operators(mesh);
    for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
      const auto& o = operators[static_cast<std::size_t>(t)];
      const Vec2 of_a = o.gradient(a.at_corner(mesh, t, 0), a.at_corner(mesh, t, 1), a.at_corner(mesh, t, 2));
      const Vec2 of_b = o.gradient(b.at_corner(mesh, t, 0), b.at_corner(mesh, t, 1), b.at_corner(mesh, t, 2));
      EXPECT_LT((of_a - of_b).norm(), 1e-11);
    }
  }
}

/// Equal pattern and equal bytes.
void expect_same(const SparseMatrix& got, const SparseMatrix& wanted) {
  ASSERT_EQ(got.nonZeros(), wanted.nonZeros());
  for (Eigen::Index c = 0; c < wanted.cols(); ++c) {
    SparseMatrix::InnerIterator a(got, c), b(wanted, c);
    for (; a && b; ++a, ++b) {
      ASSERT_EQ(a.row(), b.row()) << "column " << c;
      ASSERT_EQ(a.value(), b.value()) << "row " << a.row() << ", column " << c;
    }
    ASSERT_FALSE(a || b) << "column " << c;
  }
}

// Property 1 of Ties: Eigen's products with R written out.
TEST(Ties, EveryProductIsThatWithTheMatrixWrittenOut) {
  constexpr unsigned seed = 31;
  std::mt19937 random(seed);
  for (int i = 0; i < cases(8); ++i) {
    SCOPED_TRACE(i);
    const TriangleMesh mesh = ring(60, 24, 5.0, 20.0, 0.2, seed + static_cast<unsigned>(i));
    const auto n = static_cast<Eigen::Index>(mesh.vertices_mm.size());
    constexpr int shared = 3;
    std::vector<int> unknown(static_cast<std::size_t>(n), -1);
    int count = shared;
    for (int& u : unknown) {
      const auto kind = random() % 8;
      if (kind > 0) u = kind < 4 ? static_cast<int>(kind) - 1 : count++;
    }
    SparseMatrix written(n, count);
    for (Eigen::Index v = 0; v < n; ++v) {
      if (unknown[static_cast<std::size_t>(v)] >= 0) written.insert(v, unknown[static_cast<std::size_t>(v)]) = 1.0;
    }
    const Ties ties(unknown, count);
    const SparseMatrix laplacian = cotan_laplacian(mesh);
    const Eigen::VectorXd weight = Eigen::VectorXd::Random(n).cwiseAbs();
    const SparseMatrix columns = laplacian * written;
    const SparseMatrix both = written.transpose() * laplacian * written;
    expect_same(tied_columns(laplacian, ties), columns);
    expect_same(tied(laplacian, ties), both);
    const SparseMatrix square = columns.transpose() * weight.asDiagonal() * columns;
    expect_same(plus_square(both, columns, weight), both + square);
    const Eigen::VectorXd gathered = written.transpose() * weight;
    EXPECT_TRUE(tied(weight, ties) == gathered);
  }
}

}  // namespace
}  // namespace volute::planner
