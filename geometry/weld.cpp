// Joins corners that are the same point, in two steps: bit-equal ones through a hash table, near ones through a sweep.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>

#include "geometry/index.hpp"
#include "geometry/mesh_clean.hpp"
#include "geometry/mesh_io.hpp"

namespace volute::geometry {

namespace {

std::uint64_t hash_of(const Vec3& point) {
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) {
    std::uint64_t bits = 0;
    const double value = point[k] + 0.0;  // -0 becomes 0
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29;
  }
  return hash;
}

/// For every point the lowest index of a bit-equal one.
std::vector<Index> first_equal(const std::vector<Vec3>& points) {
  std::size_t room = 16;
  while (room < 2 * points.size()) room *= 2;
  std::vector<Index> table(room, no_index), first(points.size());
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    std::size_t slot = hash_of(points[at(i)]) & (room - 1);
    while (table[slot] != no_index && points[at(table[slot])] != points[at(i)]) slot = (slot + 1) & (room - 1);
    if (table[slot] == no_index) table[slot] = i;
    first[at(i)] = table[slot];
  }
  return first;
}

Index root_of(std::vector<Index>& parent, Index i) {
  while (parent[at(i)] != i) i = parent[at(i)] = parent[at(parent[at(i)])];
  return i;
}

struct Swept {
  double along = 0.0;
  Index point = 0;
};

/// The points that stand for themselves, ordered along a direction in which hardly any two share a coordinate.
std::vector<Swept> swept_order(const std::vector<Vec3>& points, const std::vector<Index>& parent) {
  const Vec3 direction = Vec3(0.5377, 0.6123, 0.5797).normalized();
  std::vector<Swept> order;
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i)
    if (parent[at(i)] == i) order.push_back({direction.dot(points[at(i)]), i});
  std::sort(order.begin(), order.end(),
            [](const Swept& a, const Swept& b) { return a.along != b.along ? a.along < b.along : a.point < b.point; });
  return order;
}

/// Union-find over pairs nearer than the tolerance; the lowest index stands for the others. Returns the number joined.
Index join_near(const std::vector<Vec3>& points, double tolerance_mm, std::vector<Index>& parent) {
  const std::vector<Swept> order = swept_order(points, parent);
  Index joined = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && order[j].along - order[i].along <= tolerance_mm; ++j) {
      if ((points[at(order[i].point)] - points[at(order[j].point)]).norm() > tolerance_mm) continue;
      const Index a = root_of(parent, order[i].point), b = root_of(parent, order[j].point);
      if (a == b) continue;
      parent[at(std::max(a, b))] = std::min(a, b);
      ++joined;
    }
  }
  return joined;
}

double default_tolerance_mm(const std::vector<Vec3>& points) {
  Vec3 least = points.front(), greatest = points.front();
  for (const Vec3& p : points) {
    least = least.cwiseMin(p);
    greatest = greatest.cwiseMax(p);
  }
  const double farthest = std::max(least.cwiseAbs().maxCoeff(), greatest.cwiseAbs().maxCoeff());
  return std::max(1e-7 * (greatest - least).norm(), std::ldexp(farthest, -23));
}

void drop_unused_vertices(TriangleMesh& mesh) {
  std::vector<Index> number(mesh.vertices_mm.size(), no_index);
  for (const Triangle& corners : mesh.triangles)
    for (const Index v : corners) number[at(v)] = 0;
  Index count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == no_index) continue;
    number[v] = count;
    mesh.vertices_mm[at(count++)] = mesh.vertices_mm[v];
  }
  mesh.vertices_mm.resize(at(count));
  for (Triangle& corners : mesh.triangles)
    for (Index& v : corners) v = number[at(v)];
}

void warn(MeshRepairs& repairs, Index count, const std::string& what) {
  if (count > 0) repairs.warnings.push_back(std::to_string(count) + " " + what);
}

}  // namespace

LoadedMesh weld(TriangleMesh soup, double tolerance_mm) {
  LoadedMesh loaded{std::move(soup), {}};
  TriangleMesh& mesh = loaded.mesh;
  if (mesh.vertices_mm.empty()) return loaded;
  if (tolerance_mm < 0.0) tolerance_mm = default_tolerance_mm(mesh.vertices_mm);
  std::vector<Index> parent = first_equal(mesh.vertices_mm);
  loaded.repairs.vertices_welded = join_near(mesh.vertices_mm, tolerance_mm, parent);
  for (Triangle& corners : mesh.triangles)
    for (Index& v : corners) v = root_of(parent, v);
  loaded.repairs.degenerate_triangles_removed = remove_degenerate(mesh, tolerance_mm);
  loaded.repairs.duplicate_triangles_removed = remove_duplicates(mesh);
  drop_unused_vertices(mesh);
  warn(loaded.repairs, loaded.repairs.vertices_welded, "vertices joined that were not quite equal");
  warn(loaded.repairs, loaded.repairs.degenerate_triangles_removed, "triangles without area removed");
  warn(loaded.repairs, loaded.repairs.duplicate_triangles_removed, "triangles removed that were there twice");
  return loaded;
}

}  // namespace volute::geometry
