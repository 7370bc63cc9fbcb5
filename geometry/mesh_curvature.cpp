// Curvature tensors after S. Rusinkiewicz, "Estimating curvatures and their derivatives on triangle meshes", 3DPVT
// 2004. Departs from the source: tensors are kept as 3 x 3 matrices in the part's axes; triangles at the boundary,
// whose vertex normals are one-sided, take their tensor from their inner neighbours.
#include <Eigen/Dense>
#include <cmath>
#include <cstdint>

#include "geometry/mesh_measure.hpp"

#include "geometry/index.hpp"

namespace volute::geometry {

namespace {

using Vec3List = std::vector<Vec3>;
using Mat3List = std::vector<Mat3>;

/// `tensor`, tangent to the plane of normal `from`, turned by the least rotation into the plane of `to`.
/// Where the surface folds back on itself no rotation is least: the tensor is only projected.
Mat3 carried(const Mat3& tensor, const Vec3& from, const Vec3& to) {
  const double cosine = from.dot(to);
  if (cosine < -0.99)
    return (Mat3::Identity() - to * to.transpose()) * tensor * (Mat3::Identity() - to * to.transpose());
  // R = I - (from + to)(from + to)' / (1 + cosine) + 2 to from'; R tensor R' with tensor * from = 0 leaves these terms.
  const Vec3 bisector = (from + to) / (1.0 + cosine);
  const Vec3 s_to = tensor * to;
  const double to_s_to = to.dot(s_to);
  return tensor - bisector * s_to.transpose() - s_to * bisector.transpose() + to_s_to * bisector * bisector.transpose();
}

/// The second fundamental form that explains best how the vertex normals change along the three edges.
Mat3 fitted_tensor(const TriangleMesh& mesh, const Triangle& corners, const Vec3& normal, const Vec3List& normals) {
  const Vec3 u = (mesh.vertices_mm[at(corners[1])] - mesh.vertices_mm[at(corners[0])]).normalized();
  const Vec3 v = normal.cross(u);
  Mat3 lhs = Mat3::Zero();
  Vec3 rhs = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const Index from = corners[k], to = corners[(k + 1) % 3];
    const Vec3 edge = mesh.vertices_mm[at(to)] - mesh.vertices_mm[at(from)];
    const Vec3 change = normals[at(to)] - normals[at(from)];
    const Vec3 row_u(edge.dot(u), edge.dot(v), 0.0), row_v(0.0, edge.dot(u), edge.dot(v));
    lhs += row_u * row_u.transpose() + row_v * row_v.transpose();
    rhs += row_u * change.dot(u) + row_v * change.dot(v);
  }
  const Vec3 form = lhs.ldlt().solve(rhs);  // e, f, g of [e f; f g]
  return form[0] * u * u.transpose() + form[1] * (u * v.transpose() + v * u.transpose()) + form[2] * v * v.transpose();
}

/// On a closed fan the sum of (next - previous) vertex number vanishes; on an open one it is (last - first), never
/// zero.
std::vector<char> boundary_vertices(const TriangleMesh& mesh) {
  std::vector<std::int64_t> sums(mesh.vertices_mm.size(), 0);
  for (const Triangle& corners : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) sums[at(corners[k])] += corners[(k + 1) % 3] - corners[(k + 2) % 3];
  std::vector<char> boundary(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) boundary[v] = sums[v] != 0 ? 1 : 0;
  return boundary;
}

/// What one round of averaging works on.
struct TensorField {
  const TriangleMesh& mesh;
  Vec3List triangle_normal, vertex_normal;
  std::vector<double> area_mm2;
  Mat3List tensor;
  std::vector<char> known;
};

/// Area-weighted mean at every vertex over its triangles of known tensor; the weight is 0 where there is none.
void vertex_means(const TensorField& field, Mat3List& mean, std::vector<double>& weight) {
  mean.assign(field.mesh.vertices_mm.size(), Mat3::Zero());
  weight.assign(field.mesh.vertices_mm.size(), 0.0);
  for (std::size_t t = 0; t < field.tensor.size(); ++t) {
    if (field.known[t] == 0) continue;
    for (const Index v : field.mesh.triangles[t]) {
      mean[at(v)] += field.area_mm2[t] * carried(field.tensor[t], field.triangle_normal[t], field.vertex_normal[at(v)]);
      weight[at(v)] += field.area_mm2[t];
    }
  }
  for (std::size_t v = 0; v < mean.size(); ++v)
    if (weight[v] > 0.0) mean[v] /= weight[v];
}

/// One round; `only_unknown` fills triangles without a tensor and leaves the others. Returns the number of triangles
/// filled.
std::size_t average_once(TensorField& field, bool only_unknown) {
  Mat3List mean;
  std::vector<double> weight;
  vertex_means(field, mean, weight);
  std::size_t filled = 0;
  for (std::size_t t = 0; t < field.tensor.size(); ++t) {
    if (only_unknown && field.known[t] != 0) continue;
    Mat3 sum = Mat3::Zero();
    int count = 0;
    for (const Index v : field.mesh.triangles[t]) {
      if (weight[at(v)] <= 0.0) continue;
      sum += carried(mean[at(v)], field.vertex_normal[at(v)], field.triangle_normal[t]);
      ++count;
    }
    if (count == 0) continue;
    field.tensor[t] = sum / count;
    field.known[t] = 1;
    ++filled;
  }
  return filled;
}

TensorField fitted_field(const TriangleMesh& mesh) {
  TensorField field{mesh, triangle_normals(mesh), vertex_normals(mesh), {}, {}, {}};
  const std::vector<char> boundary = boundary_vertices(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    field.area_mm2.push_back(triangle_area_mm2(mesh, static_cast<Index>(t)));
    field.tensor.push_back(fitted_tensor(mesh, corners, field.triangle_normal[t], field.vertex_normal));
    const bool inner = boundary[at(corners[0])] + boundary[at(corners[1])] + boundary[at(corners[2])] == 0;
    field.known.push_back(inner ? 1 : 0);
  }
  return field;
}

}  // namespace

std::vector<Mat3> triangle_curvature(const TriangleMesh& mesh, int rounds) {
  TensorField field = fitted_field(mesh);
  while (average_once(field, true) > 0) {
  }
  field.known.assign(field.known.size(), 1);  // a component that is all boundary keeps its one-sided tensors
  for (int round = 0; round < rounds; ++round) average_once(field, false);
  return field.tensor;
}

PrincipalCurvature principal_curvature(const Mat3& tensor, const Vec3& unit_normal) {
  const Vec3 u = unit_normal.unitOrthogonal(), v = unit_normal.cross(u);
  const double e = u.dot(tensor * u), f = u.dot(tensor * v), g = v.dot(tensor * v);
  const double mean = 0.5 * (e + g), radius = std::hypot(0.5 * (e - g), f);
  const double angle = 0.5 * std::atan2(2.0 * f, e - g);
  return {mean - radius, mean + radius, std::cos(angle) * u + std::sin(angle) * v};
}

}  // namespace volute::geometry
