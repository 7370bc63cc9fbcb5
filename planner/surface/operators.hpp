// Differential operators of piecewise linear functions on a triangle mesh.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/SparseCore>

#include "geometry/mesh.hpp"

namespace volute::planner {

using geometry::Index;
using geometry::Vec2;
using geometry::Vec3;

using SparseMatrix = Eigen::SparseMatrix<double>;

/// One triangle's tangent frame and the gradients of its three hat functions in that frame.
struct TriangleOperator {
  Vec3 tangent = Vec3::UnitX(), binormal = Vec3::UnitY(),
       normal = Vec3::UnitZ();  ///< right-handed, unit; tangent along edge 0
  double area_mm2 = 0.0;
  std::array<Vec2, 3> hat_per_mm{};  ///< gradient of the function that is 1 at corner k and 0 at the others

  [[nodiscard]] Vec3 to_space(const Vec2& v) const { return v.x() * tangent + v.y() * binormal; }
  [[nodiscard]] Vec2 to_plane(const Vec3& v) const { return {v.dot(tangent), v.dot(binormal)}; }
  /// Gradient, per mm, of the function with these corner values.
  [[nodiscard]] Vec2 gradient(double a, double b, double c) const {
    return a * hat_per_mm[0] + b * hat_per_mm[1] + c * hat_per_mm[2];
  }
};

/// Requires: no triangle of zero area (VOLUTE_CHECK). Triangles are independent: the same bytes on any number of
/// threads.
std::vector<TriangleOperator> triangle_operators(const geometry::TriangleMesh& mesh);

/// A third of the area of the triangles around each vertex, mm^2. Property: they sum to the mesh's area.
std::vector<double> vertex_areas_mm2(const geometry::TriangleMesh& mesh);

/// The positive semi-definite cotangent Laplacian K: u . K u is the integral of |grad u|^2.
/// Properties: 1. K is symmetric. 2. K times a constant is 0. 3. On a plane (K x)_i = 0 at inner vertices for linear x.
/// 4. With a weight per triangle, u . K u is the integral of weight |grad u|^2.
SparseMatrix cotan_laplacian(const geometry::TriangleMesh& mesh, std::span<const double> triangle_weight = {});
/// The same with the mesh's triangle_operators.
SparseMatrix cotan_laplacian(const geometry::TriangleMesh& mesh, std::span<const TriangleOperator> operators,
                             std::span<const double> triangle_weight = {});

/// Gradient of each triangle, per mm, in the triangle's frame. Requires one value a vertex.
std::vector<Vec2> gradient(const geometry::TriangleMesh& mesh, std::span<const TriangleOperator> operators,
                           std::span<const double> values);

/// The integrated divergence: component i is the integral of field . grad(hat_i). Property: divergence(gradient(u)) = K
/// u.
std::vector<double> divergence(const geometry::TriangleMesh& mesh, std::span<const TriangleOperator> operators,
                               std::span<const Vec2> field);

/// Corners of the triangles around each vertex, by vertex: corner 3 t + k belongs to vertex triangles[t][k].
/// The order within a vertex is that of the triangles, so that sums over it do not depend on threads.
class VertexCorners {
 public:
  explicit VertexCorners(const geometry::TriangleMesh& mesh);
  [[nodiscard]] std::span<const Index> of(Index vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span<const Index>(corner_).subspan(static_cast<std::size_t>(start_[v]),
                                                   static_cast<std::size_t>(start_[v + 1] - start_[v]));
  }

 private:
  std::vector<Index> start_, corner_;
};

}  // namespace volute::planner
