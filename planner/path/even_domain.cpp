#include "planner/path/even_domain.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/even_resample.hpp"
#include "planner/surface/cut.hpp"
#include "planner/surface/slice_path.hpp"
#include "planner/surface/sparse_solver.hpp"
#include "planner/surface/tied_matrix.hpp"

namespace volute::planner {
namespace {

using geometry::at;
using geometry::BoundaryLoop;
using geometry::MeshTopology;

/// The surface while arms are laid into it, one after another.
struct Opened {
  TriangleMesh mesh;
  std::vector<Vec3> normals;
  std::vector<Mat3> curvature;
  std::vector<std::vector<Index>> slits;
};

using EdgeSet = std::set<std::array<Index, 2>>;

std::array<Index, 2> edge_of(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// The part of an arm's path behind the last point that lies on what is cut already. Where that point lies inside a cut
/// edge the arm starts at the end of it that does not share an edge with the next point.
SurfacePath behind_last_touch(const SurfacePath& path, const std::set<Index>& cut_vertices, const EdgeSet& cut_edges) {
  for (std::size_t i = path.size() - 1; i-- > 0;) {
    const SurfacePoint& p = path[i];
    const SurfacePoint& next = path[i + 1];
    const bool crosses = !p.is_vertex() && cut_edges.contains(edge_of(p.a, p.b));
    if (!crosses && !(p.is_vertex() && cut_vertices.contains(p.a))) continue;
    SurfacePath out{p};
    if (crosses) out.front() = SurfacePoint::vertex(next.touches(p.a) ? p.b : p.a);
    out.insert(out.end(), path.begin() + static_cast<std::ptrdiff_t>(i) + 1, path.end());
    return out;
  }
  return path;
}

/// Lays one arm into the mesh; nothing is cut yet.
Result<void> lay_arm(Opened& opened, const Arm& arm, std::set<Index>& cut_vertices, EdgeSet& cut_edges) {
  if (cut_vertices.contains(arm.to))
    return {};  // an earlier arm runs through it: a second way there would close a ring
  const auto topology = MeshTopology::build(opened.mesh);
  if (!topology) return tl::unexpected(topology.error());
  const auto bridge = bridge_path(opened.mesh, *topology, opened.normals, arm.from, arm.to);
  if (!bridge) return tl::unexpected(bridge.error());
  const SurfacePath path = behind_last_touch(bridge->path, cut_vertices, cut_edges);
  MeshWithPath laid = insert_path(opened.mesh, path);
  opened.normals.resize(laid.mesh.vertices_mm.size());
  for (std::size_t i = 0; i < laid.vertices.size(); ++i) {
    const SurfacePoint& p = path[i];
    if (p.is_vertex()) continue;
    opened.normals[at(laid.vertices[i])] =
        ((1.0 - p.t) * opened.normals[at(p.a)] + p.t * opened.normals[at(p.b)]).normalized();
  }
  std::vector<Mat3> curvature;
  for (Index parent : laid.parent) curvature.push_back(opened.curvature[at(parent)]);
  opened.curvature = std::move(curvature);
  opened.mesh = std::move(laid.mesh);
  for (std::size_t i = 0; i < laid.vertices.size(); ++i) {
    cut_vertices.insert(laid.vertices[i]);
    if (i > 0) cut_edges.insert(edge_of(laid.vertices[i - 1], laid.vertices[i]));
  }
  opened.slits.push_back(std::move(laid.vertices));
  return {};
}

/// The surface cut open along all arms of the centre.
Result<Opened> open_along(const EvenSurface& surface, const Centre& centre) {
  Opened out{surface.mesh, surface.vertex_normals, surface.curvature, {}};
  std::set<Index> cut_vertices;
  EdgeSet cut_edges;
  if (centre.has_loop()) {
    const auto& loop = surface.topology.boundary_loops()[at(centre.loop)].vertices;
    cut_vertices.insert(loop.begin(), loop.end());
  }
  const auto& loops = surface.topology.boundary_loops();
  for (const Arm& arm : centre.arms) {
    VOLUTE_CHECK(arm.from != arm.to, arm.from);
    if (auto laid = lay_arm(out, arm, cut_vertices, cut_edges); !laid) return tl::unexpected(laid.error());
    // A hole at either end is part of the centre from now on: a second way there would close a ring.
    for (std::size_t l = 1; l < loops.size(); ++l) {
      const auto& v = loops[l].vertices;
      if (std::any_of(v.begin(), v.end(), [&](Index i) { return i == arm.from || i == arm.to; }))
        cut_vertices.insert(v.begin(), v.end());
    }
  }
  if (!centre.has_loop() && cut_edges.size() < 2) {
    return geometry::bad_input("surface-slit-short",
                               "vertices " + std::to_string(centre.arms.front().from) + " and " +
                                   std::to_string(centre.arms.front().to) +
                                   " are neighbours: a slit needs two edges to open; refine the mesh there");
  }
  const auto topology = MeshTopology::build(out.mesh);
  if (!topology) return tl::unexpected(topology.error());
  CutMesh cut = cut_open(out.mesh, *topology, out.slits);
  std::vector<Vec3> normals;
  for (Index original : cut.original) normals.push_back(out.normals[at(original)]);
  out.mesh = std::move(cut.mesh);
  out.normals = std::move(normals);
  return out;
}

bool holds_any(const BoundaryLoop& loop, const std::vector<char>& marked) {
  return std::any_of(loop.vertices.begin(), loop.vertices.end(), [&](Index v) { return marked[at(v)] != 0; });
}

/// Names the loops by what they were on the surface: the outer one and the centre by their vertices.
void assign_loops(const EvenSurface& surface, const Centre& centre, EvenDomain& domain) {
  const auto& before = surface.topology.boundary_loops();
  std::vector<char> is_outer(domain.mesh.vertices_mm.size(), 0), is_centre(domain.mesh.vertices_mm.size(), 0);
  for (Index v : before[0].vertices) is_outer[at(v)] = 1;
  if (centre.has_loop()) {
    for (Index v : before[at(centre.loop)].vertices) is_centre[at(v)] = 1;
  }
  for (const auto& slit : domain.slits) {
    for (Index v : slit) is_centre[at(v)] = 1;
  }
  for (const BoundaryLoop& loop : domain.topology.boundary_loops()) {
    if (holds_any(loop, is_outer)) {
      domain.outer = loop;
    } else if (holds_any(loop, is_centre)) {
      domain.centre = loop;
    } else {
      domain.floating.push_back(loop);
    }
  }
}

/// Harmonic slit map: 0 on the outer loop, 1 on the centre, an unknown constant on each floating hole.
Result<std::vector<double>> harmonic_of(const EvenDomain& domain, const SparseMatrix& laplacian) {
  std::vector<int> unknown(domain.mesh.vertices_mm.size(), -1);
  int count = 2;  // 0: the outer loop, 1: the centre
  for (Index v : domain.outer.vertices) unknown[at(v)] = 0;
  for (Index v : domain.centre.vertices) unknown[at(v)] = 1;
  for (const BoundaryLoop& loop : domain.floating) {
    for (Index v : loop.vertices) unknown[at(v)] = count;
    ++count;
  }
  for (int& u : unknown) u = u < 0 ? count++ : u;
  const std::array<int, 2> fixed = {0, 1};
  const auto solved = solve_with_fixed(tied(laplacian, Ties(unknown, count)), fixed, Eigen::Vector2d(0.0, 1.0));
  if (!solved) return tl::unexpected(solved.error());
  std::vector<double> out;
  out.reserve(unknown.size());
  for (const int u : unknown) out.push_back((*solved)(u, 0));
  return out;
}

/// theta with its growth gathered into `ramp_share` of the turn outside, harmonic from the middle of the map inward.
void gather_growth(EvenDomain& domain, double ramp_share) {
  if (ramp_share >= 1.0) return;
  for (std::size_t v = 0; v < domain.theta.vertex.size(); ++v) {
    double& theta = domain.theta.vertex[v];
    const double whole = std::floor(theta), share = theta - whole;
    const double x = std::clamp((share - 0.5) / ramp_share + 0.5, 0.0, 1.0);
    const double gathered = whole + x * x * (3.0 - 2.0 * x);
    const double outside = std::max(0.0, 1.0 - 2.0 * domain.harmonic[v]);
    theta += outside * outside * (gathered - theta);
  }
}

}  // namespace

Result<EvenSurface> EvenSurface::build(const TriangleMesh& given) {
  TriangleMesh mesh = in_memory_order(given);
  auto topology = MeshTopology::build(mesh);
  if (!topology) return tl::unexpected(topology.error());
  auto normals = geometry::vertex_normals(mesh);
  auto curvature = geometry::triangle_curvature(mesh);
  return EvenSurface{std::move(mesh), std::move(*topology), std::move(normals), std::move(curvature)};
}

Result<EvenSurface> EvenSurface::refined(double edge_max_mm) const {
  auto fine = finer(mesh, edge_max_mm);
  if (!fine) return tl::unexpected(fine.error());
  auto fine_topology = MeshTopology::build(fine->mesh);
  if (!fine_topology) return tl::unexpected(fine_topology.error());
  EvenSurface out{std::move(fine->mesh), std::move(*fine_topology), vertex_normals, {}};
  for (const auto& [a, b] : fine->ends) {
    out.vertex_normals.push_back((out.vertex_normals[at(a)] + out.vertex_normals[at(b)]).normalized());
  }
  for (Index parent : fine->parent) out.curvature.push_back(curvature[at(parent)]);
  return out;
}

Result<EvenDomain> even_domain(const EvenSurface& surface, const Centre& centre, double ramp_share) {
  VOLUTE_CHECK(ramp_share > 0.0 && ramp_share <= 1.0, ramp_share);
  VOLUTE_CHECK(centre.has_loop() || !centre.arms.empty(), centre.loop, centre.arms.size());
  auto opened = open_along(surface, centre);
  if (!opened) return tl::unexpected(opened.error());
  auto topology = MeshTopology::build(opened->mesh);
  if (!topology) return tl::unexpected(topology.error());
  EvenDomain out;
  out.slits = std::move(opened->slits);
  out.mesh = std::move(opened->mesh);
  out.topology = std::move(*topology);
  out.vertex_normals = std::move(opened->normals);
  out.curvature = std::move(opened->curvature);
  out.operators = triangle_operators(out.mesh);
  assign_loops(surface, centre, out);
  VOLUTE_CHECK(!out.outer.vertices.empty() && !out.centre.vertices.empty(), out.outer.vertices.size(),
               out.centre.vertices.size());
  auto seam = seam_between(out.mesh, out.topology, out.outer, out.centre);
  if (!seam) return tl::unexpected(seam.error());
  const SparseMatrix laplacian = cotan_laplacian(out.mesh, out.operators);
  Result<PeriodicCoordinate> theta{};
  Result<std::vector<double>> harmonic{};
  tbb::parallel_invoke([&] { theta = periodic_harmonic(out.mesh, out.topology, out.operators, laplacian, *seam); },
                       [&] { harmonic = harmonic_of(out, laplacian); });
  if (!theta) return tl::unexpected(theta.error());
  out.theta = std::move(*theta);
  if (!harmonic) return tl::unexpected(harmonic.error());
  out.harmonic = std::move(*harmonic);
  gather_growth(out, ramp_share);
  return out;
}

}  // namespace volute::planner
