#include "planner/surface/annulus.hpp"

#include <algorithm>
#include <array>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "geometry/number_text.hpp"
#include "planner/surface/centre_slit.hpp"
#include "planner/surface/cut.hpp"
#include "planner/surface/slice_path.hpp"

namespace volute::planner {

using geometry::at;
using geometry::bad_input;
using geometry::BoundaryLoop;
using geometry::MeshTopology;
using geometry::no_index;

namespace {

/// A mesh that is cut step by step; `root` leads back to the vertices of the uncut surface.
struct CutState {
  TriangleMesh mesh;
  std::vector<Index> root;
  Index root_count = 0;

  explicit CutState(const TriangleMesh& surface)
      : mesh(surface), root_count(static_cast<Index>(surface.vertices_mm.size())) {
    for (Index v = 0; v < root_count; ++v) root.push_back(v);
  }
  /// Returns the path as vertices of the mesh.
  std::vector<Index> insert(const SurfacePath& path) {
    MeshWithPath with_path = insert_path(mesh, path);
    mesh = std::move(with_path.mesh);
    while (root.size() < mesh.vertices_mm.size()) root.push_back(root_count++);
    return with_path.vertices;
  }
  Result<void> cut(const std::vector<Index>& chain) {
    const auto topology = MeshTopology::build(mesh);
    if (!topology) return tl::unexpected(topology.error());
    CutMesh opened = cut_open(mesh, *topology, std::span(&chain, 1));
    for (std::size_t v = root.size(); v < opened.original.size(); ++v) root.push_back(root[at(opened.original[v])]);
    mesh = std::move(opened.mesh);
    return {};
  }
  [[nodiscard]] std::vector<Index> roots_of(const std::vector<Index>& chain) const {
    std::vector<Index> result;
    for (Index v : chain) result.push_back(root[at(v)]);
    return result;
  }
};

Result<void> check_topology(const MeshTopology& topology, const AnnulusOptions& options) {
  const auto& components = topology.components();
  if (components.size() != 1)
    return bad_input("surface-several-components",
                     "the surface has " + std::to_string(components.size()) +
                         " components: a path covers one; choose one with the component key");
  if (components[0].handles > 0)
    return bad_input("surface-handles", "the surface has " + std::to_string(components[0].handles) +
                                            " handles: it cannot be laid flat by joining holes; cut it into patches");
  if (topology.boundary_loops().empty())
    return bad_input("surface-closed",
                     "the surface has no boundary: a path has nowhere to start; cut it open or select a patch");
  const auto loops = static_cast<int>(topology.boundary_loops().size());
  if (options.centre_loop >= loops || options.centre_loop == 0)
    return bad_input("surface-centre-loop", "centre loop " + std::to_string(options.centre_loop) +
                                                " is not a hole: the surface has holes 1 to " +
                                                std::to_string(loops - 1) + " (0 is the outer boundary)");
  return {};
}

/// Joins the boundaries; keeps which curve every root vertex lies on.
class BoundaryJoiner {
 public:
  BoundaryJoiner(CutState& state, const std::vector<BoundaryLoop>& curves, Annulus& out)
      : state_(state), curves_(curves), out_(out) {
    curve_of_root_.assign(state.root.size(), no_index);
    for (std::size_t c = 0; c < curves.size(); ++c)
      for (Index v : curves[c].vertices) curve_of_root_[at(v)] = static_cast<Index>(c);
  }

  /// Bridges from hole to hole, nearest first, starting with `first`; each is cut open at once, so that no bridge meets
  /// another.
  Result<void> join_holes(Index first) {
    std::vector<char> joined(curves_.size(), 0);
    joined[0] = 1;  // the outer boundary is joined by the seam alone, at the end
    joined[at(first)] = 1;
    for (std::size_t count = 2; count < curves_.size(); ++count) {
      std::vector<Index> sources, targets;
      for (Index v = 0; v < static_cast<Index>(state_.root.size()); ++v) {
        const Index curve = free_curve(v);
        if (curve <= 0) continue;
        (joined[at(curve)] ? sources : targets).push_back(v);
      }
      const auto chain = bridge(sources, targets);
      if (!chain) return tl::unexpected(chain.error());
      joined[at(out_.bridges.back().to_curve)] = 1;
      if (auto cut = state_.cut(*chain); !cut) return cut;
    }
    return {};
  }

  /// The bridge from the outer boundary to a set of inner vertices: inserted, not cut.
  Result<std::vector<Index>> bridge(const std::vector<Index>& sources, const std::vector<Index>& targets) {
    const auto topology = MeshTopology::build(state_.mesh);
    if (!topology) return tl::unexpected(topology.error());
    const auto nearest = shortest_edge_path(state_.mesh, *topology, sources, targets);
    if (!nearest) return tl::unexpected(nearest.error());
    const auto normals = geometry::vertex_normals(state_.mesh);
    const auto path = bridge_path(state_.mesh, *topology, normals, nearest->front().a, nearest->back().a);
    if (!path) return tl::unexpected(path.error());
    const std::vector<Index> chain = state_.insert(path->path);
    Bridge made{curve_of(chain.front()), curve_of(chain.back()), state_.roots_of(chain), path->sliced};
    if (!made.sliced)
      out_.notes.push_back("bridge " + std::to_string(out_.bridges.size()) +
                           " runs along edges: its slicing plane leaves the surface");
    for (Index end : {made.vertices.front(), made.vertices.back()}) used_.push_back(end);
    out_.bridges.push_back(std::move(made));
    return chain;
  }

  /// Vertices of curve `c` that no bridge uses.
  [[nodiscard]] std::vector<Index> free_vertices(Index c) const {
    std::vector<Index> result;
    for (Index v = 0; v < static_cast<Index>(state_.root.size()); ++v)
      if (free_curve(v) == c) result.push_back(v);
    return result;
  }

 private:
  [[nodiscard]] Index curve_of(Index v) const {
    const Index root = state_.root[at(v)];
    return at(root) < curve_of_root_.size() ? curve_of_root_[at(root)] : no_index;
  }
  [[nodiscard]] Index free_curve(Index v) const {
    const bool used = std::find(used_.begin(), used_.end(), state_.root[at(v)]) != used_.end();
    return used ? no_index : curve_of(v);
  }

  CutState& state_;
  const std::vector<BoundaryLoop>& curves_;
  Annulus& out_;
  std::vector<Index> curve_of_root_, used_;
};

/// The child of the outer boundary: chosen by the user, or by the distance along edges.
Result<Index> root_child(const TriangleMesh& mesh, const MeshTopology& topology, const AnnulusOptions& options) {
  if (options.centre_loop > 0) return static_cast<Index>(options.centre_loop);
  const auto& loops = topology.boundary_loops();
  Index best = 1;
  double best_mm = 0.0;
  for (std::size_t c = 1; c < loops.size(); ++c) {
    const auto path = shortest_edge_path(mesh, topology, loops[0].vertices, loops[c].vertices);
    if (!path) continue;  // shut in by other holes: it cannot be the first child
    const double distance_mm = length_mm(mesh, *path);
    const bool better = options.root_child == RootChild::nearest ? distance_mm < best_mm : distance_mm > best_mm;
    if (best_mm == 0.0 || better) {
      best = static_cast<Index>(c);
      best_mm = distance_mm;
    }
  }
  return best;
}

/// Cuts the surface into a ring; returns the seam as vertices of the ring.
Result<std::vector<Index>> cut_ring(CutState& state, const MeshTopology& topology, const AnnulusOptions& options,
                                    Annulus& out) {
  BoundaryJoiner joiner(state, out.curves, out);
  std::vector<Index> centre;
  if (out.curves.size() == 1) {
    const auto slit = centre_slit(state.mesh, topology);
    if (!slit) return tl::unexpected(slit.error());
    out.centre_is_slit = true;
    centre = state.insert(*slit);
    if (auto cut = state.cut(centre); !cut) return tl::unexpected(cut.error());
  } else {
    const auto child = root_child(state.mesh, topology, options);
    if (!child) return tl::unexpected(child.error());
    if (auto joined = joiner.join_holes(*child); !joined) return tl::unexpected(joined.error());
    centre = joiner.free_vertices(*child);
  }
  const auto seam = joiner.bridge(joiner.free_vertices(0), centre);
  if (seam) std::rotate(out.bridges.begin(), out.bridges.end() - 1, out.bridges.end());
  return seam;
}

/// Cuts the seam, mends the triangles along the cuts, and names the four sides.
Result<void> cut_sheet(const std::vector<Index>& seam, const AnnulusOptions& options, Annulus& out) {
  const auto topology = MeshTopology::build(out.ring);
  if (!topology) return tl::unexpected(topology.error());
  CutMesh opened = cut_open(out.ring, *topology, std::span(&seam, 1));
  out.sheet = std::move(opened.mesh);
  out.sheet_to_ring = std::move(opened.original);
  const auto flipped = flip_to_delaunay(out.sheet, options.condition);
  if (!flipped) return tl::unexpected(flipped.error());
  const auto chords = split_chords(out.sheet);
  if (!chords) return tl::unexpected(chords.error());
  out.edges_flipped += *flipped;
  out.chords_split += static_cast<Index>(chords->size());
  for (std::size_t c = 0; c < chords->size(); ++c) {
    out.sheet_to_ring.push_back(static_cast<Index>(out.ring_to_whole.size()));
    out.ring_to_whole.push_back(static_cast<Index>(out.whole.vertices_mm.size()));
    const Vec3& middle = out.sheet.vertices_mm[out.sheet_to_ring.size() - 1];
    out.ring.vertices_mm.push_back(middle);
    out.whole.vertices_mm.push_back(middle);
  }
  out.ring.triangles = out.whole.triangles = out.sheet.triangles;
  for (geometry::Triangle& t : out.ring.triangles)
    for (Index& v : t) v = out.sheet_to_ring[at(v)];
  for (std::size_t t = 0; t < out.whole.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) out.whole.triangles[t][k] = out.ring_to_whole[at(out.ring.triangles[t][k])];
  return {};
}

/// Splits the boundary loop of the sheet at the four corners, [Sun2016] Fig. 4.
Result<void> name_sides(const std::vector<Index>& seam, Annulus& out) {
  const auto topology = MeshTopology::build(out.sheet);
  if (!topology) return tl::unexpected(topology.error());
  VOLUTE_CHECK(topology->boundary_loops().size() == 1, topology->boundary_loops().size());
  const std::vector<Index>& loop = topology->boundary_loops()[0].vertices;
  const auto ring_vertex = [&](std::size_t i) { return out.sheet_to_ring[at(loop[i % loop.size()])]; };
  std::size_t start = 0;
  while (ring_vertex(start) != seam.front() || ring_vertex(start + 1) == seam[1]) ++start;
  const std::array<std::vector<Index>*, 4> sides = {&out.bottom, &out.right, &out.top, &out.left};
  const std::array<Index, 4> ends = {seam.front(), seam.back(), seam.back(), seam.front()};
  std::size_t i = start;
  for (std::size_t side = 0; side < 4; ++side) {
    sides[side]->push_back(loop[i % loop.size()]);
    do sides[side]->push_back(loop[++i % loop.size()]);
    while (ring_vertex(i) != ends[side]);
  }
  VOLUTE_CHECK(i == start + loop.size(), i, start, loop.size());
  std::reverse(out.top.begin(), out.top.end());
  std::reverse(out.left.begin(), out.left.end());
  for (Index v : out.bottom) out.outer.push_back(out.sheet_to_ring[at(v)]);
  for (Index v : out.top) out.inner.push_back(out.sheet_to_ring[at(v)]);
  out.outer.pop_back();
  out.inner.pop_back();
  return {};
}

void glue_whole(const CutState& state, Annulus& out) {
  out.ring = state.mesh;
  out.ring_to_whole = state.root;
  out.whole.vertices_mm.resize(at(state.root_count));
  for (std::size_t v = 0; v < state.root.size(); ++v)
    out.whole.vertices_mm[at(state.root[v])] = state.mesh.vertices_mm[v];
}

}  // namespace

Result<Annulus> make_annulus(const TriangleMesh& surface, const AnnulusOptions& options) {
  auto conditioned = condition(surface, options.condition);
  if (!conditioned) return tl::unexpected(conditioned.error());
  const auto topology = MeshTopology::build(conditioned->mesh);
  if (!topology) return tl::unexpected(topology.error());
  if (auto checked = check_topology(*topology, options); !checked) return tl::unexpected(checked.error());
  Annulus out;
  out.edges_flipped = conditioned->edges_flipped;
  out.edges_not_delaunay = conditioned->edges_not_delaunay;
  out.chords_split = conditioned->chords_split;
  out.curves = topology->boundary_loops();
  CutState state(conditioned->mesh);
  const auto seam = cut_ring(state, *topology, options, out);
  if (!seam) return tl::unexpected(seam.error());
  glue_whole(state, out);
  if (auto cut = cut_sheet(*seam, options, out); !cut) return tl::unexpected(cut.error());
  if (auto named = name_sides(*seam, out); !named) return tl::unexpected(named.error());
  out.seam = *seam;
  const std::vector<Vec3> normals = geometry::vertex_normals(out.whole);
  for (Index v : out.ring_to_whole) out.ring_normals.push_back(normals[at(v)]);
  return out;
}

}  // namespace volute::planner
