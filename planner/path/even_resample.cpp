#include "planner/path/even_resample.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "geometry/check.hpp"
#include "geometry/index.hpp"

namespace volute::planner {
namespace {

using geometry::at;
using geometry::MeshTopology;
using geometry::no_index;
using geometry::Triangle;
using geometry::Vec3;

/// The triangle with middles (no_index: edge not halved) on its edges k -> k + 1.
void append_split(const Triangle& t, const std::array<Index, 3>& middle, std::vector<Triangle>& out) {
  const auto count = std::count_if(middle.begin(), middle.end(), [](Index m) { return m != no_index; });
  if (count == 0) {
    out.push_back(t);
    return;
  }
  if (count == 3) {
    for (std::size_t k = 0; k < 3; ++k) out.push_back({t[k], middle[k], middle[(k + 2) % 3]});
    out.push_back({middle[0], middle[1], middle[2]});
    return;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Index a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    const Index ab = middle[k], bc = middle[(k + 1) % 3];
    if (count == 1 && ab != no_index) {
      out.push_back({a, ab, c});
      out.push_back({ab, b, c});
    } else if (count == 2 && ab != no_index && bc != no_index) {
      out.push_back({ab, b, bc});
      out.push_back({a, ab, bc});
      out.push_back({a, bc, c});
    }
  }
}

/// Bits of x at every third place.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

}  // namespace

Result<FinerMesh> finer(const TriangleMesh& mesh, double edge_max_mm) {
  VOLUTE_CHECK(edge_max_mm > 0.0, edge_max_mm);
  FinerMesh out{mesh, {}, {}};
  out.parent.resize(mesh.triangles.size());
  std::iota(out.parent.begin(), out.parent.end(), Index{0});
  auto& vertices = out.mesh.vertices_mm;
  while (true) {
    const auto topology = MeshTopology::build(out.mesh);
    if (!topology) return tl::unexpected(topology.error());
    std::vector<Index> middle(at(topology->edge_count()), no_index);
    const std::size_t before = out.ends.size();
    for (Index e = 0; e < topology->edge_count(); ++e) {
      const Index h = topology->edge_halfedge(e), next = geometry::next_halfedge(h);
      const Index a = out.mesh.triangles[at(h / 3)][at(h % 3)], b = out.mesh.triangles[at(next / 3)][at(next % 3)];
      if ((vertices[at(a)] - vertices[at(b)]).norm() <= edge_max_mm) continue;
      middle[at(e)] = static_cast<Index>(vertices.size());
      vertices.push_back(0.5 * (vertices[at(a)] + vertices[at(b)]));
      out.ends.push_back({a, b});
    }
    if (out.ends.size() == before) return out;
    std::vector<Triangle> split;
    std::vector<Index> parent;
    for (Index t = 0; t < static_cast<Index>(out.mesh.triangles.size()); ++t) {
      append_split(out.mesh.triangles[at(t)],
                   {middle[at(topology->edge(3 * t))], middle[at(topology->edge(3 * t + 1))],
                    middle[at(topology->edge(3 * t + 2))]},
                   split);
      parent.resize(split.size(), out.parent[at(t)]);
    }
    out.mesh.triangles = std::move(split);
    out.parent = std::move(parent);
  }
}

TriangleMesh in_memory_order(const TriangleMesh& mesh) {
  std::vector<char> used(mesh.vertices_mm.size(), 0);
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  for (const Triangle& t : mesh.triangles) {
    for (Index v : t) {
      used[at(v)] = 1;
      low = low.cwiseMin(mesh.vertices_mm[at(v)]);
      high = high.cwiseMax(mesh.vertices_mm[at(v)]);
    }
  }
  const double scale = 2097151.0 / std::max((high - low).maxCoeff(), 1e-12);
  std::vector<std::pair<std::uint64_t, Index>> order;
  for (Index v = 0; v < static_cast<Index>(used.size()); ++v) {
    if (used[at(v)] == 0) continue;
    const Vec3 place = (mesh.vertices_mm[at(v)] - low) * scale;
    order.emplace_back(spread(static_cast<std::uint64_t>(place.x())) |
                           spread(static_cast<std::uint64_t>(place.y())) << 1 |
                           spread(static_cast<std::uint64_t>(place.z())) << 2,
                       v);
  }
  std::sort(order.begin(), order.end());
  TriangleMesh out;
  std::vector<Index> number(used.size(), no_index);
  for (const auto& [code, v] : order) {
    number[at(v)] = static_cast<Index>(out.vertices_mm.size());
    out.vertices_mm.push_back(mesh.vertices_mm[at(v)]);
  }
  for (const Triangle& t : mesh.triangles) {
    Triangle turned = {number[at(t[0])], number[at(t[1])], number[at(t[2])]};
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
    out.triangles.push_back(turned);
  }
  std::sort(out.triangles.begin(), out.triangles.end());
  return out;
}

}  // namespace volute::planner
