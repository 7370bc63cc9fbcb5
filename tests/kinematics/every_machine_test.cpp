// Properties that hold for every file in machines/.
#include <gmock/gmock.h>

#include "geometry/number_text.hpp"
#include "kinematics/inverse/inverse.hpp"
#include "tests/kinematics/machine_fixture.hpp"

namespace volute::kinematics {
namespace {

using testing::angle_between;
using testing::Random;

constexpr double example_length_mm = 137.5;

class EveryMachine : public ::testing::TestWithParam<std::string> {
 protected:
  EveryMachine() : machine(testing::machine_named(GetParam())) {
    setup.part_in_machine =
        Eigen::Translation3d(12.5, -31.0, 40.25) * Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized());
  }

  [[nodiscard]] Vec3 pole_M() const {
    const bool third_first = std::find(machine.chain.begin(), machine.chain.end(), 3) <
                             std::find(machine.chain.begin(), machine.chain.end(), 4);
    return machine.axes[third_first ? 3 : 4].direction_M;
  }

  /// Every branch leads back to the pose. Returns the number of branches.
  std::size_t expect_round_trip(const ToolPose& pose) {
    const std::vector<AxisVector> solutions = solve(machine, setup, example_length_mm, pose);
    for (const AxisVector& q : solutions) {
      const ToolPose reached = tool_pose(machine, setup, example_length_mm, q);
      tip_error_mm = std::max(tip_error_mm, (reached.tip_P_mm - pose.tip_P_mm).norm());
      axis_error_rad = std::max(axis_error_rad, angle_between(reached.axis_P, pose.axis_P));
    }
    return solutions.size();
  }

  void expect_small_errors() {
    RecordProperty("tip_error_mm", geometry::shortest_text(tip_error_mm));
    RecordProperty("axis_error_rad", geometry::shortest_text(axis_error_rad));
    EXPECT_LT(tip_error_mm, 1e-9) << "seed " << testing::seed;
    EXPECT_LT(axis_error_rad, 1e-12) << "seed " << testing::seed;
  }

  Machine machine;
  kinematics::Setup setup;
  double tip_error_mm = 0.0, axis_error_rad = 0.0;
};

TEST_P(EveryMachine, ForwardOfInverseIsThePoseOnEveryBranch) {
  Random random;
  int reached = 0;
  const int count = cases(20000);
  for (int k = 0; k < count; ++k) reached += expect_round_trip({random.point(400.0), random.direction()}) > 0 ? 1 : 0;
  expect_small_errors();
  EXPECT_GT(reached, count / 3);  // a machine that reaches less than a third of all directions is a wrong file
}

TEST_P(EveryMachine, ForwardOfInverseIsThePoseNextToThePole) {
  Random random(1);
  const Vec3 pole_P = setup.part_in_machine.linear().transpose() * pole_M();
  const bool reaches_pole = !solve_rotaries(machine, pole_M()).empty();
  int branches = 0;
  for (int k = 0; k < cases(20000); ++k) {
    const double tilt = std::pow(10.0, random.uniform(-15.0, -1.0));
    const Vec3 axis_P = (pole_P + tilt * random.direction()).normalized();
    branches += static_cast<int>(expect_round_trip({random.point(400.0), axis_P}));
  }
  expect_small_errors();
  EXPECT_EQ(branches > 0, reaches_pole);
}

TEST_P(EveryMachine, TheFreeAxisTurnsFreelyAtThePole) {
  const std::vector<RotarySolution> solutions = solve_rotaries(machine, pole_M());
  if (solutions.empty()) GTEST_SKIP() << "the tool of " << machine.name << " never stands along the first rotary axis";
  ASSERT_EQ(solutions.size(), 1u);
  EXPECT_TRUE(solutions[0].at_pole);
  const bool third_first = std::find(machine.chain.begin(), machine.chain.end(), 3) <
                           std::find(machine.chain.begin(), machine.chain.end(), 4);
  EXPECT_EQ(third_first ? solutions[0].first_rad : solutions[0].second_rad, 0.0);
  for (const double turn : {0.0, 1.3, -2.9}) {
    AxisVector q = AxisVector::Zero();
    q[3] = third_first ? turn : solutions[0].first_rad;
    q[4] = third_first ? solutions[0].second_rad : turn;
    EXPECT_LT(angle_between(forward(machine, example_length_mm, q).linear().col(2), pole_M()), 1e-12) << turn;
  }
}

TEST_P(EveryMachine, InverseOfForwardHoldsTheStartingPositions) {
  Random random(2);
  for (int k = 0; k < cases(5000); ++k) {
    const AxisVector q = random.positions(machine);
    double nearest = 1e9;
    for (const AxisVector& found :
         solve(machine, setup, example_length_mm, tool_pose(machine, setup, example_length_mm, q))) {
      const double first = std::remainder(found[3] - q[3], 2.0 * std::numbers::pi),
                   second = std::remainder(found[4] - q[4], 2.0 * std::numbers::pi);
      nearest =
          std::min(nearest, (found.head<3>() - q.head<3>()).norm() + 100.0 * (std::abs(first) + std::abs(second)));
    }
    // Touching directions are ill-conditioned: an error of 1e-16 in the pose is one of 1e-8 in the angle.
    EXPECT_LT(nearest, 1e-4) << "seed " << testing::seed << " case " << k << " q " << q.transpose();
  }
}

TEST_P(EveryMachine, JacobianIsTheDerivativeOfForward) {
  Random random(3);
  constexpr double step = 1e-5;
  for (int k = 0; k < cases(500); ++k) {
    const AxisVector q = random.positions(machine);
    const Jacobian columns = jacobian(machine, example_length_mm, q);
    for (int i = 0; i < axis_count; ++i) {
      const AxisVector change = step * AxisVector::Unit(i);
      const Transform less = forward(machine, example_length_mm, q - change),
                      more = forward(machine, example_length_mm, q + change);
      const Vec3 tip = (more.translation() - less.translation()) / (2.0 * step);
      const Eigen::AngleAxisd turn(more.linear() * less.linear().transpose());
      EXPECT_LT((columns.col(i).head<3>() - tip).norm(), 1e-4) << machine.axes[static_cast<std::size_t>(i)].letter;
      EXPECT_LT((columns.col(i).tail<3>() - turn.angle() / (2.0 * step) * turn.axis()).norm(), 1e-6)
          << machine.axes[static_cast<std::size_t>(i)].letter;
    }
  }
}

TEST_P(EveryMachine, ProgramZeroPutsTheTipOnThePartOrigin) {
  const AxisVector zero = program_zero(machine, setup, example_length_mm);
  EXPECT_LT(tool_pose(machine, setup, example_length_mm, zero).tip_P_mm.norm(), 1e-9);
  EXPECT_EQ(zero[3], 0.0);
  EXPECT_EQ(zero[4], 0.0);
}

TEST_P(EveryMachine, PositiveLinearAxesMoveTheToolInThePositiveDirection) {
  // ISO 841: the direction is that of the tool relative to the workpiece, whichever of them moves.
  for (int i = 0; i < 3; ++i) {
    const Vec3 moved = forward(machine, example_length_mm, AxisVector::Unit(i)).translation() -
                       forward(machine, example_length_mm, AxisVector::Zero()).translation();
    EXPECT_LT((moved - Vec3::Unit(i)).norm(), 1e-12) << machine.axes[static_cast<std::size_t>(i)].letter;
  }
}

TEST_P(EveryMachine, LinksKeepTheirPlaceToEachOther) {
  // The link that carries the spindle moves with the tool, the table with the workpiece (frame M), the base with
  // neither.
  Random random(4);
  const AxisVector q = random.positions(machine);
  const int last = machine.chain.back();
  AxisVector stand = AxisVector::Zero();
  for (int i = 0; i < axis_count; ++i) stand[i] = machine.axes[static_cast<std::size_t>(i)].zero;
  if (machine.table_axes < axis_count) {
    EXPECT_LT((link_motion(machine, last, q).matrix() * forward(machine, example_length_mm, stand).matrix() -
               forward(machine, example_length_mm, q).matrix())
                  .norm(),
              1e-9);
  }
  if (machine.table_axes > 0) {
    EXPECT_LT((link_motion(machine, machine.chain.front(), q).matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-12);
  }
  if (machine.table_axes == 0) {
    EXPECT_LT((link_motion(machine, -1, q).matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Machines, EveryMachine, ::testing::ValuesIn(testing::machine_names()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace volute::kinematics
