// The parsers behind load_mesh, each from the bytes of a whole file. Internal to `geometry`.
#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh.hpp"

namespace volute::geometry {

/// `name` opens every message. Corners of STL triangles are not joined; polygons of the other formats are split into
/// triangles.
Result<TriangleMesh> parse_stl_binary(std::string_view bytes, const std::string& name);
Result<TriangleMesh> parse_stl_ascii(std::string_view bytes, const std::string& name);
Result<TriangleMesh> parse_ply(std::string_view bytes, const std::string& name);
Result<TriangleMesh> parse_off(std::string_view bytes, const std::string& name);
Result<TriangleMesh> parse_obj(std::string_view bytes, const std::string& name);

/// True when the header's count fits the size exactly: then it is binary, whatever its first letters say.
bool is_exact_stl_binary(std::string_view bytes);

}  // namespace volute::geometry
