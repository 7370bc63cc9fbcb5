// One short program for every dialect and the programs of the examples. Those of `short_pass` and of `arched-strip` are
// kept whole and were read line by line against what the controls want; of the others the size and a checksum are kept.
// After a change that is meant, write them again with scripts/update-example-programs and read the difference.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "geometry/file.hpp"
#include "tests/post/example_paths.hpp"
#include "tests/post/sample_paths.hpp"

namespace volute::post {
namespace {

/// `name`: in tests/post, without its ending.
void expect_kept(const std::string& name, const std::string& text) {
  const auto file = std::filesystem::path(VOLUTE_SOURCE_DIR) / "tests/post" / (name + ".txt");
  if (std::getenv("VOLUTE_WRITE_GOLDEN") != nullptr) {
    std::filesystem::create_directories(file.parent_path());
    ASSERT_TRUE(geometry::write_file(file, text).has_value());
  }
  const auto golden = geometry::read_file(file);
  ASSERT_TRUE(golden.has_value()) << golden.error().message;
  EXPECT_EQ(text, *golden);
}

/// FNV-1a, 64 bits: tells two texts apart, no more.
std::string checksum(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  std::ostringstream hex;
  hex << std::hex << std::setw(16) << std::setfill('0') << hash;
  return hex.str();
}

class Golden : public ::testing::TestWithParam<std::string> {};

TEST_P(Golden, ShortProgram) {
  const kinematics::Profile profile = testing::profile_named(GetParam());
  PostRequest request = testing::request_for(testing::short_pass());
  request.program_name = "short pass";
  if (GetParam().rfind("linuxcnc-xyzac", 0) == 0)
    request.setup.part_in_machine.translation() = geometry::Vec3(0, 0, -80);
  const auto result = post(request, profile);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  expect_kept("golden/" + GetParam(), result->text);
}

INSTANTIATE_TEST_SUITE_P(Dialects, Golden,
                         ::testing::Values("ac-head-linuxcnc", "ac-head-fanuc", "ac-head-fanuc-vector",
                                           "ac-head-siemens", "ac-head-siemens-vector", "ac-head-heidenhain",
                                           "ac-head-heidenhain-vector", "xyzbc-table-haas", "xyzac-trunnion-mazak",
                                           "ac-head-g93", "linuxcnc-xyzac-linuxcnc-tcp", "bc-head-45-fanuc",
                                           "b-head-c-table-siemens"),
                         [](const auto& instance) { return testing::identifier(instance.param); });

TEST(GoldenRewind, Fanuc) {
  // C limited to a little more than one turn: the pass of one and a half turns must lift off, rewind at the top of Z
  // and come back.
  kinematics::Profile profile = testing::profile_named("ac-head-fanuc");
  profile.machine.axes[4].travel_min = geometry::Angle::degrees(-200.0).radians();
  profile.machine.axes[4].travel_max = geometry::Angle::degrees(200.0).radians();
  const auto result = post(testing::request_for(testing::ring(1.5, 18)), profile);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  EXPECT_EQ(result->linearization.rewinds, 1);
  expect_kept("golden/ac-head-fanuc-rewind", result->text);
}

class GoldenExample : public ::testing::TestWithParam<std::string> {};

TEST_P(GoldenExample, ProgramInEveryDialect) {
  const PostRequest request = testing::example_request(GetParam());
  std::string sizes = "# program: blocks, bytes, checksum (FNV-1a)\n";
  for (const std::string& profile : testing::example_profiles()) {
    const auto result = post(request, testing::profile_named(profile));
    ASSERT_TRUE(result.has_value()) << profile << ": " << result.error().message;
    sizes += GetParam() + " on " + profile + ": " + std::to_string(result->blocks) + ", " +
             std::to_string(result->text.size()) + ", " + checksum(result->text) + "\n";
    if (GetParam() == "arched-strip") expect_kept("golden/arched-strip/" + profile, result->text);
  }
  expect_kept("examples/" + GetParam(), sizes);
}

INSTANTIATE_TEST_SUITE_P(Examples, GoldenExample, ::testing::ValuesIn(testing::example_names()),
                         [](const auto& instance) { return testing::identifier(instance.param); });

}  // namespace
}  // namespace volute::post
