// Where results go: each file is written beside its place and renamed into it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/result.hpp"

namespace volute::app {

class OutputFolder {
 public:
  /// Whether `make` would succeed, without making anything: asked before long work. Errors: as make.
  static geometry::Result<void> check(const std::filesystem::path& folder);
  /// Makes the folder. Errors: out-not-a-folder (bad_input), out-not-made (system).
  static geometry::Result<OutputFolder> make(const std::filesystem::path& folder);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path file(std::string_view name) const { return folder_ / name; }
  geometry::Result<void> write(std::string_view name, std::string_view bytes) const;

  /// The program under its final name when it passed, else as NAME.rejected.EXT. A program that stood under the final
  /// name from an earlier run is never left there beside a rejected one: it is kept as NAME.old.EXT. Returns the name
  /// written.
  [[nodiscard]] geometry::Result<std::string> write_program(const std::string& stem, const std::string& extension,
                                                            std::string_view text, bool passed) const;

 private:
  explicit OutputFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::filesystem::path folder_;
};

}  // namespace volute::app
