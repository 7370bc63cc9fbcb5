#include "app/output_folder.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "geometry/file.hpp"

namespace volute::app {

namespace fs = std::filesystem;

geometry::Result<void> OutputFolder::check(const fs::path& folder) {
  std::error_code failed;
  fs::path nearest = fs::absolute(folder, failed);
  while (!fs::exists(nearest, failed) && nearest != nearest.parent_path()) nearest = nearest.parent_path();
  if (!fs::is_directory(nearest, failed))
    return geometry::bad_input("out-not-a-folder",
                               nearest.string() + ": is a file; --out names a folder: give another name");
  if (access(nearest.c_str(), W_OK | X_OK) != 0)
    return geometry::system_error("out-not-made", folder.string() + ": nothing can be written in " + nearest.string() +
                                                      ": " + std::strerror(errno));
  return {};
}

geometry::Result<OutputFolder> OutputFolder::make(const fs::path& folder) {
  std::error_code failed;
  if (fs::exists(folder, failed) && !fs::is_directory(folder, failed))
    return geometry::bad_input("out-not-a-folder",
                               folder.string() + ": is a file; --out names a folder: give another name");
  fs::create_directories(folder, failed);
  if (failed)
    return geometry::system_error("out-not-made", folder.string() + ": cannot make this folder: " + failed.message());
  return OutputFolder(folder);
}

geometry::Result<void> OutputFolder::write(std::string_view name, std::string_view bytes) const {
  return geometry::write_file(file(name), bytes);
}

geometry::Result<std::string> OutputFolder::write_program(const std::string& stem, const std::string& extension,
                                                          std::string_view text, bool passed) const {
  const std::string final_name = stem + extension;
  const std::string rejected_name = stem + ".rejected" + extension;
  std::error_code ignored;
  if (!passed && fs::exists(file(final_name), ignored))
    fs::rename(file(final_name), file(stem + ".old" + extension), ignored);
  const std::string& name = passed ? final_name : rejected_name;
  if (const auto written = write(name, text); !written) return tl::unexpected(written.error());
  if (passed) fs::remove(file(rejected_name), ignored);
  return name;
}

}  // namespace volute::app
