#include <algorithm>
#include <array>
#include <limits>

#include "geometry/mesh_formats.hpp"
#include "geometry/number_text.hpp"
#include "geometry/polygon.hpp"
#include "geometry/text_cursor.hpp"

namespace volute::geometry {

namespace {

/// Statements that say nothing about the triangles. Anything else is damage.
constexpr std::array<std::string_view, 33> ignored_statements = {
    "vt",     "vn",  "vp",   "l",     "p",        "g",        "o",    "s",      "mg",     "usemtl",     "mtllib",
    "cstype", "deg", "bmat", "step",  "curv",     "curv2",    "surf", "parm",   "trim",   "hole",       "scrv",
    "sp",     "end", "con",  "bevel", "c_interp", "d_interp", "lod",  "maplib", "usemap", "shadow_obj", "trace_obj"};

/// A face of an OBJ file may come before its vertices are complete, so faces are kept and split at the end.
struct Face {
  std::size_t line = 0, first = 0, count = 0;
};

struct ObjText {
  TriangleMesh mesh;
  std::vector<Index> corners;
  std::vector<Face> faces;
};

std::string line_place(const std::string& name, std::size_t line) { return name + ":" + std::to_string(line) + ": "; }

Result<void> read_vertex(TextCursor& cursor, const std::string& name, ObjText& text) {
  Vec3 point;
  for (int k = 0; k < 3; ++k) {
    const auto value = cursor.number(name, "a coordinate");
    if (!value) return tl::unexpected(value.error());
    point[k] = *value;
  }
  text.mesh.vertices_mm.push_back(point);
  return {};
}

/// "7", "7/2", "7//3", "-1": the vertex number in front of the first slash, from 1, or back from the latest.
Index corner_index(std::string_view word, std::size_t vertices) {
  const auto number = parse_integer(word.substr(0, word.find('/')));
  const auto known = static_cast<std::int64_t>(vertices);
  if (!number || *number == 0) return no_index;
  const std::int64_t index = *number > 0 ? *number - 1 : known + *number;
  return index >= 0 && index < std::numeric_limits<Index>::max() ? static_cast<Index>(index) : no_index;
}

Result<void> read_obj_face(TextCursor& cursor, std::size_t line, const std::string& name, ObjText& text) {
  Face face{line, text.corners.size(), 0};
  for (std::string_view word = cursor.word(); !word.empty() && !word.starts_with('#'); word = cursor.word()) {
    const Index corner = corner_index(word, text.mesh.vertices_mm.size());
    if (corner == no_index)
      return bad_input("mesh-syntax", line_place(name, line) + "\"" + std::string(word.substr(0, 24)) +
                                          "\" is no vertex number; export the file again");
    text.corners.push_back(corner);
    ++face.count;
  }
  text.faces.push_back(face);
  return {};
}

Result<void> read_statement(std::string_view line_text, std::size_t line, const std::string& name, ObjText& text) {
  TextCursor cursor(line_text, line, true);
  const std::string_view keyword = cursor.word();
  if (keyword.empty() || keyword.starts_with('#')) return {};
  if (keyword == "v") return read_vertex(cursor, name, text);
  if (keyword == "f") return read_obj_face(cursor, line, name, text);
  if (std::find(ignored_statements.begin(), ignored_statements.end(), keyword) != ignored_statements.end()) return {};
  return bad_input("mesh-syntax", line_place(name, line) +
                                      "no OBJ statement begins so; the file is damaged or no OBJ, export it again");
}

}  // namespace

Result<TriangleMesh> parse_obj(std::string_view bytes, const std::string& name) {
  ObjText text;
  TextCursor lines(bytes);
  std::string joined;
  for (std::size_t line = 1; lines.left() > 0; ++line) {
    std::string_view statement = lines.rest_of_line();
    const std::size_t first_line = line;
    joined.clear();
    while (statement.ends_with('\\') || statement.ends_with("\\\r")) {
      joined.append(statement.substr(0, statement.rfind('\\')));
      joined.push_back(' ');
      statement = lines.rest_of_line();
      ++line;
    }
    if (!joined.empty()) statement = joined.append(statement);
    if (auto read = read_statement(statement, first_line, name, text); !read) return tl::unexpected(read.error());
  }
  for (const Face& face : text.faces) {
    const std::span<const Index> corners(text.corners.data() + face.first, face.count);
    if (auto sound = check_polygon(corners, text.mesh.vertices_mm.size(), line_place(name, face.line)); !sound)
      return tl::unexpected(sound.error());
    append_polygon(text.mesh, corners);
  }
  if (text.mesh.triangles.empty())
    return bad_input("mesh-empty", name + ": the file has no face; export the surface again");
  return std::move(text.mesh);
}

}  // namespace volute::geometry
