#include "sim/controller/axis_solver.hpp"

#include <gtest/gtest.h>

#include "tests/sim/controller/test_machines.hpp"

namespace volute::sim {
namespace {

using namespace test;

// Random positions: the solver must come back to the tip and axis that forward() says.
void expect_round_trip(const kinematics::Machine& machine) {
  const unsigned seed = 71;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> mm(-300, 300), tilt(-1.5, 1.5), turn(-3, 3), step(-0.05, 0.05);
  kinematics::Setup setup;
  setup.part_in_machine.translation() = Vec3(20, -30, 40);
  setup.part_in_machine.linear() = Eigen::AngleAxisd(0.3, Vec3::UnitZ()).toRotationMatrix();
  const AxisSolver solver(machine, setup, 120.0);
  for (int k = 0; k < cases(300); ++k) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " case " + std::to_string(k));
    AxisVector q;
    q << mm(random), mm(random), mm(random), tilt(random), turn(random);
    const auto pose = kinematics::tool_pose(machine, setup, 120.0, q);
    AxisVector from = q;
    from[3] += step(random);
    from[4] += step(random);
    const auto rotaries = solver.rotaries_along(pose.axis_P, from);
    ASSERT_TRUE(rotaries);
    AxisVector solved;
    solved << mm(random), mm(random), mm(random), (*rotaries)[0], (*rotaries)[1];
    const auto there = solver.with_tip(pose.tip_P_mm, solved);
    ASSERT_TRUE(there);
    const auto back = kinematics::tool_pose(machine, setup, 120.0, *there);
    EXPECT_LT((back.tip_P_mm - pose.tip_P_mm).norm(), 1e-9);
    EXPECT_LT((back.axis_P - pose.axis_P).norm(), 1e-11);
  }
}

TEST(AxisSolver, FindsTheAxesOfAHead) { expect_round_trip(head_machine()); }
TEST(AxisSolver, FindsTheAxesOfATable) { expect_round_trip(table_machine()); }

// Fanuc's rule: the smaller move of the master first, even if the slave moves far.
TEST(AxisSolver, TakesTheSmallerMoveOfTheMaster) {
  const auto machine = head_machine();
  const AxisSolver solver(machine, {}, 100.0);
  AxisVector at = AxisVector::Zero();
  at[3] = -0.4;
  AxisVector target = at;
  target[3] = 0.4;
  target[4] = 0.1;
  const Vec3 axis = kinematics::forward(machine, 100.0, target).linear().col(2);
  const auto rotaries = solver.rotaries_along(axis, at);
  ASSERT_TRUE(rotaries);
  EXPECT_NEAR((*rotaries)[0], 0.4, 1e-9);
  EXPECT_NEAR((*rotaries)[1], 0.1, 1e-9);
}

TEST(AxisSolver, LeavesTheMasterAloneAtThePole) {
  const auto machine = head_machine();
  const AxisSolver solver(machine, {}, 100.0);
  AxisVector at = AxisVector::Zero();
  at[3] = 0.7;
  at[4] = 1.3;
  const auto rotaries = solver.rotaries_along(Vec3::UnitZ(), at);
  ASSERT_TRUE(rotaries);
  EXPECT_NEAR((*rotaries)[0], 0.0, 1e-6);
  EXPECT_NEAR((*rotaries)[1], 1.3, 1e-9);
}

}  // namespace
}  // namespace volute::sim
