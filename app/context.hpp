// What every command needs: where the machines are, how to speak to the user.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/arguments.hpp"
#include "app/progress.hpp"
#include "geometry/result.hpp"

namespace volute::app {

class Context {
 public:
  explicit Context(const CommonArguments& common);

  [[nodiscard]] Progress& progress() { return progress_; }
  [[nodiscard]] bool json() const { return common_.json; }
  /// Folder with the machine files: $VOLUTE_MACHINES, else beside the program (../../machines of the build,
  /// ../share/volute/machines when installed).
  [[nodiscard]] const std::filesystem::path& machines_folder() const { return machines_folder_; }

  /// Folder with the example jobs: $VOLUTE_EXAMPLES, else beside the program (../../examples of the build,
  /// ../share/volute/examples when installed).
  [[nodiscard]] const std::filesystem::path& examples_folder() const { return examples_folder_; }

  /// Standard output: the JSON value with --json, else the text.
  void print(const nlohmann::ordered_json& value, const std::string& text);
  /// One line on standard error, each.
  void warn(const std::vector<std::string>& lines);
  /// One line on standard error; returns the exit status that the error asks for.
  int fail(const geometry::Error& error);

 private:
  CommonArguments common_;
  Progress progress_;
  std::filesystem::path machines_folder_, examples_folder_;
};

}  // namespace volute::app
