// Machine and control files: every shipped one reads; every mistake is named with file, line and key.
#include <gmock/gmock.h>

#include <fstream>

#include "geometry/file.hpp"
#include "tests/kinematics/machine_fixture.hpp"

namespace volute::kinematics {
namespace {

using ::testing::HasSubstr;

std::filesystem::path scratch_folder() {
  const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto folder =
      std::filesystem::path(::testing::TempDir()) / ("volute_files_" + test + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  return folder;
}

/// The shipped file with one text replaced.
std::filesystem::path edited(const std::string& name, const std::string& from, const std::string& to) {
  std::string text = *geometry::read_file(testing::machines_folder() / name);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    ADD_FAILURE() << name << " does not contain " << from;
  } else {
    text.replace(at, from.size(), to);
  }
  const auto file = scratch_folder() / std::filesystem::path(name).filename();
  std::ofstream(file) << text;
  return file;
}

TEST(Profiles, EveryShippedProfileLoads) {
  const auto names = list_profiles(testing::machines_folder());
  ASSERT_TRUE(names.has_value()) << names.error().message;
  EXPECT_GE(names->size(), 6u * 3u);
  for (const ProfileName& name : *names) {
    const auto profile = load_profile(testing::machines_folder(), name.name);
    ASSERT_TRUE(profile.has_value()) << profile.error().message;
    EXPECT_EQ(profile->name, name.name);
    EXPECT_EQ(profile->machine.name, name.machine);
    EXPECT_EQ(profile->control.name, name.control);
    EXPECT_EQ(profile->machine.kind, name.kind);
    EXPECT_FALSE(profile->machine.shapes.empty());
  }
}

TEST(Profiles, AreFoundByPathToo) {
  const auto machine = testing::machines_folder() / "ac-head.toml";
  EXPECT_TRUE(load_profile(testing::machines_folder(), machine.string() + ":fanuc").has_value());
  EXPECT_TRUE(
      load_profile("/nowhere", machine.string() + ":" + (testing::machines_folder() / "controls/fanuc.toml").string())
          .has_value());
}

TEST(Profiles, AnUnknownOneListsTheNearest) {
  const auto profile = load_profile(testing::machines_folder(), "ac-hed-fanuk");
  ASSERT_FALSE(profile.has_value());
  EXPECT_EQ(profile.error().code, "profile-unknown");
  EXPECT_THAT(profile.error().message, HasSubstr("ac-head-fanuc"));
}

TEST(Profiles, AMachineMayAllowOnlySomeControls) {
  const auto profile = load_profile(testing::machines_folder(), "linuxcnc-xyzac-fanuc");
  ASSERT_FALSE(profile.has_value());
  EXPECT_EQ(profile.error().code, "profile-unknown");
}

struct Mistake {
  const char *file, *from, *to, *code, *says;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.file << ": " << mistake.says; }

class MachineMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(MachineMistakes, AreNamed) {
  const Mistake& mistake = GetParam();
  const auto machine = load_machine(edited(mistake.file, mistake.from, mistake.to));
  ASSERT_FALSE(machine.has_value());
  EXPECT_EQ(machine.error().code, mistake.code);
  EXPECT_THAT(machine.error().message, HasSubstr(mistake.says));
  EXPECT_THAT(machine.error().message, HasSubstr(mistake.file));
}

INSTANTIATE_TEST_SUITE_P(
    Machines, MachineMistakes,
    ::testing::Values(
        Mistake{"ac-head.toml", "title = \"A/C", "title = A/C", "machine-syntax", "ac-head.toml:"},
        Mistake{"ac-head.toml", "travel_mm = [-1000, 1000]", "travel_mm = [1000, -1000]", "machine-value",
                "first value must be below"},
        Mistake{"ac-head.toml", "travel_mm = [-1000, 1000]", "travel_mm = [-1000]", "machine-value",
                "list of 2 finite numbers"},
        Mistake{"ac-head.toml", "max_velocity_mm_min = 20000", "max_velocity_mm_min = -1", "machine-value",
                "axis.X.max_velocity_mm_min"},
        Mistake{"ac-head.toml", "max_jerk_mm_s3 = 30000\n", "\n", "machine-key", "axis.X.max_jerk_mm_s3"},
        Mistake{"ac-head.toml", "max_jerk_mm_s3", "max_jerk_m_s3", "machine-key", "no such key"},
        Mistake{"ac-head.toml", "head = [\"X\", \"Y\", \"Z\", \"C\", \"A\"]", "head = [\"X\", \"Y\", \"Z\", \"C\"]",
                "machine-chain", "must name X, Y, Z and two"},
        Mistake{"ac-head.toml", "head = [\"X\", \"Y\"", "head = [\"X\", \"X\"", "machine-value", "stand once"},
        Mistake{"ac-head.toml", "direction = [1, 0, 0]\npoint_mm", "direction = [0, 0, 1]\npoint_mm", "machine-chain",
                "parallel"},
        Mistake{"ac-head.toml", "direction = [0, 1, 0]", "direction = [1, 0, 0]", "machine-chain", "one plane"},
        Mistake{"ac-head.toml", "direction = [0, 0, 1]\npoint_mm", "direction = [0, 0, 0]\npoint_mm", "machine-value",
                "too short"},
        Mistake{"ac-head.toml", "endless = true", "endless = true\ntravel_deg = [0, 1]\n#", "machine-value",
                "contradict"},
        Mistake{"ac-head.toml", "velocity_feed_forward = 1.0", "velocity_feed_forward = 1.5", "machine-value",
                "between 0 and 1"},
        Mistake{"ac-head.toml", "moves_with = \"base\"", "moves_with = \"Q\"", "machine-value",
                "neither base nor an axis"},
        Mistake{"ac-head.toml", "min_mm = [-900, -900, -450]", "min_mm = [900, -900, -450]", "machine-value",
                "min_mm must lie below"},
        Mistake{"linuxcnc-xyzac.toml", "sign = -1   ", "sign = -2   ", "machine-value", "must be 1 or -1"}));

class ControlMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(ControlMistakes, AreNamed) {
  const Mistake& mistake = GetParam();
  const auto control = load_control(edited(mistake.file, mistake.from, mistake.to));
  ASSERT_FALSE(control.has_value());
  EXPECT_EQ(control.error().code, mistake.code);
  EXPECT_THAT(control.error().message, HasSubstr(mistake.says));
}

INSTANTIATE_TEST_SUITE_P(Controls, ControlMistakes,
                         ::testing::Values(Mistake{"controls/fanuc.toml", "family = \"fanuc\"", "family = \"fanuk\"",
                                                   "control-value", "none of linuxcnc, fanuc"},
                                           Mistake{"controls/fanuc.toml", "tcp_on = [\"G43.4 H{tool} {approach}\"]",
                                                   "tcp_on = []", "control-value", "tcp_on and tcp_off"},
                                           Mistake{"controls/fanuc.toml", "linear_decimals = 3",
                                                   "linear_decimals = 3.5", "control-value", "whole number"},
                                           Mistake{"controls/fanuc.toml", "servo_period_ms = 1.0",
                                                   "servo_period_ms = 0", "control-value", "above 0"},
                                           Mistake{"controls/linuxcnc.toml", "orientation = \"axes\"",
                                                   "orientation = \"vector\"", "control-value",
                                                   "vector words need tcp"},
                                           Mistake{"controls/linuxcnc.toml", "linuxcnc_planner = true",
                                                   "linuxcnc_planner = 1", "control-value", "true or false"}));

TEST(MachineFile, AMissingOneIsNamed) {
  const auto machine = load_machine("/nowhere/none.toml");
  ASSERT_FALSE(machine.has_value());
  EXPECT_THAT(machine.error().message, HasSubstr("/nowhere/none.toml"));
}

}  // namespace
}  // namespace volute::kinematics
