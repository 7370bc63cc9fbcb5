#include "kinematics/model/toml_reader.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/file.hpp"
#include "geometry/number_text.hpp"

namespace volute::kinematics {

using geometry::Error;
using geometry::ErrorKind;
using geometry::short_text;
using geometry::Vec3;

namespace {

std::string key_path(const std::string& where, std::string_view key) {
  return where.empty() ? std::string(key) : where + "." + std::string(key);
}

}  // namespace

TomlReader::TomlReader(const std::filesystem::path& file, std::string code_prefix)
    : file_(file), prefix_(std::move(code_prefix)) {
  const auto bytes = geometry::read_file(file);
  if (!bytes) {
    error_ = bytes.error();
    return;
  }
  try {
    root_ = toml::parse(*bytes, file.string());
  } catch (const toml::parse_error& failure) {
    error_ = Error{
        ErrorKind::bad_input, prefix_ + "-syntax",
        file_.string() + ":" + std::to_string(failure.source().begin.line) + ": " + std::string(failure.description())};
  }
}

void TomlReader::refuse(const toml::node* node, const std::string& key, const std::string& what, const char* code) {
  if (error_) return;
  const std::string line = node && node->source().begin.line > 0 ? ":" + std::to_string(node->source().begin.line) : "";
  error_ = Error{ErrorKind::bad_input, prefix_ + "-" + code, file_.string() + line + ": " + key + ": " + what};
}

void TomlReader::only_keys(const toml::table& table, const std::string& where,
                           std::initializer_list<std::string_view> known) {
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    std::string list;
    for (const std::string_view word : known) list += (list.empty() ? "" : " ") + std::string(word);
    refuse(&node, key_path(where, key.str()), "no such key; known here: " + list, "key");
  }
}

const toml::table& TomlReader::table(const toml::table& parent, const std::string& where, std::string_view key) {
  if (const auto* found = parent[key].as_table()) return *found;
  refuse(parent.get(key), key_path(where, key), "a table [" + key_path(where, key) + "] is needed", "key");
  return empty_;
}

const toml::table& TomlReader::optional_table(const toml::table& parent, const std::string& where,
                                              std::string_view key) {
  return parent.contains(key) ? table(parent, where, key) : empty_;
}

double TomlReader::number(const toml::table& table, const std::string& where, std::string_view key,
                          std::optional<double> fallback) {
  const toml::node* node = table.get(key);
  if (!node && fallback) return *fallback;
  const auto value = node ? node->value<double>() : std::nullopt;
  if (value && std::isfinite(*value)) return *value;
  refuse(node ? node : &table, key_path(where, key),
         node ? "must be a finite number" : "is missing; a number is needed", node ? "value" : "key");
  return fallback.value_or(0.0);
}

double TomlReader::positive(const toml::table& table, const std::string& where, std::string_view key,
                            std::optional<double> fallback) {
  const double value = number(table, where, key, fallback);
  if (!(value > 0.0)) refuse(table.get(key), key_path(where, key), short_text(value) + " must be above 0");
  return value;
}

int TomlReader::integer(const toml::table& table, const std::string& where, std::string_view key, int fallback,
                        int least, int greatest) {
  const toml::node* node = table.get(key);
  if (!node) return fallback;
  const auto value = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
  if (value && *value >= least && *value <= greatest) return static_cast<int>(*value);
  refuse(node, key_path(where, key),
         "must be a whole number from " + std::to_string(least) + " to " + std::to_string(greatest));
  return fallback;
}

bool TomlReader::boolean(const toml::table& table, const std::string& where, std::string_view key, bool fallback) {
  const toml::node* node = table.get(key);
  if (!node) return fallback;
  if (!node->is_boolean()) refuse(node, key_path(where, key), "must be true or false");
  return node->value<bool>().value_or(fallback);
}

std::string TomlReader::text(const toml::table& table, const std::string& where, std::string_view key,
                             std::optional<std::string> fallback) {
  const toml::node* node = table.get(key);
  if (!node && fallback) return *fallback;
  if (node && node->is_string()) return *node->value<std::string>();
  refuse(node ? node : &table, key_path(where, key), node ? "must be a text in quotes" : "is missing; a text is needed",
         node ? "value" : "key");
  return fallback.value_or("");
}

std::vector<double> TomlReader::numbers(const toml::table& table, const std::string& where, std::string_view key,
                                        std::size_t count, std::optional<std::vector<double>> fallback) {
  const toml::node* node = table.get(key);
  if (!node && fallback) return *fallback;
  std::vector<double> values;
  if (const toml::array* array = node ? node->as_array() : nullptr)
    for (const toml::node& item : *array)
      if (const auto value = item.value<double>(); value && std::isfinite(*value)) values.push_back(*value);
  const bool complete = node && node->is_array() && values.size() == count && node->as_array()->size() == count;
  if (complete) return values;
  refuse(node ? node : &table, key_path(where, key), "must be a list of " + std::to_string(count) + " finite numbers",
         node ? "value" : "key");
  return fallback.value_or(std::vector<double>(count, 0.0));
}

Vec3 TomlReader::vector(const toml::table& table, const std::string& where, std::string_view key,
                        std::optional<Vec3> fallback) {
  std::optional<std::vector<double>> list;
  if (fallback) list = std::vector<double>{fallback->x(), fallback->y(), fallback->z()};
  const std::vector<double> values = numbers(table, where, key, 3, list);
  return {values[0], values[1], values[2]};
}

std::vector<std::string> TomlReader::texts(const toml::table& table, const std::string& where, std::string_view key) {
  std::vector<std::string> values;
  const toml::node* node = table.get(key);
  if (!node) return values;
  if (!node->is_array()) refuse(node, key_path(where, key), "must be a list of texts");
  if (const toml::array* array = node->as_array())
    for (const toml::node& item : *array) {
      if (!item.is_string()) refuse(&item, key_path(where, key), "must be a list of texts");
      values.push_back(item.value<std::string>().value_or(""));
    }
  return values;
}

std::size_t TomlReader::choice(const toml::table& table, const std::string& where, std::string_view key,
                               std::initializer_list<std::string_view> words, std::optional<std::size_t> fallback) {
  if (!table.contains(key) && fallback) return *fallback;
  const std::string word = text(table, where, key);
  std::string list;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words.begin()[k] == word) return k;
    list += (list.empty() ? "" : ", ") + std::string(words.begin()[k]);
  }
  refuse(table.get(key), key_path(where, key), "\"" + word + "\" is none of " + list);
  return fallback.value_or(0);
}

}  // namespace volute::kinematics
