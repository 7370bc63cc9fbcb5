// House rules that a reader can check by looking, checked by looking: folder READMEs, numbers as text, file length.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = VOLUTE_SOURCE_DIR;
const std::vector<std::string> library_folders{"geometry", "kinematics", "planner", "post", "sim", "view"};

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> sources_of(const std::vector<std::string>& folders) {
  std::vector<fs::path> files;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") files.push_back(entry.path());
  return files;
}

TEST(HouseRules, EveryFolderSaysWhatItIsFor) {
  for (const char* folder :
       {"geometry", "kinematics", "kinematics/model", "kinematics/inverse", "planner", "planner/surface",
        "planner/path", "planner/orientation", "post", "sim", "sim/interpreter", "sim/controller", "sim/machining",
        "view", "app", "machines", "examples", "tests", "bench"})
    EXPECT_TRUE(fs::exists(root / folder / "README.md")) << folder << " has no README.md";
}

/// Locale-dependent or exponent-prone ways from numbers to text; VOLUTE_CHECK's own stream is the only exception.
TEST(HouseRules, NumbersBecomeTextOnlyByNumberText) {
  for (const fs::path& file : sources_of(library_folders)) {
    if (file.filename() == "check.hpp" || file.filename() == "number_text.cpp" || file.filename() == "number_text.hpp")
      continue;
    const std::string text = text_of(file);
    for (const char* word : {"std::stod", "strtod", "sscanf", "snprintf", "sprintf", "atof(", "setprecision"})
      EXPECT_EQ(text.find(word), std::string::npos)
          << fs::relative(file, root) << " uses " << word << "; use geometry/number_text.hpp";
  }
}

TEST(HouseRules, LibrariesDoNotPrint) {
  const std::regex printing(R"(\bstd::c(out|err|log)\b|\b(f|v|vf)?printf\s*\(|\bf?puts\s*\()");
  for (const char* prints : {"std::cerr << 1", "printf(\"\")", "std::fputs (text, stderr)"})
    EXPECT_TRUE(std::regex_search(prints, printing)) << prints;
  EXPECT_FALSE(std::regex_search("filter.inputs(3)", printing));
  for (const fs::path& file : sources_of(library_folders)) {
    if (file.filename() == "check.cpp") continue;
    const std::string text = text_of(file);
    std::smatch found;
    EXPECT_FALSE(std::regex_search(text, found, printing))
        << fs::relative(file, root) << " prints with " << found.str();
  }
}

}  // namespace
