// Who may include whom (docs/conventions.md): the includes of every source, read as text.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Folder -> folders whose headers it may include, besides its own. The longest matching name counts.
const std::map<std::string, std::vector<std::string>> allowed{
    {"geometry", {}},
    {"kinematics/model", {"geometry"}},
    {"kinematics/inverse", {"geometry", "kinematics/model"}},
    {"planner", {"geometry", "kinematics"}},
    {"post", {"geometry", "kinematics"}},
    {"sim", {"geometry", "kinematics/model"}},
    {"view", {"geometry", "kinematics", "sim"}},
    {"app", {"geometry", "kinematics", "planner", "post", "sim", "view"}},
};

bool starts_with_folder(const std::string& file, const std::string& folder) {
  return file.size() > folder.size() && file.compare(0, folder.size(), folder) == 0 && file[folder.size()] == '/';
}

bool may_include(const std::string& folder, const std::string& included) {
  if (starts_with_folder(included, folder)) return true;
  for (const std::string& other : allowed.at(folder))
    if (starts_with_folder(included, other)) return true;
  return false;
}

/// The project headers named by a source: only paths that begin with one of our folders count.
std::vector<std::string> project_includes(const fs::path& source) {
  std::ifstream in(source);
  std::vector<std::string> names;
  for (std::string line; std::getline(in, line);) {
    const std::string mark = "#include \"";
    if (line.compare(0, mark.size(), mark) != 0) continue;
    names.push_back(line.substr(mark.size(), line.find('"', mark.size()) - mark.size()));
  }
  return names;
}

std::vector<fs::path> sources_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") files.push_back(entry.path());
  return files;
}

TEST(IncludeDirection, EveryIncludeGoesDownward) {
  const fs::path root = VOLUTE_SOURCE_DIR;
  std::size_t includes = 0;
  for (const auto& [folder, ignored] : allowed)
    for (const fs::path& source : sources_below(root / folder))
      for (const std::string& included : project_includes(source)) {
        ++includes;
        EXPECT_TRUE(may_include(folder, included))
            << fs::relative(source, root) << " includes " << included << ", which " << folder << " may not";
      }
  EXPECT_GT(includes, 100U) << "the check read almost nothing: is VOLUTE_SOURCE_DIR right?";
}

TEST(IncludeDirection, TheRuleItselfRefuses) {
  EXPECT_FALSE(may_include("geometry", "kinematics/model/tool.hpp"));
  EXPECT_FALSE(may_include("sim", "kinematics/inverse/inverse.hpp"));
  EXPECT_FALSE(may_include("sim", "planner/contact.hpp"));
  EXPECT_FALSE(may_include("view", "planner/plan.hpp"));
  EXPECT_FALSE(may_include("planner", "post/post.hpp"));
  EXPECT_TRUE(may_include("sim", "kinematics/model/machine.hpp"));
  EXPECT_TRUE(may_include("app", "planner/plan.hpp"));
}

}  // namespace
