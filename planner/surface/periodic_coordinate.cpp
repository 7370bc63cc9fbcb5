#include "planner/surface/periodic_coordinate.hpp"

#include <algorithm>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "planner/surface/operators.hpp"
#include "planner/surface/slice_path.hpp"
#include "planner/surface/sparse_solver.hpp"

namespace volute::planner {
namespace {

using geometry::at;
using geometry::BoundaryLoop;
using geometry::MeshTopology;
using geometry::TriangleMesh;

/// Position among the vertex's outgoing halfedges of the edge to `target`; the count itself for the closing boundary
/// edge.
std::size_t edge_position(const MeshTopology& topology, Index vertex, Index target,
                          const std::vector<std::array<Index, 2>>& ends) {
  const auto outgoing = topology.outgoing(vertex);
  for (std::size_t i = 0; i < outgoing.size(); ++i) {
    if (ends[at(topology.edge(outgoing[i]))] ==
        std::array<Index, 2>{std::min(vertex, target), std::max(vertex, target)}) {
      return i;
    }
  }
  return outgoing.size();
}

}  // namespace

Result<std::vector<Index>> seam_between(const TriangleMesh& mesh, const MeshTopology& topology,
                                        const BoundaryLoop& from, const BoundaryLoop& to) {
  auto path = shortest_edge_path(mesh, topology, from.vertices, to.vertices);
  if (!path) return tl::unexpected(path.error());
  std::vector<Index> out;
  for (const SurfacePoint& p : *path) out.push_back(p.a);
  return out;
}

std::vector<std::array<double, 3>> seam_jump(const MeshTopology& topology, std::span<const Index> seam) {
  VOLUTE_CHECK(seam.size() >= 2, seam.size());
  std::vector<std::array<double, 3>> jump(at(topology.triangle_count()), std::array<double, 3>{});
  // Ends of the edges at the seam's vertices, from the seam itself: the topology keeps no vertices of edges.
  std::vector<std::array<Index, 2>> ends(at(topology.edge_count()), {geometry::no_index, geometry::no_index});
  for (std::size_t i = 0; i + 1 < seam.size(); ++i) {
    bool found = false;
    for (Index h : topology.outgoing(seam[i])) {
      for (Index other : topology.outgoing(seam[i + 1])) {
        if (topology.opposite(h) != other) continue;
        ends[at(topology.edge(h))] = {std::min(seam[i], seam[i + 1]), std::max(seam[i], seam[i + 1])};
        found = true;
      }
    }
    VOLUTE_CHECK(found, seam[i], seam[i + 1]);
  }
  for (std::size_t i = 0; i < seam.size(); ++i) {
    const bool at_end = i == 0 || i + 1 == seam.size();
    if (at_end && !topology.is_boundary_vertex(seam[i])) continue;
    const auto outgoing = topology.outgoing(seam[i]);
    // Left of the seam: counter-clockwise from the edge that goes on (from the boundary at the last vertex)
    // to the edge that comes in (to the boundary at the first).
    const std::size_t count = outgoing.size();
    const std::size_t begin = i + 1 < seam.size() ? edge_position(topology, seam[i], seam[i + 1], ends) : 0;
    std::size_t end = i > 0 ? edge_position(topology, seam[i], seam[i - 1], ends) : count;
    if (end < begin) end += count;
    for (std::size_t p = begin; p < end; ++p) {
      const Index corner = outgoing[p % count];
      jump[at(corner / 3)][at(corner % 3)] = 1.0;
    }
  }
  return jump;
}

Result<PeriodicCoordinate> periodic_harmonic(const TriangleMesh& mesh, const MeshTopology& topology,
                                             std::span<const Index> seam) {
  const auto operators = triangle_operators(mesh);
  return periodic_harmonic(mesh, topology, operators, cotan_laplacian(mesh, operators), seam);
}

Result<PeriodicCoordinate> periodic_harmonic(const TriangleMesh& mesh, const MeshTopology& topology,
                                             std::span<const TriangleOperator> operators, const SparseMatrix& laplacian,
                                             std::span<const Index> seam) {
  PeriodicCoordinate out;
  out.jump = seam_jump(topology, seam);
  out.seam.assign(seam.begin(), seam.end());
  std::vector<Vec2> jump_gradient(mesh.triangles.size());
  for (std::size_t t = 0; t < jump_gradient.size(); ++t) {
    jump_gradient[t] = operators[t].gradient(out.jump[t][0], out.jump[t][1], out.jump[t][2]);
  }
  const auto load = divergence(mesh, operators, jump_gradient);
  const Eigen::VectorXd right = -Eigen::Map<const Eigen::VectorXd>(load.data(), static_cast<Eigen::Index>(load.size()));
  const std::array<int, 1> fixed = {seam.front()};
  auto solved = solve_with_fixed(laplacian, fixed, Eigen::MatrixXd::Zero(1, 1), right);
  if (!solved) return tl::unexpected(solved.error());
  out.vertex.assign(solved->data(), solved->data() + solved->size());
  return out;
}

}  // namespace volute::planner
