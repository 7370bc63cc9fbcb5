// Damage that leaves a file readable: found by what an STL says twice. Internal to `geometry`.
#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh.hpp"

namespace volute::geometry {

/// A binary STL stores each triangle's normal beside its corners. When nearly all of them fit, one that does not is
/// damage: mesh-damaged. When more than 1 % do not, the writer never computed them and nothing is said. Requires:
/// `soup` was read from `bytes`, triangle for triangle.
Result<void> check_stored_normals(std::string_view bytes, const TriangleMesh& soup, const std::string& name);

/// An STL stores each vertex once for every triangle there. When one copy was changed, its triangle hangs on by one
/// edge over a gap of four edges: mesh-damaged. A mesh that is no manifold is left to MeshTopology::build.
Result<void> check_torn(const TriangleMesh& welded, const std::string& name);

}  // namespace volute::geometry
