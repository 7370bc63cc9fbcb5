#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "geometry/mesh_formats.hpp"
#include "geometry/ply_header.hpp"
#include "geometry/polygon.hpp"
#include "geometry/text_cursor.hpp"

namespace volute::geometry {

namespace {

template <class Number>
double decoded(const char* bytes, bool swapped) {
  char room[sizeof(Number)];
  std::memcpy(room, bytes, sizeof room);
  if (swapped) std::reverse(room, room + sizeof room);
  Number value;
  std::memcpy(&value, room, sizeof value);
  return static_cast<double>(value);
}

double decoded(const char* bytes, PlyType type, bool swapped) {
  switch (type) {
    case PlyType::int8:
      return decoded<std::int8_t>(bytes, swapped);
    case PlyType::uint8:
      return decoded<std::uint8_t>(bytes, swapped);
    case PlyType::int16:
      return decoded<std::int16_t>(bytes, swapped);
    case PlyType::uint16:
      return decoded<std::uint16_t>(bytes, swapped);
    case PlyType::int32:
      return decoded<std::int32_t>(bytes, swapped);
    case PlyType::uint32:
      return decoded<std::uint32_t>(bytes, swapped);
    case PlyType::float32:
      return decoded<float>(bytes, swapped);
    case PlyType::float64:
      break;
  }
  return decoded<double>(bytes, swapped);
}

/// The values behind the header, one after the other, whatever their coding.
class PlyBody {
 public:
  PlyBody(std::string_view bytes, const PlyHeader& header, const std::string& name)
      : bytes_(bytes.substr(header.bytes)), text_(bytes_, header.lines + 1), coding_(header.coding), name_(name) {}

  Result<double> next(PlyType type) {
    if (coding_ == PlyCoding::ascii) return text_.number(name_, "a value");
    const std::size_t size = bytes_of(type);
    if (bytes_.size() - position_ < size) return bad_input("mesh-truncated", "");
    const double value = decoded(bytes_.data() + position_, type, coding_ == PlyCoding::binary_big_endian);
    position_ += size;
    return value;
  }
  [[nodiscard]] std::size_t left() const {
    return coding_ == PlyCoding::ascii ? text_.left() : bytes_.size() - position_;
  }

 private:
  std::string_view bytes_;
  TextCursor text_;
  PlyCoding coding_;
  const std::string& name_;
  std::size_t position_ = 0;
};

/// What one row of an element says: its coordinates and its list of corners, where it has them.
struct PlyRow {
  Vec3 point = Vec3::Zero();
  std::vector<Index> corners;
};

Result<void> read_list(PlyBody& body, const PlyProperty& property, bool wanted, PlyRow& row) {
  const auto count = body.next(property.count_type);
  if (!count) return tl::unexpected(count.error());
  if (!(*count >= 0.0) || *count > static_cast<double>(body.left())) return bad_input("mesh-truncated", "");
  for (double k = 0; k < *count; ++k) {
    const auto value = body.next(property.type);
    if (!value) return tl::unexpected(value.error());
    if (!wanted || row.corners.size() > most_polygon_corners) continue;
    const bool fits = *value >= 0.0 && *value <= std::numeric_limits<Index>::max();
    row.corners.push_back(fits ? static_cast<Index>(*value) : no_index);
  }
  return {};
}

Result<void> read_row(PlyBody& body, const PlyElement& element, PlyRow& row) {
  row.corners.clear();
  for (const PlyProperty& property : element.properties) {
    if (property.is_list) {
      if (auto list = read_list(body, property, property.role == PlyRole::corners, row); !list) return list;
      continue;
    }
    const auto value = body.next(property.type);
    if (!value) return tl::unexpected(value.error());
    if (property.role >= PlyRole::x && property.role <= PlyRole::z) {
      if (!std::isfinite(*value)) return bad_input("mesh-not-finite", "");
      row.point[static_cast<int>(property.role) - static_cast<int>(PlyRole::x)] = *value;
    }
  }
  return {};
}

/// Errors of binary rows have no line number: name the row instead.
tl::unexpected<Error> located(Error error, const std::string& name, const PlyElement& element, std::uint64_t row) {
  if (!error.message.empty()) return tl::unexpected(std::move(error));
  const std::string where =
      name + ": " + element.name + " " + std::to_string(row) + " of " + std::to_string(element.count) + ": ";
  error.message =
      where + (error.code == "mesh-truncated" ? "the file ends inside it; copy or export it again"
                                              : "a coordinate is not a finite number; export the file again");
  return tl::unexpected(std::move(error));
}

/// Before anything is allocated for its rows.
Result<void> check_room(const PlyElement& element, const PlyBody& body, PlyCoding coding, const std::string& name) {
  const std::uint64_t row = least_row_bytes(element, coding);
  if (row == 0 || element.count <= body.left() / row + (coding == PlyCoding::ascii ? 1 : 0)) return {};
  const std::string facts = name + ": " + std::to_string(element.count) + " rows of \"" + element.name +
                            "\" need at least " + std::to_string(row) + " bytes each and " +
                            std::to_string(body.left()) + " bytes are left; ";
  if (has_fixed_rows(element) && coding != PlyCoding::ascii && body.left() % row != 0)
    return bad_input("mesh-truncated", facts + "the file was cut off, copy or export it again");
  return bad_input("mesh-count-impossible", facts + "copy or export it again");
}

Result<void> read_element(PlyBody& body, const PlyElement& element, PlyCoding coding, const std::string& name,
                          TriangleMesh& mesh) {
  if (auto room = check_room(element, body, coding, name); !room) return room;
  if (element.properties.empty()) return {};
  PlyRow row;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    if (auto read = read_row(body, element, row); !read) return located(read.error(), name, element, i);
    if (element.name == "vertex") mesh.vertices_mm.push_back(row.point);
    if (element.name != "face") continue;
    const std::string where = name + ": face " + std::to_string(i) + ": ";
    if (auto sound = check_polygon(row.corners, mesh.vertices_mm.size(), where); !sound) return sound;
    append_polygon(mesh, row.corners);
  }
  return {};
}

}  // namespace

Result<TriangleMesh> parse_ply(std::string_view bytes, const std::string& name) {
  const Result<PlyHeader> header = parse_ply_header(bytes, name);
  if (!header) return tl::unexpected(header.error());
  PlyBody body(bytes, *header, name);
  TriangleMesh mesh;
  for (const PlyElement& element : header->elements)
    if (auto read = read_element(body, element, header->coding, name, mesh); !read) return tl::unexpected(read.error());
  if (mesh.triangles.empty()) return bad_input("mesh-empty", name + ": the file has no face; export the surface again");
  return mesh;
}

}  // namespace volute::geometry
