#include "view/packed_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"

namespace volute::view {

namespace {

constexpr int zlib_level = 6;
constexpr double curve_steps = 32000.0;
constexpr int greatest_order = 2;

/// Differences of neighbours, the first one kept, `order` times; modulo 2^32, so that nothing can overflow.
std::vector<std::uint32_t> differences(const std::vector<std::int32_t>& values, int order) {
  std::vector<std::uint32_t> out(values.begin(), values.end());
  for (int pass = 0; pass < order; ++pass)
    for (std::size_t i = out.size(); i-- > 1;) out[i] -= out[i - 1];
  return out;
}

/// Small magnitudes of either sign become small numbers.
std::uint32_t zigzag(std::uint32_t value) { return (value << 1U) ^ (0U - (value >> 31U)); }

/// About how many bits zlib will need.
std::int64_t cost_bits(const std::vector<std::uint32_t>& coded) {
  std::int64_t bits = 0;
  for (const std::uint32_t value : coded) bits += std::bit_width(value);
  return bits;
}

std::vector<std::uint32_t> coded_with(const std::vector<std::int32_t>& values, int order) {
  std::vector<std::uint32_t> coded = differences(values, order);
  for (std::uint32_t& value : coded) value = zigzag(value);
  return coded;
}

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = (value << 8U) | static_cast<std::uint8_t>(bytes[at + k]);
  return value;
}

/// A column out of its four planes.
std::vector<double> column_values(std::string_view planes, std::size_t count, int order, double step) {
  std::vector<std::uint32_t> steps(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t coded = 0;
    for (std::size_t plane = 4; plane-- > 0;)
      coded = (coded << 8U) | static_cast<std::uint8_t>(planes[plane * count + i]);
    steps[i] = (coded >> 1U) ^ (0U - (coded & 1U));
  }
  for (int pass = 0; pass < order; ++pass)
    for (std::size_t i = 1; i < count; ++i) steps[i] += steps[i - 1];
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<double>(static_cast<std::int32_t>(steps[i])) * step;
  return values;
}

void append_u32(std::string& out, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) out += static_cast<char>((value >> shift) & 0xFFU);
}

}  // namespace

std::string zlib_bytes(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), zlib_level);
  VOLUTE_CHECK(status == Z_OK, status);
  out.resize(size);
  return out;
}

std::string inflated_bytes(std::string_view bytes) {
  std::string out(std::max<std::size_t>(64, bytes.size()), '\0');
  for (;; out.resize(out.size() * 4)) {
    uLongf size = out.size();
    const int status = uncompress(reinterpret_cast<Bytef*>(out.data()), &size,
                                  reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
    if (status == Z_BUF_ERROR && out.size() < bytes.size() * 2048) continue;
    out.resize(status == Z_OK ? size : 0);
    return out;
  }
}

std::string base64_text(std::string_view bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8U) | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? letters[(group >> (18U - 6U * k)) & 63U] : '=';
  }
  return out;
}

void PackedData::add(const std::string& name, const std::vector<double>& values, double step) {
  std::vector<std::int32_t> steps(values.size());
  constexpr double most_steps = 2147483647.0;
  double largest = 0.0;
  for (const double value : values) {
    VOLUTE_CHECK(std::isfinite(value), name, value);
    largest = std::max(largest, std::abs(value));
  }
  while (std::round(largest / step) >= most_steps) step *= 2.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double count = std::round(values[i] / step);
    steps[i] = static_cast<std::int32_t>(count);
  }
  add_coded(name, steps, step);
}

void PackedData::add_curve(const std::string& name, const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  add(name, values, largest > 0.0 ? largest / curve_steps : 1.0);
}

void PackedData::add_integers(const std::string& name, const std::vector<std::int64_t>& values) {
  std::vector<std::int32_t> steps(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) steps[i] = static_cast<std::int32_t>(values[i]);
  add_coded(name, steps, 1.0);
}

void PackedData::add_coded(const std::string& name, const std::vector<std::int32_t>& values, double step) {
  int order = 0;
  std::vector<std::uint32_t> best = coded_with(values, 0);
  for (int other = 1; other <= greatest_order; ++other) {
    std::vector<std::uint32_t> coded = coded_with(values, other);
    if (cost_bits(coded) >= cost_bits(best)) continue;
    best = std::move(coded);
    order = other;
  }
  const std::size_t begin = planes_.size();
  planes_.resize(begin + 4 * best.size());
  char* out = planes_.data() + begin;
  for (unsigned shift = 0; shift < 32; shift += 8)
    for (const std::uint32_t value : best) *out++ = static_cast<char>((value >> shift) & 0xFFU);
  header_ += (header_.empty() ? "\"" : ",\"") + name + "\":{\"count\":" + std::to_string(values.size()) +
             ",\"step\":" + geometry::shortest_text(step) + ",\"order\":" + std::to_string(order) + "}";
}

std::optional<std::map<std::string, std::vector<double>>> unpacked_columns(std::string_view bytes) {
  if (bytes.size() < 4) return std::nullopt;
  const std::size_t header_size = u32_at(bytes, 0);
  if (header_size > bytes.size() - 4) return std::nullopt;
  const auto header = nlohmann::ordered_json::parse(bytes.substr(4, header_size), nullptr, false);
  if (!header.is_object()) return std::nullopt;
  std::map<std::string, std::vector<double>> columns;
  std::size_t at = 4 + header_size;
  for (const auto& [name, entry] : header.items()) {
    const auto count = entry.value("count", std::size_t{0});
    if (count > (bytes.size() - at) / 4) return std::nullopt;
    columns[name] =
        column_values(bytes.substr(at, 4 * count), count, entry.value("order", 0), entry.value("step", 1.0));
    at += 4 * count;
  }
  return columns;
}

std::string PackedData::bytes() const {
  std::string header = "{" + header_ + "}";
  header.resize((header.size() + 3) / 4 * 4, ' ');
  std::string out;
  append_u32(out, static_cast<std::uint32_t>(header.size()));
  return out + header + planes_;
}

}  // namespace volute::view
