// Along a path: branches, turns, rewinds, poles, linearization.
#include <gmock/gmock.h>

#include <iostream>

#include "geometry/number_text.hpp"
#include "kinematics/inverse/inverse.hpp"
#include "tests/kinematics/machine_fixture.hpp"

namespace volute::kinematics {
namespace {

using testing::angle_between;

constexpr double pi = std::numbers::pi;

Tool tool() {
  Tool tool;
  tool.gauge_length_mm = 120.0;
  return tool;
}

ToolPathPoint cut_at(const Vec3& tip_P_mm, const Vec3& axis_P) {
  ToolPathPoint point;
  point.pose = {tip_P_mm, axis_P.normalized()};
  point.feed_mm_s = 20.0;
  return point;
}

/// The tool leans by `tilt` towards where it goes, around a circle of radius 30 mm, `turns` times.
ToolPath circles(double turns, int points_per_turn, double tilt) {
  ToolPath path;
  for (int i = 0; i <= turns * points_per_turn; ++i) {
    const double azimuth = 2.0 * pi * i / points_per_turn;
    const Vec3 outward(std::cos(azimuth), std::sin(azimuth), 0.0);
    path.points.push_back(
        cut_at(30.0 * outward + Vec3(0, 0, 0.01 * i), std::sin(tilt) * outward + std::cos(tilt) * Vec3::UnitZ()));
  }
  return path;
}

/// The axis swings in one plane from one side to the other, passing the pole at a distance of `miss` rad.
ToolPath swing_through_pole(double miss, int points) {
  ToolPath path;
  for (int i = 0; i < points; ++i) {
    const double swing = 0.3 * (2.0 * i / (points - 1) - 1.0);
    path.points.push_back(cut_at({100.0 * swing, 0, 0}, {std::sin(swing), std::sin(miss), std::cos(swing)}));
  }
  return path;
}

AxisPathResult solved(const Machine& machine, const ToolPath& path, const AxisPathOptions& options = {}) {
  auto result = solve_path(machine, {}, tool(), path, options);
  if (!result) ADD_FAILURE() << result.error().message;
  return result.value_or(AxisPathResult{});
}

double tip_error(const Machine& machine, const AxisPathPoint& point) {
  return (tool_pose(machine, {}, tool().gauge_length_mm, point.q).tip_P_mm - point.pose.tip_P_mm).norm();
}

double axis_error(const Machine& machine, const AxisPathPoint& point) {
  return angle_between(tool_pose(machine, {}, tool().gauge_length_mm, point.q).axis_P, point.pose.axis_P);
}

TEST(Path, EveryPointReachesItsPose) {
  const Machine machine = testing::machine_named("ac-head");
  const AxisPathResult result = solved(machine, circles(3, 90, 0.5));
  ASSERT_FALSE(result.path.points.empty());
  for (const AxisPathPoint& point : result.path.points) {
    EXPECT_LT(tip_error(machine, point), 1e-9);
    EXPECT_LT(axis_error(machine, point), 1e-12);
  }
}

TEST(Path, EndlessAxisWindsOneTurnATurn) {
  const Machine machine = testing::machine_named("ac-head");
  const AxisPathResult result = solved(machine, circles(40, 60, 0.5));
  EXPECT_EQ(result.report.rewinds, 0);
  const double wound = result.path.points.back().q[4] - result.path.points.front().q[4];
  EXPECT_NEAR(std::abs(wound), 40 * 2.0 * pi, 1e-6);
  for (std::size_t i = 1; i < result.path.points.size(); ++i)
    EXPECT_LT(std::abs(result.path.points[i].q[4] - result.path.points[i - 1].q[4]), 0.2) << i;
}

TEST(Path, WindingPastTravelIsRewoundAsSeldomAsPossible) {
  Machine machine = testing::machine_named("ac-head");
  machine.axes[4].travel_min = -2.0 * pi;  // two turns of travel
  machine.axes[4].travel_max = 2.0 * pi;
  const AxisPathResult result = solved(machine, circles(7, 60, 0.5));
  // 7 turns in stretches of at most 2: no fewer than 3 rewinds; each stretch can use all of the travel but for where
  // points fall.
  EXPECT_GE(result.report.rewinds, 3);
  EXPECT_LE(result.report.rewinds, 4);
  int machine_moves = 0;
  for (const AxisPathPoint& point : result.path.points) {
    EXPECT_GE(point.q[4], -2.0 * pi - 1e-9);
    EXPECT_LE(point.q[4], 2.0 * pi + 1e-9);
    EXPECT_LT(tip_error(machine, point), 1e-9);
    machine_moves += point.machine_move ? 1 : 0;
  }
  EXPECT_EQ(machine_moves, 3 * result.report.rewinds);
}

TEST(Path, ARewindReturnsToThePoseItLeft) {
  Machine machine = testing::machine_named("ac-head");
  machine.axes[4].travel_min = -2.0 * pi;
  machine.axes[4].travel_max = 2.0 * pi;
  const std::vector<AxisPathPoint> points = solved(machine, circles(3, 60, 0.5)).path.points;
  int returns = 0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    if (points[i - 1].machine_move && !points[i].machine_move) {
      std::size_t left = i - 1;
      while (points[left].machine_move || points[left].source < 0) --left;
      EXPECT_LT((points[left].pose.tip_P_mm - points[i].pose.tip_P_mm).norm(), 1e-12);
      EXPECT_NEAR(std::abs(std::remainder(points[left].q[4] - points[i].q[4], 2.0 * pi)), 0.0, 1e-9);
      EXPECT_GT(std::abs(points[left].q[4] - points[i].q[4]), 1.9 * pi);
      ++returns;
    }
    if (points[i].machine_move && points[i - 1].machine_move && std::abs(points[i].q[4] - points[i - 1].q[4]) > 1.0) {
      EXPECT_EQ(points[i].q[2], *machine.axes[2].travel_max) << "C turns only at the top of Z";
    }
  }
  EXPECT_GE(returns, 1);
}

TEST(Path, ARewindFallsWhereTheToolIsOffThePartAnyway) {
  Machine machine = testing::machine_named("ac-head");
  machine.axes[4].travel_min = -3.0 * pi;
  machine.axes[4].travel_max = 3.0 * pi;
  ToolPath path = circles(4, 60, 0.5);
  path.points[130].move = MoveKind::rapid;  // a jump after a little more than two of the four turns; three would fit
  path.points[130].feed_mm_s = 0.0;
  const std::vector<AxisPathPoint> points = solved(machine, path).path.points;
  std::int32_t before_rewind = -1;
  for (std::size_t i = 1; i < points.size() && before_rewind < 0; ++i)
    if (points[i].machine_move)
      for (std::size_t k = i; k-- > 0 && before_rewind < 0;) before_rewind = points[k].source;
  EXPECT_EQ(before_rewind, 130) << "at the end of the jump";
  for (const AxisPathPoint& point : points) EXPECT_EQ(point.move == MoveKind::rapid, point.feed_mm_s == 0.0);
}

TEST(Path, ThroughThePoleTheBranchChangesAndCStandsStill) {
  const Machine machine = testing::machine_named("ac-head");
  const AxisPathResult result = solved(machine, swing_through_pole(0.0, 60));
  EXPECT_EQ(result.report.pole_crossings, 1);
  double c_min = 1e9, c_max = -1e9;
  for (const AxisPathPoint& point : result.path.points) {
    c_min = std::min(c_min, point.q[4]);
    c_max = std::max(c_max, point.q[4]);
  }
  EXPECT_LT(c_max - c_min, 1e-6);
}

TEST(Path, PastThePoleWithinTheToleranceTheAxisLeans) {
  const Machine machine = testing::machine_named("ac-head");
  const AxisPathOptions options;
  const AxisPathResult result = solved(machine, swing_through_pole(0.3 * options.rotary_tolerance_rad, 61), options);
  double widest = 0.0;
  for (std::size_t i = 1; i < result.path.points.size(); ++i) {
    widest = std::max(widest, std::abs(result.path.points[i].q[4] - result.path.points[i - 1].q[4]));
    EXPECT_LE(axis_error(machine, result.path.points[i]), options.rotary_tolerance_rad);
    EXPECT_LT(tip_error(machine, result.path.points[i]), 1e-9);
  }
  EXPECT_LT(widest, 0.1) << "C must not whip round";
}

TEST(Path, PastThePoleBeyondTheToleranceCTurnsAround) {
  const Machine machine = testing::machine_named("ac-head");
  AxisPathOptions options;
  const AxisPathResult result = solved(machine, swing_through_pole(0.05, 61), options);
  EXPECT_EQ(result.report.pole_crossings, 0);
  EXPECT_NEAR(std::abs(result.path.points.back().q[4] - result.path.points.front().q[4]), 2.0 * std::atan2(0.3, 0.05),
              0.05);
  EXPECT_LE(result.report.rotary_error_after_rad, options.rotary_tolerance_rad);
}

TEST(Path, ARunAtThePoleSpreadsTheTurnOfC) {
  const Machine machine = testing::machine_named("ac-head");
  ToolPath path;
  for (int i = 0; i < 10; ++i)
    path.points.push_back(cut_at({-20.0 + i, 0, 0}, {std::sin(0.01 * (10 - i)), 0, std::cos(0.01 * (10 - i))}));
  for (int i = 0; i < 30; ++i) path.points.push_back(cut_at({-10.0 + i, 0, 0}, Vec3::UnitZ()));
  for (int i = 0; i < 10; ++i)
    path.points.push_back(cut_at({20.0, 0.0 + i, 0}, {0, std::sin(0.01 * (i + 1)), std::cos(0.01 * (i + 1))}));
  const std::vector<AxisPathPoint> points = solved(machine, path).path.points;
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_LT(std::abs(points[i].q[4] - points[i - 1].q[4]), 0.5 * pi / 30 + 0.01) << i;
}

TEST(Path, ChangesBranchOffThePartWhereTravelEnds) {
  // C reaches 100 degrees to either side: one branch serves 200 degrees of a ring, the other branch the rest.
  Machine machine = testing::machine_named("ac-head");
  machine.axes[4].travel_min = geometry::Angle::degrees(-100.0).radians();
  machine.axes[4].travel_max = geometry::Angle::degrees(100.0).radians();
  const AxisPathResult result = solved(machine, circles(1, 72, 0.4));
  EXPECT_GE(result.report.rewinds, 1);
  EXPECT_LE(result.report.rewinds, 2);
  std::vector<int> visited(73, 0);
  for (const AxisPathPoint& point : result.path.points) {
    EXPECT_GE(point.q[4], *machine.axes[4].travel_min - 1e-12);
    EXPECT_LE(point.q[4], *machine.axes[4].travel_max + 1e-12);
    EXPECT_LT(tip_error(machine, point), 1e-9);
    EXPECT_LT(axis_error(machine, point), 1e-9);
    if (point.source >= 0) visited[static_cast<std::size_t>(point.source)]++;
  }
  for (const int count : visited) EXPECT_GE(count, 1) << "no point of the path may be lost";
  for (std::size_t i = 1; i < result.path.points.size(); ++i) {
    const AxisPathPoint &from = result.path.points[i - 1], &to = result.path.points[i];
    if (!to.machine_move && !from.machine_move) {
      EXPECT_LT(std::abs(to.q[3] - from.q[3]), 0.1) << "A changes its sign only over the top";
    }
  }
}

TEST(Path, AJumpInTheAirMayChangeBranchFreely) {
  const Machine machine = testing::machine_named("ac-head");
  ToolPath path;
  path.points = {cut_at({0, 0, 0}, {0.3, 0, 1}), cut_at({5, 0, 0}, {0.3, 0, 1}), cut_at({5, 0, 50}, {-0.3, 0, 1}),
                 cut_at({0, 0, 0}, {-0.3, 0, 1})};
  path.points[2].move = MoveKind::rapid;
  const AxisPathResult result = solved(machine, path);
  EXPECT_EQ(result.report.rewinds, 0);
}

TEST(Path, StartsAtTheTurnWhereTheAxesStand) {
  const Machine machine = testing::machine_named("ac-head");
  AxisPathOptions options;
  options.start = AxisVector(AxisVector::Zero());
  (*options.start)[4] = 20.0 * pi + 0.3;
  EXPECT_NEAR(solved(machine, circles(1, 60, 0.5), options).path.points.front().q[4], 20.0 * pi, pi);
}

TEST(Path, OutOfTravelIsRefusedWithTheReason) {
  const Machine machine = testing::machine_named("xyzbc-table");
  ToolPath path;
  path.points = {cut_at({0, 0, 0}, Vec3::UnitZ()), cut_at({1, 0, 0}, -Vec3::UnitZ() + 0.01 * Vec3::UnitX())};
  const auto result = solve_path(machine, {}, tool(), path, {});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, "axis-out-of-travel");
  EXPECT_THAT(result.error().message,
              ::testing::AllOf(::testing::HasSubstr("CC point 1"), ::testing::HasSubstr("B = "),
                               ::testing::HasSubstr("[-35, 120]"), ::testing::HasSubstr("xyzbc-table")));
}

TEST(Path, LinearTravelIsLookedAtToo) {
  const Machine machine = testing::machine_named("ac-head");
  ToolPath path;
  path.points = {cut_at({0, 0, 0}, Vec3::UnitZ()), cut_at({1200, 0, 0}, Vec3::UnitZ())};
  const auto result = solve_path(machine, {}, tool(), path, {});
  ASSERT_FALSE(result.has_value());
  EXPECT_THAT(result.error().message, ::testing::HasSubstr("X = 1200 mm is past [-1000, 1000] of ac-head"));
}

TEST(Path, WhatTheMachineCannotPointAtIsRefused) {
  const Machine machine = testing::machine_named("bc-head-45");
  ToolPath path;
  path.points = {cut_at({0, 0, 0}, {0.1, 0, -1})};
  const auto result = solve_path(machine, {}, tool(), path, {});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, "pose-unreachable");
}

TEST(Path, ANarrowTiltTakesTheBranchThatStaysWithin) {
  // B of this table reaches only -35 to 120: tilting by 80 degrees must use positive B all around.
  const Machine machine = testing::machine_named("xyzbc-table");
  for (const AxisPathPoint& point : solved(machine, circles(2, 60, 1.4)).path.points) EXPECT_GT(point.q[3], 0.0);
}

class Linearization : public ::testing::TestWithParam<std::string> {};

// Between written points the control moves every axis linearly: looked at densely, by forward kinematics alone.
void expect_within(const Machine& machine, const AxisPath& path, bool tcp, double tip_mm, double axis_rad) {
  double tip_worst = 0.0, axis_worst = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const AxisPathPoint &from = path.points[i - 1], &to = path.points[i];
    const double length = (to.pose.tip_P_mm - from.pose.tip_P_mm).norm(),
                 angle = angle_between(from.pose.axis_P, to.pose.axis_P);
    for (double t = 0.05; t < 1.0; t += 0.05) {
      const ToolPose pose = tool_pose(machine, {}, tool().gauge_length_mm, from.q + t * (to.q - from.q));
      const Vec3 along = to.pose.tip_P_mm - from.pose.tip_P_mm;
      const double share =
          length > 0.0 ? std::clamp((pose.tip_P_mm - from.pose.tip_P_mm).dot(along) / (length * length), 0.0, 1.0)
                       : 0.0;
      if (!tcp) tip_worst = std::max(tip_worst, (pose.tip_P_mm - from.pose.tip_P_mm - share * along).norm());
      const Vec3 circle =
          angle > 1e-9 ? Vec3((std::sin((1 - t) * angle) * from.pose.axis_P + std::sin(t * angle) * to.pose.axis_P) /
                              std::sin(angle))
                       : from.pose.axis_P;
      axis_worst = std::max(axis_worst, angle_between(pose.axis_P, circle));
    }
  }
  EXPECT_LT(tip_worst, 1.02 * tip_mm);
  EXPECT_LT(axis_worst, 1.02 * axis_rad);
}

TEST_P(Linearization, StaysWithinTheToleranceWithoutTcp) {
  const Machine machine = testing::machine_named(GetParam());
  AxisPathOptions options;
  options.control_keeps_tip = false;
  const AxisPathResult result = solved(machine, circles(1, 12, 0.4), options);
  EXPECT_GT(result.report.chordal_error_mm, 1.0) << "12 steps of 30 degrees bow the tip";
  EXPECT_LE(result.report.chordal_error_after_mm, options.chordal_tolerance_mm);
  expect_within(machine, result.path, false, options.chordal_tolerance_mm, options.rotary_tolerance_rad);
}

TEST(LinearizationAtThePole, StaysWithinTheToleranceWhereTheDeviationIsLopsided) {
  // Large steps past the pole: C turns mostly in the middle of each, so the deviation of the steps beside it leans to
  // one end.
  const Machine machine = testing::machine_named("ac-head");
  const AxisPathOptions options;
  for (const double miss : {0.004, 0.02, 0.05}) {
    const AxisPathResult result = solved(machine, swing_through_pole(miss, 4), options);
    expect_within(machine, result.path, true, options.chordal_tolerance_mm, options.rotary_tolerance_rad);
  }
}

TEST_P(Linearization, StaysWithinTheToleranceWithTcp) {
  const Machine machine = testing::machine_named(GetParam());
  const AxisPathOptions options;
  const AxisPathResult result = solved(machine, circles(1, 12, 0.4), options);
  EXPECT_EQ(result.report.chordal_error_mm, 0.0);
  EXPECT_GT(result.report.rotary_error_rad, options.rotary_tolerance_rad);
  expect_within(machine, result.path, true, options.chordal_tolerance_mm, options.rotary_tolerance_rad);
}

TEST_P(Linearization, NothingIsAddedWhenTheControlKeepsTheGreatCircle) {
  const Machine machine = testing::machine_named(GetParam());
  AxisPathOptions options;
  options.great_circle = true;
  EXPECT_EQ(solved(machine, circles(1, 12, 0.4), options).report.points_added, 0);
}

// The table of docs/linearization.md: the same ring, with and without TCP, before and after points are put in.
TEST_P(Linearization, TableOfErrors) {
  const Machine machine = testing::machine_named(GetParam());
  for (const int steps : {12, 36, 120}) {
    std::string row = "| " + GetParam() + " | " + std::to_string(steps);
    for (const bool tcp : {false, true}) {
      AxisPathOptions options;
      options.control_keeps_tip = tcp;
      const AxisPathReport report = solved(machine, circles(1, steps, 0.4), options).report;
      const auto mdeg = [](double rad) {
        return geometry::fixed_text(1e3 * geometry::Angle::radians(rad).degrees(), 1);
      };
      if (!tcp)
        row += " | " + geometry::fixed_text(1e3 * report.chordal_error_mm, 1) + " | " +
               geometry::fixed_text(1e3 * report.chordal_error_after_mm, 1);
      row += " | " + mdeg(report.rotary_error_rad) + " | " + mdeg(report.rotary_error_after_rad) + " | " +
             std::to_string(report.points_added);
      EXPECT_LE(report.chordal_error_after_mm, options.chordal_tolerance_mm);
      EXPECT_LE(report.rotary_error_after_rad, options.rotary_tolerance_rad);
    }
    std::cout << row << " |\n";
  }
}

INSTANTIATE_TEST_SUITE_P(Machines, Linearization,
                         ::testing::Values("ac-head", "bc-head-45", "xyzac-trunnion", "xyzbc-table", "b-head-c-table"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace volute::kinematics
