#include "planner/surface/centre_slit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/surface/operators.hpp"
#include "planner/surface/slice_path.hpp"
#include "planner/surface/sparse_solver.hpp"

namespace volute::planner {

using geometry::at;
using geometry::bad_input;
using geometry::MeshTopology;
using geometry::next_halfedge;

namespace {

constexpr double deep_share = 0.9;  ///< of the greatest depth
constexpr double slit_share = 0.8;  ///< of the focal segment

/// -Laplace(u) = 1, u = 0 on the boundary; mm^2.
Result<Eigen::VectorXd> depth_of(const TriangleMesh& mesh, const MeshTopology& topology) {
  std::vector<int> fixed;
  for (Index v = 0; v < topology.vertex_count(); ++v)
    if (topology.is_boundary_vertex(v)) fixed.push_back(v);
  const std::vector<double> area = vertex_areas_mm2(mesh);
  const Eigen::MatrixXd load = Eigen::Map<const Eigen::VectorXd>(area.data(), static_cast<Eigen::Index>(area.size()));
  const auto zero = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(fixed.size()), 1);
  auto depth = solve_with_fixed(cotan_laplacian(mesh), fixed, zero, load);
  if (!depth) return tl::unexpected(depth.error());
  return Eigen::VectorXd(depth->col(0));
}

/// Centre and half slit (a vector from the centre to one end) of the deep part.
struct SlitLine {
  Vec3 centre_mm, half_mm;
};
SlitLine slit_line(const TriangleMesh& mesh, const Eigen::VectorXd& depth) {
  const std::vector<double> area = vertex_areas_mm2(mesh);
  const double deep = deep_share * depth.maxCoeff();
  double weight = 0.0;
  Vec3 centre = Vec3::Zero();
  geometry::Mat3 second = geometry::Mat3::Zero();
  for (std::size_t v = 0; v < area.size(); ++v) {
    if (depth[static_cast<Eigen::Index>(v)] < deep) continue;
    weight += area[v];
    centre += area[v] * mesh.vertices_mm[v];
    second += area[v] * mesh.vertices_mm[v] * mesh.vertices_mm[v].transpose();
  }
  centre /= weight;
  const Eigen::SelfAdjointEigenSolver<geometry::Mat3> axes(
      geometry::Mat3(second / weight - centre * centre.transpose()));
  // An ellipse with half axes a, b has variances a^2/4, b^2/4; the deep part is the surface scaled by sqrt(1 -
  // deep_share).
  const double scale = 2.0 / std::sqrt(1.0 - deep_share);
  const double a = scale * std::sqrt(std::max(axes.eigenvalues()[2], 0.0)),
               b = scale * std::sqrt(std::max(axes.eigenvalues()[1], 0.0));
  const double half = a > 0.0 ? slit_share * (a * a - b * b) / a : 0.0;
  return {centre, half * axes.eigenvectors().col(2)};
}

/// The inner vertex nearest to a point, among those deeper than half.
Index nearest_deep_vertex(const TriangleMesh& mesh, const Eigen::VectorXd& depth, const Vec3& point) {
  Index best = geometry::no_index;
  double best_sq = 0.0;
  for (Index v = 0; v < static_cast<Index>(mesh.vertices_mm.size()); ++v) {
    if (depth[v] < 0.5 * depth.maxCoeff()) continue;
    const double distance_sq = (mesh.vertices_mm[at(v)] - point).squaredNorm();
    if (best != geometry::no_index && distance_sq >= best_sq) continue;
    best = v;
    best_sq = distance_sq;
  }
  return best;
}

/// Two edges through the deepest vertex that has only inner neighbours, as straight as they come.
Result<SurfacePath> two_edges(const TriangleMesh& mesh, const MeshTopology& topology, const Eigen::VectorXd& depth) {
  Index middle = geometry::no_index;
  std::vector<Index> ring;
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (middle != geometry::no_index && depth[v] <= depth[middle]) continue;
    std::vector<Index> around;
    for (Index h : topology.outgoing(v)) around.push_back(mesh.triangles[at(h / 3)][at(next_halfedge(h) % 3)]);
    const auto on_boundary = [&](Index w) { return topology.is_boundary_vertex(w); };
    if (on_boundary(v) || std::any_of(around.begin(), around.end(), on_boundary)) continue;
    middle = v;
    ring = around;
  }
  if (middle == geometry::no_index)
    return bad_input("surface-too-coarse",
                     "no vertex of the surface lies two edges inside: a spiral has no centre; refine the mesh");
  SurfacePath best{SurfacePoint::vertex(ring[0]), SurfacePoint::vertex(middle), SurfacePoint::vertex(ring[1])};
  double straightest = 2.0;
  for (Index a : ring)
    for (Index b : ring) {
      const Vec3 u = mesh.vertices_mm[at(a)] - mesh.vertices_mm[at(middle)],
                 w = mesh.vertices_mm[at(b)] - mesh.vertices_mm[at(middle)];
      const double cosine = u.normalized().dot(w.normalized());
      if (a == b || cosine >= straightest) continue;
      straightest = cosine;
      best = {SurfacePoint::vertex(a), SurfacePoint::vertex(middle), SurfacePoint::vertex(b)};
    }
  return best;
}

}  // namespace

Result<SurfacePath> centre_slit(const TriangleMesh& mesh, const MeshTopology& topology) {
  const auto depth = depth_of(mesh, topology);
  if (!depth) return tl::unexpected(depth.error());
  const SlitLine line = slit_line(mesh, *depth);
  const Index from = nearest_deep_vertex(mesh, *depth, line.centre_mm - line.half_mm);
  const Index to = nearest_deep_vertex(mesh, *depth, line.centre_mm + line.half_mm);
  if (from != to) {
    const auto path = bridge_path(mesh, topology, geometry::vertex_normals(mesh), from, to);
    if (path && path->path.size() >= 3) return path->path;
  }
  return two_edges(mesh, topology, *depth);
}

}  // namespace volute::planner
