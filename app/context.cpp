#include "app/context.hpp"

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/exit_status.hpp"

namespace volute::app {

namespace {

/// A folder that comes with the program: as the environment names it, else where the build or the installation has it.
std::filesystem::path find_folder(const char* variable, const std::string& name, const char* known_file) {
  if (const char* named = std::getenv(variable); named != nullptr && *named != '\0') return named;
  std::error_code ignored;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const char* candidate : {"../../", "../share/volute/", "../", "../../../"}) {
    const std::filesystem::path folder = here / (candidate + name);
    if (std::filesystem::exists(folder / known_file, ignored))
      return std::filesystem::weakly_canonical(folder, ignored);
  }
  return here / name;
}

}  // namespace

Context::Context(const CommonArguments& common)
    : common_(common),
      progress_(common.quiet),
      machines_folder_(find_folder("VOLUTE_MACHINES", "machines", "controls")),
      examples_folder_(find_folder("VOLUTE_EXAMPLES", "examples", "mouse.toml")) {}

void Context::print(const nlohmann::ordered_json& value, const std::string& text) {
  progress_.clear();
  const std::string out = common_.json ? value.dump(2) + "\n" : text;
  std::fwrite(out.data(), 1, out.size(), stdout);
}

void Context::warn(const std::vector<std::string>& lines) {
  progress_.clear();
  for (const std::string& line : lines) std::fprintf(stderr, "volute: warning: %s\n", line.c_str());
}

int Context::fail(const geometry::Error& error) {
  progress_.clear();
  std::fprintf(stderr, "volute: error: %s\n", error.message.c_str());
  return exit_status(error.kind);
}

}  // namespace volute::app
