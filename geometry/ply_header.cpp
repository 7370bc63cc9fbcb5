#include "geometry/ply_header.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "geometry/number_text.hpp"
#include "geometry/text_cursor.hpp"

namespace volute::geometry {

namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> type_names = {{{"char", PlyType::int8},
                                                  {"int8", PlyType::int8},
                                                  {"uchar", PlyType::uint8},
                                                  {"uint8", PlyType::uint8},
                                                  {"short", PlyType::int16},
                                                  {"int16", PlyType::int16},
                                                  {"ushort", PlyType::uint16},
                                                  {"uint16", PlyType::uint16},
                                                  {"int", PlyType::int32},
                                                  {"int32", PlyType::int32},
                                                  {"uint", PlyType::uint32},
                                                  {"uint32", PlyType::uint32},
                                                  {"float", PlyType::float32},
                                                  {"float32", PlyType::float32},
                                                  {"double", PlyType::float64},
                                                  {"float64", PlyType::float64}}};

std::optional<PlyType> type_named(std::string_view word) {
  const auto found =
      std::find_if(type_names.begin(), type_names.end(), [&](const TypeName& t) { return t.name == word; });
  return found == type_names.end() ? std::nullopt : std::optional(found->type);
}

std::optional<PlyCoding> coding_named(std::string_view word) {
  if (word == "ascii") return PlyCoding::ascii;
  if (word == "binary_little_endian") return PlyCoding::binary_little_endian;
  if (word == "binary_big_endian") return PlyCoding::binary_big_endian;
  return std::nullopt;
}

PlyRole role_of(std::string_view element, std::string_view property, bool is_list) {
  if (element == "face" && is_list && (property == "vertex_indices" || property == "vertex_index"))
    return PlyRole::corners;
  if (element != "vertex" || is_list) return PlyRole::none;
  return property == "x" ? PlyRole::x : property == "y" ? PlyRole::y : property == "z" ? PlyRole::z : PlyRole::none;
}

/// The words behind "property"; nothing when they are not understood.
std::optional<PlyProperty> parse_property(TextCursor& words, std::string_view element) {
  PlyProperty property;
  std::optional<PlyType> type = type_named(words.peek());
  if (words.word() == "list") {
    const std::optional<PlyType> count_type = type_named(words.word());
    type = type_named(words.word());
    if (!count_type || *count_type >= PlyType::float32) return std::nullopt;
    property.is_list = true;
    property.count_type = *count_type;
  }
  const std::string_view name = words.word();
  if (!type || name.empty()) return std::nullopt;
  property.type = *type;
  property.role = role_of(element, name, property.is_list);
  return property;
}

bool has_role(const PlyHeader& header, std::string_view element, PlyRole role) {
  return std::any_of(header.elements.begin(), header.elements.end(), [&](const PlyElement& e) {
    return e.name == element &&
           std::any_of(e.properties.begin(), e.properties.end(), [&](const PlyProperty& p) { return p.role == role; });
  });
}

/// One line of the header; false when it is not understood.
bool take_line(std::string_view line, PlyHeader& header) {
  TextCursor words(line);
  const std::string_view keyword = words.word();
  if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) return true;
  if (keyword == "format") {
    const auto coding = coding_named(words.word());
    if (coding) header.coding = *coding;
    return coding.has_value();
  }
  if (keyword == "element") {
    const std::string_view name = words.word();
    const auto count = parse_integer(words.word());
    if (!count || *count < 0) return false;
    header.elements.push_back({std::string(name), static_cast<std::uint64_t>(*count), {}});
    return true;
  }
  if (keyword != "property" || header.elements.empty()) return false;
  const auto property = parse_property(words, header.elements.back().name);
  if (property) header.elements.back().properties.push_back(*property);
  return property.has_value();
}

Result<void> check_roles(const PlyHeader& header, const std::string& name) {
  const bool has_points = has_role(header, "vertex", PlyRole::x) && has_role(header, "vertex", PlyRole::y) &&
                          has_role(header, "vertex", PlyRole::z);
  if (!has_points)
    return bad_input("mesh-syntax", name + ": the PLY header has no vertex with x, y and z; export the file again");
  if (!has_role(header, "face", PlyRole::corners))
    return bad_input(
        "mesh-syntax",
        name + ": the PLY header has no face with a list vertex_indices (a point cloud or strips?); export triangles");
  return {};
}

}  // namespace

Result<PlyHeader> parse_ply_header(std::string_view bytes, const std::string& name) {
  PlyHeader header;
  TextCursor cursor(bytes);
  cursor.rest_of_line();
  for (header.lines = 1; cursor.left() > 0;) {
    std::string_view line = cursor.rest_of_line();
    ++header.lines;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line == "end_header") {
      header.bytes = cursor.position();
      if (auto roles = check_roles(header, name); !roles) return tl::unexpected(roles.error());
      return header;
    }
    if (!take_line(line, header) && cursor.left() > 0)
      return bad_input("mesh-syntax", name + ":" + std::to_string(header.lines) +
                                          ": this line of the PLY header is not understood; export the file again");
  }
  return bad_input("mesh-truncated", name + ": the PLY header has no end_header; copy or export it again");
}

std::size_t bytes_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool has_fixed_rows(const PlyElement& element) {
  return std::none_of(element.properties.begin(), element.properties.end(),
                      [](const PlyProperty& p) { return p.is_list; });
}

std::uint64_t least_row_bytes(const PlyElement& element, PlyCoding coding) {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes += coding == PlyCoding::ascii ? 2 : bytes_of(property.is_list ? property.count_type : property.type);
  return bytes;
}

}  // namespace volute::geometry
