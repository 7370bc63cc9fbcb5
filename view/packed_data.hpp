// Tables of numbers as text in a page: quantised, differenced, byte planes, zlib, base64. The page's data.js reads
// them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace volute::view {

/// zlib stream (RFC 1950), as DecompressionStream("deflate") reads it.
std::string zlib_bytes(std::string_view bytes);
/// The inverse. Empty when `bytes` is not a whole zlib stream.
std::string inflated_bytes(std::string_view bytes);
/// RFC 4648 with padding.
std::string base64_text(std::string_view bytes);

/// Columns of numbers under names, written as one stream.
/// Layout: u32 length of a JSON header, the header padded to 4 bytes, then per column four planes of bytes (lowest
/// first) of zigzag-coded differences modulo 2^32. Header: {"name": {"count", "step", "order"}} in the order of the
/// columns. A reader sums `order` times and multiplies by `step`. Properties: 1. A value comes back within half a
/// step. 2. The same columns give the same bytes.
class PackedData {
 public:
  /// Requires: step > 0, name of letters, digits and dots, every value finite. A column with values of 2^31 steps or
  /// more has its step doubled until they are fewer.
  void add(const std::string& name, const std::vector<double>& values, double step);
  /// A step of the largest magnitude over 32000: for curves that are looked at, not read off.
  void add_curve(const std::string& name, const std::vector<double>& values);
  void add_integers(const std::string& name, const std::vector<std::int64_t>& values);
  [[nodiscard]] std::string bytes() const;

 private:
  void add_coded(const std::string& name, const std::vector<std::int32_t>& values, double step);
  std::string header_, planes_;
};

/// The columns of PackedData::bytes by name. Nothing when `bytes` is not whole.
std::optional<std::map<std::string, std::vector<double>>> unpacked_columns(std::string_view bytes);

}  // namespace volute::view
