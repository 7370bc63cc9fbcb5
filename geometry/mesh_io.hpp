// Reading and writing meshes. Reading welds, cleans and repairs, and says what it did.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"

namespace volute::geometry {

/// What reading changed; each non-zero count also has a line in `warnings`.
struct MeshRepairs {
  Index vertices_welded = 0;  ///< joined though not bit-equal (bit-equal corners, which every STL has, are not counted)
  Index degenerate_triangles_removed =
      0;  ///< lower than the weld tolerance; a neighbour is split where one had held its edge
  Index duplicate_triangles_removed = 0;  ///< same three corners as an earlier triangle, in either sense
  Index triangles_turned = 0;             ///< orientation made consistent
  std::vector<std::string> warnings;
};

struct LoadedMesh {
  TriangleMesh mesh;
  MeshRepairs repairs;
};

/// The format is told by content first (binary or ASCII STL, PLY, OFF), then by the name's ending (OBJ).
/// `unit_mm`: length of one file unit in mm.
/// Errors (bad_input), each naming the file and where in it: file-missing, file-empty, mesh-format-unknown,
/// mesh-truncated, mesh-count-impossible (a count that the file cannot hold: checked before anything is allocated),
/// mesh-not-finite, mesh-syntax, mesh-index-out-of-range, mesh-empty. A mesh that is not a manifold is still returned:
/// MeshTopology::build names that.
Result<LoadedMesh> load_mesh(const std::filesystem::path& file, double unit_mm = 1.0);

/// Joins vertices closer than `tolerance_mm` (union-find over near pairs), drops degenerate and duplicate triangles and
/// unused vertices. tolerance_mm < 0: chosen from the mesh (1e-7 of the bounding box diagonal, at least the spacing of
/// floats there).
LoadedMesh weld(TriangleMesh soup, double tolerance_mm = -1.0);

/// Turns triangles so that neighbours agree, component by component (the majority keeps its side).
/// Returns the number turned, or mesh-not-orientable naming a triangle.
Result<Index> make_orientation_consistent(TriangleMesh& mesh);

/// Binary STL / binary PLY, written beside and renamed into place. Errors (system): file-not-written.
Result<void> save_stl(const std::filesystem::path& file, const TriangleMesh& mesh);
/// `colours`: none, or one RGB triple (0 to 255) a vertex; `quality`: none, or one double a vertex (property
/// "quality").
Result<void> save_ply(const std::filesystem::path& file, const TriangleMesh& mesh,
                      const std::vector<std::array<unsigned char, 3>>& colours = {},
                      const std::vector<double>& quality = {});

}  // namespace volute::geometry
