// Proof by reading back: the simulator's own interpreter reads what the post wrote, for every profile, and its poses
// stand within rounding.
#include <gtest/gtest.h>

#include "sim/read_back.hpp"
#include "tests/post/sample_paths.hpp"

namespace volute::post {
namespace {

double angle_between(const geometry::Vec3& a, const geometry::Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The printed digits' worth at the tip and at the axis.
sim::ReadBackTolerance rounding_of(const kinematics::Control& control) {
  const double half_mm = 0.5 * std::pow(10.0, -control.linear_decimals) * (1.0 + 1e-6);
  const double half_rad = geometry::Angle::degrees(0.5 * std::pow(10.0, -control.rotary_decimals)).radians();
  constexpr double farthest_pivot_mm = 500.0;  // from any rotary axis of the shipped machines to the tip
  const bool vector = control.orientation_words == kinematics::OrientationWords::vector;
  return {std::sqrt(3.0) * half_mm + (control.tcp ? 0.0 : 2.0 * half_rad * farthest_pivot_mm),
          vector ? std::sqrt(3.0) * 0.5 * std::pow(10.0, -control.vector_decimals) : 2.0 * half_rad};
}

class ReadBack : public ::testing::TestWithParam<std::string> {};

TEST_P(ReadBack, EveryFeedBlockStandsWhereItWasPlanned) {
  const kinematics::Profile profile = testing::profile_named(GetParam());
  PostRequest request = testing::request_for(testing::dome_spiral(2, 90));
  const bool small = profile.machine.name == "linuxcnc-xyzac";
  if (small || profile.machine.name == "ab-head") request = testing::request_for(testing::ring(1.0, 40));
  if (small) request.setup.part_in_machine.translation() = geometry::Vec3(0, 0, -110);
  const auto posted = post(request, profile);
  ASSERT_TRUE(posted.has_value()) << posted.error().message;

  sim::ProgramReader reader(posted->text, "program", profile.machine, profile.control);
  const auto read = sim::commanded_poses(reader, profile.machine, request.setup, request.tool.gauge_length_mm);
  ASSERT_TRUE(read.has_value()) << read.error().message;
  std::vector<kinematics::ToolPose> planned;
  for (const kinematics::AxisPathPoint& point : posted->axis_path.points)
    if (point.move != kinematics::MoveKind::rapid) planned.push_back(point.pose);
  ASSERT_EQ(read->size(), planned.size()) << "one block for every feed point";
  const sim::ReadBackTolerance rounding = rounding_of(profile.control);
  double tip_worst_mm = 0.0, axis_worst_rad = 0.0;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    tip_worst_mm = std::max(tip_worst_mm, ((*read)[i].pose.tip_P_mm - planned[i].tip_P_mm).norm());
    axis_worst_rad = std::max(axis_worst_rad, angle_between((*read)[i].pose.axis_P, planned[i].axis_P));
  }
  EXPECT_LE(tip_worst_mm, rounding.tip_mm);
  EXPECT_LE(axis_worst_rad, rounding.axis_rad);
}

std::vector<std::string> all_profiles() {
  std::vector<std::string> names;
  const auto listed = kinematics::list_profiles(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines");
  for (const kinematics::ProfileName& name : *listed) names.push_back(name.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Profiles, ReadBack, ::testing::ValuesIn(all_profiles()), [](const auto& instance) {
  std::string name = instance.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace volute::post
