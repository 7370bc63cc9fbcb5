// One short program for every dialect, read once line by line against what the controls want. After a change that is
// meant, write them again with VOLUTE_WRITE_GOLDEN=1 and read the difference.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "geometry/file.hpp"
#include "tests/post/sample_paths.hpp"

namespace volute::post {
namespace {

std::filesystem::path golden_file(const std::string& name) {
  return std::filesystem::path(VOLUTE_SOURCE_DIR) / "tests/post/golden" / (name + ".txt");
}

void expect_golden(const std::string& name, const std::string& text) {
  if (std::getenv("VOLUTE_WRITE_GOLDEN") != nullptr) {
    std::filesystem::create_directories(golden_file(name).parent_path());
    ASSERT_TRUE(geometry::write_file(golden_file(name), text).has_value());
  }
  const auto golden = geometry::read_file(golden_file(name));
  ASSERT_TRUE(golden.has_value()) << golden.error().message;
  EXPECT_EQ(text, *golden);
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
  expect_golden(GetParam(), result->text);
}

INSTANTIATE_TEST_SUITE_P(Dialects, Golden,
                         ::testing::Values("ac-head-linuxcnc", "ac-head-fanuc", "ac-head-fanuc-vector",
                                           "ac-head-siemens", "ac-head-siemens-vector", "ac-head-heidenhain",
                                           "ac-head-heidenhain-vector", "xyzbc-table-haas", "xyzac-trunnion-mazak",
                                           "ac-head-g93", "linuxcnc-xyzac-linuxcnc-tcp", "bc-head-45-fanuc",
                                           "b-head-c-table-siemens"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(GoldenRewind, Fanuc) {
  // C limited to a little more than one turn: the pass of one and a half turns must lift off, rewind at the top of Z
  // and come back.
  kinematics::Profile profile = testing::profile_named("ac-head-fanuc");
  profile.machine.axes[4].travel_min = geometry::Angle::degrees(-200.0).radians();
  profile.machine.axes[4].travel_max = geometry::Angle::degrees(200.0).radians();
  const auto result = post(testing::request_for(testing::ring(1.5, 18)), profile);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  EXPECT_EQ(result->linearization.rewinds, 1);
  expect_golden("ac-head-fanuc-rewind", result->text);
}

}  // namespace
}  // namespace volute::post
