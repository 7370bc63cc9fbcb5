#include <limits>

#include "geometry/mesh_formats.hpp"
#include "geometry/polygon.hpp"
#include "geometry/text_cursor.hpp"

namespace volute::geometry {

namespace {

/// The next word that is no comment, not eaten.
void skip_comments(TextCursor& cursor) {
  while (cursor.peek().starts_with('#')) {
    cursor.word();
    cursor.rest_of_line();
  }
}

/// A count that every following row of at least two bytes an entry could hold.
Result<std::int64_t> read_count(TextCursor& cursor, const std::string& name, const char* what,
                                std::int64_t least_row_bytes) {
  const auto count = cursor.integer(name, what);
  if (!count) return count;
  if (*count < 0 || *count > static_cast<std::int64_t>(cursor.left()) / least_row_bytes + 1)
    return bad_input("mesh-count-impossible", place(name, cursor) + what + " is " + std::to_string(*count) + " and " +
                                                  std::to_string(cursor.left()) +
                                                  " bytes follow, which cannot hold it; copy or export it again");
  return count;
}

Result<void> read_vertices(TextCursor& cursor, const std::string& name, std::int64_t count, TriangleMesh& mesh) {
  mesh.vertices_mm.reserve(static_cast<std::size_t>(count));
  for (std::int64_t v = 0; v < count; ++v) {
    skip_comments(cursor);
    Vec3 point;
    for (int k = 0; k < 3; ++k) {
      const auto value = cursor.number(name, "a coordinate");
      if (!value) return tl::unexpected(value.error());
      point[k] = *value;
    }
    mesh.vertices_mm.push_back(point);
    cursor.rest_of_line();  // colours and normals of COFF and NOFF
  }
  return {};
}

Result<void> read_off_face(TextCursor& cursor, const std::string& name, TriangleMesh& mesh,
                           std::vector<Index>& corners) {
  skip_comments(cursor);
  const auto sides = cursor.integer(name, "the number of corners of a face");
  if (!sides) return tl::unexpected(sides.error());
  corners.clear();
  for (std::int64_t k = 0; k < *sides && k <= static_cast<std::int64_t>(most_polygon_corners); ++k) {
    const auto corner = cursor.integer(name, "a vertex number");
    if (!corner) return tl::unexpected(corner.error());
    const bool fits = *corner >= 0 && *corner <= std::numeric_limits<Index>::max();
    corners.push_back(fits ? static_cast<Index>(*corner) : no_index);
  }
  if (auto sound = check_polygon(corners, mesh.vertices_mm.size(), place(name, cursor)); !sound) return sound;
  append_polygon(mesh, corners);
  cursor.rest_of_line();
  return {};
}

}  // namespace

Result<TriangleMesh> parse_off(std::string_view bytes, const std::string& name) {
  TextCursor cursor(bytes);
  const std::string_view magic = cursor.word();
  if (magic != "OFF" && magic != "COFF" && magic != "NOFF" && magic != "CNOFF")
    return bad_input("mesh-format-unknown", place(name, cursor) + "OFF variant \"" + std::string(magic) +
                                                "\" is not read; export OFF, PLY or STL");
  if (same_word(cursor.peek(), "binary"))
    return bad_input("mesh-format-unknown",
                     place(name, cursor) + "binary OFF is not read; export text OFF, PLY or STL");
  skip_comments(cursor);
  const auto vertices = read_count(cursor, name, "the number of vertices", 6);
  if (!vertices) return tl::unexpected(vertices.error());
  const auto faces = read_count(cursor, name, "the number of faces", 8);
  if (!faces) return tl::unexpected(faces.error());
  cursor.rest_of_line();  // the number of edges: may be wrong or absent, and nothing depends on it
  TriangleMesh mesh;
  if (auto read = read_vertices(cursor, name, *vertices, mesh); !read) return tl::unexpected(read.error());
  std::vector<Index> corners;
  for (std::int64_t f = 0; f < *faces; ++f)
    if (auto read = read_off_face(cursor, name, mesh, corners); !read) return tl::unexpected(read.error());
  if (mesh.triangles.empty()) return bad_input("mesh-empty", name + ": the file has no face; export the surface again");
  return mesh;
}

}  // namespace volute::geometry
