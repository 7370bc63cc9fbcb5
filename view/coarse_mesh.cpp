#include "view/coarse_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/check.hpp"
#include "geometry/mesh_measure.hpp"

namespace volute::view {

namespace {

using geometry::Index;
using geometry::Vec3;

constexpr double cell_growth = 1.25;

/// Cells along one axis never reach 2^20: the key of a cell has 20 bits an axis.
std::int64_t cell_key(const Vec3& point, const Vec3& least, double cell_mm) {
  std::int64_t key = 0;
  for (int axis = 0; axis < 3; ++axis)
    key = key * (1 << 20) + static_cast<std::int64_t>((point[axis] - least[axis]) / cell_mm);
  return key;
}

CoarseMesh clustered(const geometry::TriangleMesh& mesh, const Vec3& least, double cell_mm) {
  const std::size_t count = mesh.vertices_mm.size();
  std::vector<std::int64_t> key(count);
  for (std::size_t i = 0; i < count; ++i) key[i] = cell_key(mesh.vertices_mm[i], least, cell_mm);
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
  CoarseMesh coarse;
  coarse.cluster_of_vertex.assign(count, geometry::no_index);
  for (std::size_t first = 0; first < count;) {
    std::size_t last = first;
    Vec3 sum = Vec3::Zero();
    for (; last < count && key[order[last]] == key[order[first]]; ++last) {
      sum += mesh.vertices_mm[order[last]];
      coarse.cluster_of_vertex[order[last]] = static_cast<Index>(coarse.mesh.vertices_mm.size());
    }
    coarse.mesh.vertices_mm.emplace_back(sum / static_cast<double>(last - first));
    first = last;
  }
  for (const geometry::Triangle& t : mesh.triangles) {
    const geometry::Triangle c{coarse.cluster_of_vertex[t[0]], coarse.cluster_of_vertex[t[1]],
                               coarse.cluster_of_vertex[t[2]]};
    if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) coarse.mesh.triangles.push_back(c);
  }
  return coarse;
}

}  // namespace

CoarseMesh coarse_mesh(const geometry::TriangleMesh& mesh, std::size_t triangles_max) {
  VOLUTE_CHECK(triangles_max >= 1, triangles_max);
  CoarseMesh coarse;
  if (mesh.triangles.size() <= triangles_max) {
    coarse.mesh = mesh;
    coarse.cluster_of_vertex.resize(mesh.vertices_mm.size());
    std::iota(coarse.cluster_of_vertex.begin(), coarse.cluster_of_vertex.end(), 0);
    return coarse;
  }
  Vec3 least = mesh.vertices_mm.front(), greatest = least;
  for (const Vec3& vertex : mesh.vertices_mm) {
    least = least.cwiseMin(vertex);
    greatest = greatest.cwiseMax(vertex);
  }
  double cell_mm = std::sqrt(2.0 * geometry::area_mm2(mesh) / static_cast<double>(triangles_max));
  cell_mm = std::max(cell_mm, (greatest - least).maxCoeff() / ((1 << 20) - 2.0));
  for (;; cell_mm *= cell_growth) {
    coarse = clustered(mesh, least, cell_mm);
    if (coarse.mesh.triangles.size() <= triangles_max) return coarse;
  }
}

std::vector<double> coarse_values(const CoarseMesh& coarse, const std::vector<double>& values) {
  std::vector<double> out(coarse.mesh.vertices_mm.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < values.size(); ++i) {
    double& kept = out[static_cast<std::size_t>(coarse.cluster_of_vertex[i])];
    if (std::isfinite(values[i]) && !(std::abs(values[i]) <= std::abs(kept))) kept = values[i];
  }
  return out;
}

}  // namespace volute::view
