#include "app/context.hpp"

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/exit_status.hpp"

namespace volute::app {

namespace {

std::filesystem::path find_machines_folder() {
  if (const char* named = std::getenv("VOLUTE_MACHINES"); named != nullptr && *named != '\0') return named;
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const std::filesystem::path here = program.parent_path();
  for (const char* candidate : {"../../machines", "../share/volute/machines", "../machines", "../../../machines"}) {
    const std::filesystem::path folder = here / candidate;
    if (std::filesystem::is_directory(folder / "controls", ignored))
      return std::filesystem::weakly_canonical(folder, ignored);
  }
  return here / "machines";
}

}  // namespace

Context::Context(const CommonArguments& common)
    : common_(common), progress_(common.quiet), machines_folder_(find_machines_folder()) {}

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
