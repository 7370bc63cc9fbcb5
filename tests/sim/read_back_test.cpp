#include "sim/read_back.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "sim/verify.hpp"

namespace volute::sim {
namespace {

kinematics::Profile profile(const std::string& name) {
  auto loaded = kinematics::load_profile(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines", name);
  EXPECT_TRUE(loaded) << loaded.error().message;
  return loaded.value_or(kinematics::Profile{});
}

std::vector<CommandedPose> read(const std::string& text, const kinematics::Profile& p, const kinematics::Setup& setup) {
  ProgramReader reader(text, "test.nc", p.machine, p.control);
  auto poses = commanded_poses(reader, p.machine, setup, 100.0);
  EXPECT_TRUE(poses) << poses.error().message;
  return poses.value_or(std::vector<CommandedPose>{});
}

/// [Sun2016] eq. 22 for the head of the paper: axis = (sin C sin A, -cos C sin A, cos A).
Vec3 head_axis(double a_deg, double c_deg) {
  const double a = a_deg * std::numbers::pi / 180, c = c_deg * std::numbers::pi / 180;
  return {std::sin(c) * std::sin(a), -std::cos(c) * std::sin(a), std::cos(a)};
}

TEST(CommandedPoses, UnderTcpTheTipIsAsWritten) {
  const auto p = profile("ac-head-fanuc");
  const auto poses = read(
      "G21 G90 G17\nT1 M6\nS5000 M3\nG43.4 H1\nG0 X0 Y0 Z50 A0 C0\nG1 X10.5 Y-2 Z3 A20 C35 F250\nX11 A21\nG49\nM30\n",
      p, {});
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_LT((poses[0].pose.tip_P_mm - Vec3(10.5, -2, 3)).norm(), 1e-9);
  EXPECT_LT((poses[0].pose.axis_P - head_axis(20, 35)).norm(), 1e-12);
  EXPECT_EQ(poses[0].line, 6);
  EXPECT_LT((poses[1].pose.axis_P - head_axis(21, 35)).norm(), 1e-12);
}

// The rotaries stood at A20 C35 before the vectors: a block without I J K keeps the vector, not those.
TEST(CommandedPoses, AVectorHoldsWhenItsWordsAreLeftOut) {
  const auto p = profile("ac-head-fanuc-vector");
  const auto poses = read(
      "G21 G90 G17\nT1 M6\nS5000 M3\nG0 A20. C35.\nG43.5 H1\nG0 X0. Y0. Z50. I0.6 J0. K0.8\nG1 X10. Y0. Z3. I0. J0.6 "
      "K0.8 "
      "F250.\nX11.\nG49\nM30\n",
      p, {});
  ASSERT_EQ(poses.size(), 2u);
  for (const CommandedPose& pose : poses) EXPECT_LT((pose.pose.axis_P - Vec3(0, 0.6, 0.8)).norm(), 1e-12);
  EXPECT_LT((poses[1].pose.tip_P_mm - Vec3(11, 0, 3)).norm(), 1e-12);
}

TEST(ComparePoses, PassesOverWhatWasPutBetween) {
  const kinematics::ToolPose a{Vec3(0, 0, 0), Vec3::UnitZ()}, b{Vec3(1, 0, 0), Vec3::UnitZ()},
      middle{Vec3(0.5, 0, 0), Vec3::UnitZ()};
  EXPECT_TRUE(compare_poses({a, b}, {{a, 1}, {middle, 2}, {b, 3}}, {0.001, 0.001}).empty());
}

TEST(ComparePoses, APoseOffByMoreThanTheToleranceIsADisagreement) {
  const kinematics::ToolPose a{Vec3(0, 0, 0), Vec3::UnitZ()}, b{Vec3(1, 0, 0), Vec3::UnitZ()};
  kinematics::ToolPose off = b, turned = b;
  off.tip_P_mm.y() += 0.002;
  turned.axis_P = Vec3(0, std::sin(0.01), std::cos(0.01));
  EXPECT_TRUE(compare_poses({a, b}, {{a, 1}, {off, 2}}, {0.003, 0.001}).empty());
  const auto found = compare_poses({a, b}, {{a, 1}, {off, 2}}, {0.001, 0.001});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, "disagreement");
  EXPECT_EQ(found[0].line, 2);
  EXPECT_NEAR(found[0].value, 0.002, 1e-9);
  EXPECT_EQ(compare_poses({a, b}, {{a, 1}, {turned, 2}}, {0.001, 0.001}).size(), 1u);
}

TEST(ComparePoses, ALostPoseIsFoundAndOrderMatters) {
  std::vector<kinematics::ToolPose> expected;
  std::vector<CommandedPose> commanded;
  for (int i = 0; i < 100; ++i) {
    expected.push_back({Vec3(i, 0, 0), Vec3::UnitZ()});
    if (i != 40) commanded.push_back({expected.back(), i + 1});
  }
  const auto found = compare_poses(expected, commanded, {0.001, 0.001});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].text.find("path point 41"), std::string::npos);
  std::reverse(commanded.begin(), commanded.end());
  const auto reversed = compare_poses(expected, commanded, {0.001, 0.001});
  EXPECT_EQ(reversed.size(), 20u);
  EXPECT_NE(reversed.back().text.find("more points"), std::string::npos);
}

// G10 L2 gives the work offset in machine coordinates, and what the control leaves open is told in the report.
TEST(VerifyProgram, KnowsWhereTheSetupStandsAndTellsWarnings) {
  VerifyRequest request;
  request.profile = profile("ac-head-linuxcnc");
  request.text =
      "G21 G90 G94\nG10 L2 P1 X40 Y0 Z-900\nT1 M6\nG43 H1\nS1000 M3\nG0 X0 Y0 Z200 A0 C0\nG1 X50 F6000\nM2\n";
  request.file_name = "g10.ngc";
  const auto result = verify(request);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_NEAR(result->run.axes[0].position_max, 90.0, 1e-6);
  ASSERT_FALSE(result->run.warnings.empty());
  const auto told = std::count_if(result->warnings.begin(), result->warnings.end(),
                                  [](const Finding& warning) { return warning.kind == "program"; });
  EXPECT_EQ(told, static_cast<std::ptrdiff_t>(result->run.warnings.size()));
}

}  // namespace
}  // namespace volute::sim
