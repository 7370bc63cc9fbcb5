// Reads keys of a TOML file with one-line errors that name file, line, key, value and rule. Private to
// kinematics/model.
#pragma once

#include <toml++/toml.h>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/result.hpp"
#include "geometry/vector.hpp"

namespace volute::kinematics {

/// Keeps the first error; every getter after it returns its default, so a reader is one list of fields and one check at
/// the end.
class TomlReader {
 public:
  /// `code_prefix`: "machine" or "control"; errors are PREFIX-file, PREFIX-syntax, PREFIX-key, PREFIX-value.
  TomlReader(const std::filesystem::path& file, std::string code_prefix);

  [[nodiscard]] const toml::table& root() const { return root_; }
  [[nodiscard]] const std::optional<geometry::Error>& error() const { return error_; }

  /// Records an error at `node` (its line; none when null).
  void refuse(const toml::node* node, const std::string& key, const std::string& what, const char* code = "value");
  /// Records an error when `table` has a key that is not in `known`.
  void only_keys(const toml::table& table, const std::string& where, std::initializer_list<std::string_view> known);

  /// The sub-table; an empty one and an error when it is missing.
  const toml::table& table(const toml::table& parent, const std::string& where, std::string_view key);
  /// The same without an error when it is missing.
  const toml::table& optional_table(const toml::table& parent, const std::string& where, std::string_view key);

  double number(const toml::table& table, const std::string& where, std::string_view key,
                std::optional<double> fallback = std::nullopt);
  /// A number above 0.
  double positive(const toml::table& table, const std::string& where, std::string_view key,
                  std::optional<double> fallback = std::nullopt);
  int integer(const toml::table& table, const std::string& where, std::string_view key, int fallback, int least,
              int greatest);
  bool boolean(const toml::table& table, const std::string& where, std::string_view key, bool fallback);
  std::string text(const toml::table& table, const std::string& where, std::string_view key,
                   std::optional<std::string> fallback = std::nullopt);
  std::vector<double> numbers(const toml::table& table, const std::string& where, std::string_view key,
                              std::size_t count, std::optional<std::vector<double>> fallback = std::nullopt);
  geometry::Vec3 vector(const toml::table& table, const std::string& where, std::string_view key,
                        std::optional<geometry::Vec3> fallback = std::nullopt);
  std::vector<std::string> texts(const toml::table& table, const std::string& where, std::string_view key);
  /// Index of the value in `words`; an error that lists them when it is none.
  std::size_t choice(const toml::table& table, const std::string& where, std::string_view key,
                     std::initializer_list<std::string_view> words, std::optional<std::size_t> fallback = std::nullopt);

 private:
  std::filesystem::path file_;
  std::string prefix_;
  toml::table root_, empty_;
  std::optional<geometry::Error> error_;
};

}  // namespace volute::kinematics
