// The header of a PLY file. Internal to `geometry`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/result.hpp"

namespace volute::geometry {

enum class PlyCoding { ascii, binary_little_endian, binary_big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
/// What a property means to us.
enum class PlyRole { none, x, y, z, corners };

struct PlyProperty {
  bool is_list = false;
  PlyType count_type = PlyType::uint8;
  PlyType type = PlyType::float32;
  PlyRole role = PlyRole::none;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyCoding coding = PlyCoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0, lines = 0;
};

/// Errors (bad_input): mesh-truncated (no end_header), mesh-syntax.
Result<PlyHeader> parse_ply_header(std::string_view bytes, const std::string& name);

std::size_t bytes_of(PlyType type);
bool has_fixed_rows(const PlyElement& element);
/// The least that one row takes: lists may be empty; text needs a digit and a blank a value.
std::uint64_t least_row_bytes(const PlyElement& element, PlyCoding coding);

}  // namespace volute::geometry
