#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "geometry/mesh_formats.hpp"
#include "geometry/text_cursor.hpp"

namespace volute::geometry {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

constexpr std::size_t header_bytes = 84, record_bytes = 50;
/// Halfedges are numbered with Index.
constexpr std::uint64_t most_triangles = std::numeric_limits<Index>::max() / 3;

std::uint64_t claimed_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

/// A body that ends inside a record was cut; a whole number of records that is not the one claimed is a wrong count.
Result<void> check_count(std::string_view bytes, const std::string& name) {
  if (bytes.size() < header_bytes)
    return bad_input("mesh-truncated", name + ": " + std::to_string(bytes.size()) +
                                           " bytes are no STL (a binary one has a header of 84 bytes, a text one "
                                           "begins with \"solid\"); copy it again");
  const std::uint64_t claimed = claimed_triangles(bytes);
  const std::uint64_t body = bytes.size() - header_bytes, held = body / record_bytes;
  const std::string numbers = std::to_string(claimed) + " triangles and the file holds " + std::to_string(held);
  if (claimed > held && body % record_bytes != 0)
    return bad_input("mesh-truncated", name + ": cut off inside triangle " + std::to_string(held) +
                                           ": the header claims " + numbers + "; copy or export it again");
  if (claimed != held)
    return bad_input("mesh-count-impossible",
                     name + ": the header claims " + numbers + "; the file is damaged, copy or export it again");
  if (claimed == 0) return bad_input("mesh-empty", name + ": the STL has no triangle; export the surface again");
  if (claimed > most_triangles)
    return bad_input("mesh-count-impossible", name + ": " + numbers + "; at most " + std::to_string(most_triangles) +
                                                  " can be worked on, use a coarser mesh");
  return {};
}

Vec3 read_point(const char* bytes) {
  float coordinates[3];
  std::memcpy(coordinates, bytes, sizeof coordinates);
  return {coordinates[0], coordinates[1], coordinates[2]};
}

void append_triangle(TriangleMesh& mesh) {
  const auto first = static_cast<Index>(mesh.vertices_mm.size()) - 3;
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Result<void> expect_word(TextCursor& cursor, const std::string& name, std::string_view expected) {
  const std::string_view word = cursor.word();
  if (same_word(word, expected)) return {};
  if (cursor.was_cut())
    return bad_input("mesh-truncated", place(name, cursor) + "the file ends where \"" + std::string(expected) +
                                           "\" should stand; copy or export it again");
  return bad_input("mesh-syntax", place(name, cursor) + "\"" + std::string(expected) +
                                      "\" expected in an STL text; export the file again");
}

Result<void> expect_words(TextCursor& cursor, const std::string& name,
                          std::initializer_list<std::string_view> expected) {
  for (const std::string_view word : expected)
    if (auto met = expect_word(cursor, name, word); !met) return met;
  return {};
}

/// "facet normal nx ny nz outer loop (vertex x y z)*3 endloop endfacet", the word "facet" already eaten.
Result<void> parse_facet(TextCursor& cursor, const std::string& name, TriangleMesh& mesh) {
  if (auto met = expect_word(cursor, name, "normal"); !met) return met;
  for (int k = 0; k < 3; ++k) cursor.word();  // normals are computed from the corners: some writers put nan here
  if (auto met = expect_words(cursor, name, {"outer", "loop"}); !met) return met;
  for (int corner = 0; corner < 3; ++corner) {
    if (auto met = expect_word(cursor, name, "vertex"); !met) return met;
    Vec3 point;
    for (int k = 0; k < 3; ++k) {
      const auto value = cursor.number(name, "a coordinate");
      if (!value) return tl::unexpected(value.error());
      point[k] = *value;
    }
    mesh.vertices_mm.push_back(point);
  }
  append_triangle(mesh);
  return expect_words(cursor, name, {"endloop", "endfacet"});
}

}  // namespace

bool is_exact_stl_binary(std::string_view bytes) {
  return bytes.size() >= header_bytes && header_bytes + record_bytes * claimed_triangles(bytes) == bytes.size();
}

Result<TriangleMesh> parse_stl_binary(std::string_view bytes, const std::string& name) {
  if (auto count = check_count(bytes, name); !count) return tl::unexpected(count.error());
  const std::size_t count = claimed_triangles(bytes);
  TriangleMesh mesh;
  mesh.vertices_mm.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    const char* record = bytes.data() + header_bytes + record_bytes * t;
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      mesh.vertices_mm.push_back(read_point(record + 12 * corner));
      if (!mesh.vertices_mm.back().allFinite())
        return bad_input("mesh-not-finite",
                         name + ": triangle " + std::to_string(t) +
                             ": a coordinate is not a finite number; the file is damaged, copy or export it again");
    }
    append_triangle(mesh);
  }
  return mesh;
}

Result<TriangleMesh> parse_stl_ascii(std::string_view bytes, const std::string& name) {
  TextCursor cursor(bytes);
  TriangleMesh mesh;
  while (!cursor.at_end()) {
    if (auto met = expect_word(cursor, name, "solid"); !met) return tl::unexpected(met.error());
    cursor.rest_of_line();
    while (true) {
      const std::string_view word = cursor.word();
      if (same_word(word, "endsolid")) break;
      if (cursor.was_cut())
        return bad_input("mesh-truncated", place(name, cursor) + "the file ends before \"endsolid\", after " +
                                               std::to_string(mesh.triangles.size()) +
                                               " triangles; copy or export it again");
      if (!same_word(word, "facet"))
        return bad_input("mesh-syntax", place(name, cursor) +
                                            "\"facet\" or \"endsolid\" expected in an STL text; export the file again");
      if (auto facet = parse_facet(cursor, name, mesh); !facet) return tl::unexpected(facet.error());
    }
    cursor.rest_of_line();
  }
  if (mesh.triangles.empty())
    return bad_input("mesh-empty", name + ": the STL has no triangle; export the surface again");
  return mesh;
}

}  // namespace volute::geometry
