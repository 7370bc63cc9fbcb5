// Every dialect that the post writes: its golden programs are read to their end, by the profile that they were written
// for.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/sim/interpreter/reading.hpp"

namespace volute::sim::test {
namespace {

TEST(Dialects, GoldenProgramsOfThePostAreRead) {
  const std::filesystem::path root = VOLUTE_SOURCE_DIR;
  std::set<kinematics::DialectFamily> families;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "tests/post/golden")) {
    if (!entry.is_regular_file()) continue;
    std::string name = entry.path().stem().string();
    SCOPED_TRACE(name);
    if (name.ends_with("-rewind")) name.resize(name.size() - 7);
    const auto profile = kinematics::load_profile(root / "machines", name);
    ASSERT_TRUE(profile) << profile.error().message;
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const std::string program_text = text.str();
    const auto program = read(program_text, profile->machine, profile->control);
    EXPECT_FALSE(program.error) << program.message();
    EXPECT_TRUE(program.warnings.empty()) << program.warnings.front();
    int under_tcp = 0, vectors = 0, machine = 0;
    for (const MotionBlock& block : program.blocks) {
      under_tcp += block.tcp ? 1 : 0;
      vectors += block.axis_vector ? 1 : 0;
      machine += block.machine_coordinates ? 1 : 0;
      EXPECT_FALSE(block.tcp && block.machine_coordinates);
    }
    EXPECT_EQ(under_tcp > 0, profile->control.tcp);
    EXPECT_EQ(vectors > 0, profile->control.orientation_words == kinematics::OrientationWords::vector);
    EXPECT_GE(machine, 2) << "approach and retract are in machine coordinates";
    families.insert(profile->control.family);
  }
  EXPECT_EQ(families.size(), 6U);
}

}  // namespace
}  // namespace volute::sim::test
