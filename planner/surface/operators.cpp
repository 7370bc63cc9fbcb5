#include "planner/surface/operators.hpp"

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "planner/surface/sparse_columns.hpp"

namespace volute::planner {
namespace {

using geometry::at;
using geometry::Triangle;
using geometry::TriangleMesh;

TriangleOperator triangle_operator(const Vec3& a, const Vec3& b, const Vec3& c) {
  TriangleOperator out;
  const Vec3 edge = b - a, other = c - a;
  const Vec3 cross = edge.cross(other);
  const double twice_area = cross.norm();
  VOLUTE_CHECK(twice_area > 0.0, a.transpose(), b.transpose(), c.transpose());
  out.normal = cross / twice_area;
  out.tangent = edge.normalized();
  out.binormal = out.normal.cross(out.tangent);
  out.area_mm2 = 0.5 * twice_area;
  const std::array<Vec2, 3> p = {Vec2(0.0, 0.0), Vec2(edge.norm(), 0.0), out.to_plane(other)};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 opposite = p[(k + 2) % 3] - p[(k + 1) % 3];
    out.hat_per_mm[k] = Vec2(-opposite.y(), opposite.x()) / twice_area;
  }
  return out;
}

}  // namespace

std::vector<TriangleOperator> triangle_operators(const TriangleMesh& mesh) {
  std::vector<TriangleOperator> out;
  out.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    out.push_back(
        triangle_operator(mesh.vertices_mm[at(t[0])], mesh.vertices_mm[at(t[1])], mesh.vertices_mm[at(t[2])]));
  }
  return out;
}

std::vector<double> vertex_areas_mm2(const TriangleMesh& mesh) {
  std::vector<double> out(mesh.vertices_mm.size(), 0.0);
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_mm[at(t[0])];
    const double third = (mesh.vertices_mm[at(t[1])] - a).cross(mesh.vertices_mm[at(t[2])] - a).norm() / 6.0;
    for (Index v : t) out[at(v)] += third;
  }
  return out;
}

SparseMatrix cotan_laplacian(const TriangleMesh& mesh, std::span<const double> triangle_weight) {
  return cotan_laplacian(mesh, triangle_operators(mesh), triangle_weight);
}

SparseMatrix cotan_laplacian(const TriangleMesh& mesh, std::span<const TriangleOperator> operators,
                             std::span<const double> triangle_weight) {
  VOLUTE_CHECK(operators.size() == mesh.triangles.size(), operators.size());
  VOLUTE_CHECK(triangle_weight.empty() || triangle_weight.size() == mesh.triangles.size(), triangle_weight.size());
  const VertexCorners corners(mesh);
  const auto n = static_cast<Eigen::Index>(mesh.vertices_mm.size());
  return by_columns(n, n, [&](Eigen::Index v, ColumnSum& sum) {
    for (const Index corner : corners.of(static_cast<Index>(v))) {
      const std::size_t t = at(corner / 3), k = at(corner % 3);
      const double scale = operators[t].area_mm2 * (triangle_weight.empty() ? 1.0 : triangle_weight[t]);
      for (std::size_t i = 0; i < 3; ++i)
        sum.add(mesh.triangles[t][i], scale * operators[t].hat_per_mm[i].dot(operators[t].hat_per_mm[k]));
    }
  });
}

std::vector<Vec2> gradient(const TriangleMesh& mesh, std::span<const TriangleOperator> operators,
                           std::span<const double> values) {
  VOLUTE_CHECK(operators.size() == mesh.triangles.size() && values.size() == mesh.vertices_mm.size(), values.size());
  std::vector<Vec2> out(mesh.triangles.size());
  for (std::size_t t = 0; t < out.size(); ++t) {
    const Triangle& v = mesh.triangles[t];
    out[t] = operators[t].gradient(values[at(v[0])], values[at(v[1])], values[at(v[2])]);
  }
  return out;
}

std::vector<double> divergence(const TriangleMesh& mesh, std::span<const TriangleOperator> operators,
                               std::span<const Vec2> field) {
  VOLUTE_CHECK(operators.size() == mesh.triangles.size() && field.size() == operators.size(), field.size());
  std::vector<double> out(mesh.vertices_mm.size(), 0.0);
  for (std::size_t t = 0; t < field.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      out[at(mesh.triangles[t][k])] += operators[t].area_mm2 * field[t].dot(operators[t].hat_per_mm[k]);
    }
  }
  return out;
}

VertexCorners::VertexCorners(const TriangleMesh& mesh) : start_(mesh.vertices_mm.size() + 1, 0) {
  for (const Triangle& t : mesh.triangles) {
    for (Index v : t) ++start_[at(v) + 1];
  }
  for (std::size_t v = 1; v < start_.size(); ++v) start_[v] += start_[v - 1];
  corner_.resize(3 * mesh.triangles.size());
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (std::size_t c = 0; c < corner_.size(); ++c) {
    const Index v = mesh.triangles[c / 3][c % 3];
    corner_[at(next[at(v)]++)] = static_cast<Index>(c);
  }
}

}  // namespace volute::planner
