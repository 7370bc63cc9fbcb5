#include "planner/surface/geodesic_distance.hpp"

#include <algorithm>

#include "geometry/check.hpp"
#include "planner/surface/operators.hpp"
#include "planner/surface/sparse_solver.hpp"

namespace volute::planner {

using geometry::Result;
using geometry::TriangleMesh;

namespace {

double mean_edge_sq_mm2(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const geometry::Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      sum += (mesh.vertices_mm[static_cast<std::size_t>(t[(k + 1) % 3])] -
              mesh.vertices_mm[static_cast<std::size_t>(t[k])])
                 .squaredNorm();
  return sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

}  // namespace

Result<std::vector<double>> geodesic_distance_mm(const TriangleMesh& mesh, std::span<const Index> sources) {
  VOLUTE_CHECK(!sources.empty(), sources.size());
  const SparseMatrix laplacian = cotan_laplacian(mesh);
  SparseMatrix heat = mean_edge_sq_mm2(mesh) * laplacian;
  const std::vector<double> area = vertex_areas_mm2(mesh);
  for (std::size_t v = 0; v < area.size(); ++v)
    heat.coeffRef(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(v)) += area[v];
  const std::vector<int> fixed(sources.begin(), sources.end());
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(fixed.size()), 1);
  const auto warm = solve_with_fixed(heat, fixed, ones);
  if (!warm) return tl::unexpected(warm.error());
  const std::vector<double> warmth(warm->data(), warm->data() + warm->rows());
  const auto operators = triangle_operators(mesh);
  std::vector<Vec2> away = gradient(mesh, operators, warmth);
  for (Vec2& g : away) g = g.norm() > 0.0 ? Vec2(-g / g.norm()) : Vec2::Zero();
  const auto load = divergence(mesh, operators, away);
  const Eigen::MatrixXd right = Eigen::Map<const Eigen::VectorXd>(load.data(), static_cast<Eigen::Index>(load.size()));
  const auto distance = solve_with_fixed(laplacian, fixed, Eigen::MatrixXd::Zero(ones.rows(), 1), right);
  if (!distance) return tl::unexpected(distance.error());
  std::vector<double> result(distance->data(), distance->data() + distance->rows());
  for (double& d : result) d = std::max(d, 0.0);
  return result;
}

}  // namespace volute::planner
