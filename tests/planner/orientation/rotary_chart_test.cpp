#include "planner/orientation/rotary_chart.hpp"

#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "planner/orientation/branch.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

TEST(RotaryChart, AxisAgreesWithForward) {
  kinematics::Machine machine = testing::ac_head();
  machine.axes[4].zero = 0.3;
  kinematics::Setup setup;
  setup.part_in_machine.linear() = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const RotaryChart chart(machine, setup);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (int n = 0; n < 100; ++n) {
    kinematics::AxisVector q = kinematics::AxisVector::Zero();
    q[3] = any(random);
    q[4] = any(random);
    const Vec3 axis = kinematics::tool_pose(machine, setup, 100.0, q).axis_P;
    EXPECT_NEAR((chart.axis_P({q[3], q[4]}) - axis).norm(), 0.0, 1e-14);
    const auto choices = chart.choices(axis);
    ASSERT_FALSE(choices.empty());
    for (const RotaryChoice& choice : choices) EXPECT_NEAR((chart.axis_P(choice.at) - axis).norm(), 0.0, 1e-9);
  }
}

TEST(RotaryChart, FollowsSunEq22) {
  const kinematics::Machine machine = testing::ac_head();
  const RotaryChart chart(machine, {});
  const double a = 0.4, c = 1.1;
  EXPECT_NEAR((chart.axis_P({a, c}) - Vec3(std::sin(c) * std::sin(a), -std::cos(c) * std::sin(a), std::cos(a))).norm(),
              0.0, 1e-15);
}

TEST(RotaryChart, NamesTheFreeAxisAtThePole) {
  const kinematics::Machine machine = testing::ac_head();
  const RotaryChart chart(machine, {});
  for (const RotaryChoice& choice : chart.choices(Vec3::UnitZ())) EXPECT_EQ(choice.free_axis, 1);
  for (const RotaryChoice& choice : chart.choices(Vec3(0.3, 0.1, 1.0).normalized())) EXPECT_EQ(choice.free_axis, -1);
}

TEST(Branches, WindTheEndlessAxisWithTheAxis) {
  const kinematics::Machine machine = testing::ac_head();
  const RotaryChart chart(machine, {});
  std::vector<PlacedAxis> axes;
  for (int i = 0; i <= 400; ++i) {
    const double c = 6.0 * std::numbers::pi * i / 400.0;
    axes.push_back({chart.axis_P({0.5, c}), 0.5 * i, false});
  }
  const BranchChoice choice = choose_branches(chart, axes);
  ASSERT_EQ(choice.unreachable, -1);
  const auto at = filled(choice, axes);
  EXPECT_NEAR(at.back()[1] - at.front()[1], 6.0 * std::numbers::pi, 1e-9);
  EXPECT_LT(choice.jump_max_rad, 0.06);
}

TEST(Branches, GoThroughThePoleInsteadOfRoundIt) {
  const kinematics::Machine machine = testing::ac_head();
  const RotaryChart chart(machine, {});
  std::vector<PlacedAxis> axes;
  for (int i = -50; i <= 50; ++i) axes.push_back({Vec3(0.0, -std::sin(0.01 * i), std::cos(0.01 * i)), i + 50.0, false});
  const BranchChoice choice = choose_branches(chart, axes);
  ASSERT_EQ(choice.unreachable, -1);
  EXPECT_FALSE(choice.at[50][1].has_value());  // at the pole C is free
  const auto at = filled(choice, axes);
  for (const Rotaries& r : at) EXPECT_NEAR(r[1], at.front()[1], 1e-9);
  EXPECT_NEAR(std::abs(at.back()[0] - at.front()[0]), 1.0, 1e-9);
}

TEST(Branches, StayWithinTravel) {
  kinematics::Machine machine = testing::ac_head();
  machine.axes[4].travel_min = -3.5;
  machine.axes[4].travel_max = 3.5;
  const RotaryChart chart(machine, {});
  std::vector<PlacedAxis> axes;
  for (int i = 0; i <= 100; ++i) axes.push_back({chart.axis_P({0.5, 2.9 + 0.005 * i}), 1.0 * i, false});
  const BranchChoice choice = choose_branches(chart, axes);
  for (const OptionalRotaries& at : choice.at) EXPECT_LE(std::abs(*at[1]), 3.5);
  EXPECT_LT(choice.jump_max_rad, 0.01);
}

}  // namespace
}  // namespace volute::planner
