// Splits polygons of mesh files into triangles. Internal to `geometry`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"

namespace volute::geometry {

/// More corners than this in one face of a file is taken for damage.
constexpr std::size_t most_polygon_corners = 256;

/// Appends the polygon `corners` to mesh.triangles by ear clipping in its mean plane; of all ears the one with the
/// greatest least angle goes first, and the last four corners are cut along their better diagonal. A polygon without a
/// proper ear is cut as a fan. Requires: 3 <= corners.size() <= most_polygon_corners, corners in range.
void append_polygon(TriangleMesh& mesh, std::span<const Index> corners);

/// mesh-index-out-of-range when a corner lies outside [0, vertices), mesh-syntax when their number is not fit for a
/// face.
Result<void> check_polygon(std::span<const Index> corners, std::size_t vertices, const std::string& place);

}  // namespace volute::geometry
