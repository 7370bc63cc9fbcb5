// Rapids from rest to rest, planned of third order along their path.
#include "sim/controller/rest_move.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/controller/test_machines.hpp"

namespace volute::sim {
namespace {

using namespace test;

/// The quickest time from rest to rest over `way` under all three limits, by cases.
double double_s_time(double way, double v, double a, double j) {
  const double ramp = a / j;  // time to reach the acceleration
  if (v < a * ramp) {
    const double u = std::sqrt(v / j);
    if (2.0 * v * u <= way) return way / v + 2.0 * u;
  } else if (v * (v / a + ramp) <= way) {
    return way / v + v / a + ramp;
  }
  if (2.0 * a * ramp * ramp >= way) return std::cbrt(32.0 * way / j);
  return ramp + std::sqrt(ramp * ramp + 4.0 * way / a);
}

double unit_time(const SCurveShape& shape, double v, double a, double j) {
  const SCurve law(shape.jerk_share, shape.even_share);
  double speed = 0.0, acceleration = 0.0, jerk = 0.0;
  for (int k = 0; k <= 100'000; ++k) {
    const Progress at = law.at(k / 1e5);
    speed = std::max(speed, std::abs(at.speed));
    acceleration = std::max(acceleration, std::abs(at.acceleration));
    jerk = std::max(jerk, std::abs(at.jerk));
  }
  return std::max({speed / v, std::sqrt(acceleration / a), std::cbrt(jerk / j)});
}

TEST(SCurve, EndsAtRestAndItsDerivativesIntegrate) {
  std::mt19937 random(621);
  std::uniform_real_distribution<double> share(0.02, 1.0);
  for (int k = 0; k < cases(50); ++k) {
    const SCurve law(share(random), share(random) - 0.02);
    EXPECT_EQ(law.at(0.0).way, 0.0);
    EXPECT_EQ(law.at(1.0).way, 1.0) << "seed 621 case " << k;
    EXPECT_EQ(law.at(1.0).speed, 0.0);
    constexpr int steps = 20'000;
    double integral = 0.0;
    for (int i = 0; i < steps; ++i) {
      const Progress a = law.at(static_cast<double>(i) / steps), m = law.at((i + 0.5) / steps),
                     b = law.at((i + 1.0) / steps);
      EXPECT_GE(m.speed, 0.0);
      // A step may hold the end of a phase: then the jerk in its middle is not that of the whole step.
      const double jerk = law.at(0.0).jerk, dt = 1.0 / steps;
      ASSERT_NEAR(b.way - a.way, m.speed * dt, jerk * dt * dt * dt) << "seed 621 case " << k;
      ASSERT_NEAR(b.speed - a.speed, m.acceleration * dt, jerk * dt * dt) << "seed 621 case " << k;
      ASSERT_NEAR(b.acceleration - a.acceleration, m.jerk * dt, 2.0 * jerk * dt) << "seed 621 case " << k;
      integral += m.speed * dt;
    }
    EXPECT_NEAR(integral, 1.0, 1e-6);
  }
}

TEST(SCurve, QuickestShapeTakesTheClosedFormTime) {
  std::mt19937 random(622);
  std::uniform_real_distribution<double> power(-2.0, 2.0);
  for (int k = 0; k < cases(60); ++k) {
    const double v = std::pow(10.0, power(random)), a = std::pow(10.0, power(random)),
                 j = std::pow(10.0, power(random));
    const double expected = double_s_time(1.0, v, a, j);
    EXPECT_NEAR(unit_time(quickest_shape(v, a, j), v, a, j), expected, 1e-4 * expected) << "seed 622 case " << k;
  }
}

/// A circle of the linear axes while C turns: every derivative has a closed form.
AxisVector circle(double u) {
  AxisVector q;
  q << 300.0 * std::cos(2.0 * u), 300.0 * std::sin(2.0 * u), 40.0 * u, 0.3 * u, 2.0 * u;
  return q;
}

TEST(AxisCurve, FollowsACircleWithThreeDerivatives) {
  const auto curve = AxisCurve::through([](double u) { return std::optional(circle(u)); }, 14, 512);
  ASSERT_TRUE(curve);
  double off[4] = {};
  for (int k = 0; k <= 1000; ++k) {
    const double u = k / 1000.0;
    const CurvePoint at = curve->at(u);
    off[0] = std::max(off[0], (at.position - circle(u)).cwiseAbs().maxCoeff());
    off[1] = std::max(off[1], std::abs(at.first[0] + 600.0 * std::sin(2.0 * u)));
    off[2] = std::max(off[2], std::abs(at.second[0] + 1200.0 * std::cos(2.0 * u)));
    off[3] = std::max(off[3], std::abs(at.third[0] - 2400.0 * std::sin(2.0 * u)));
    EXPECT_EQ(curve->position(u), at.position);
    EXPECT_NEAR(at.first[4], 2.0, 1e-9);
  }
  EXPECT_LT(off[0], AxisCurve::accuracy);
  EXPECT_LT(off[1], 1e-5);
  EXPECT_LT(off[2], 1e-2);
  EXPECT_LT(off[3], 1.0);
}

TEST(AxisCurve, RangeHoldsEveryValueAndIsNotWide) {
  const auto curve = AxisCurve::through([](double u) { return std::optional(circle(u)); }, 14, 512);
  ASSERT_TRUE(curve);
  std::mt19937 random(623);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < cases(300); ++k) {
    double from = unit(random), to = unit(random);
    if (from > to) std::swap(from, to);
    const CurveRange range = curve->range(from, to);
    AxisVector low = AxisVector::Constant(1e9), high = -low;
    for (int i = 0; i <= 200; ++i) {
      const AxisVector third = curve->at(from + (to - from) * i / 200.0).third;
      low = low.cwiseMin(third);
      high = high.cwiseMax(third);
    }
    for (int axis = 0; axis < kinematics::axis_count; ++axis) {
      EXPECT_LE(range.third_low[axis], low[axis] + 1e-6) << "seed 623 case " << k;
      EXPECT_GE(range.third_high[axis], high[axis] - 1e-6) << "seed 623 case " << k;
    }
    EXPECT_LE(range.third_high[0] - range.third_low[0], high[0] - low[0] + 0.2 * 2400.0);
  }
}

TEST(AxisCurve, AFunctionWithoutAValueHasNoCurve) {
  EXPECT_FALSE(AxisCurve::through([](double u) { return u < 0.5 ? std::optional(circle(u)) : std::nullopt; }, 4, 512));
  EXPECT_FALSE(AxisCurve::through(
      [](double u) { return std::optional(AxisVector(circle(u) * (u < 0.45 ? 1.0 : 2.0))); }, 4, 64));
}

std::vector<MotionBlock> turning_rapid(const Vec3& from, const Vec3& to, double a0, double c0, double a1, double c1) {
  std::vector<MotionBlock> blocks(2, line_to(from, 100.0, a0, c0, true));
  blocks[1].xyz_mm = to;
  blocks[1].rotary_rad = {a1, c1};
  blocks[1].kind = MotionKind::rapid;
  return blocks;
}

// A table that turns C about the tip alone: the axis by itself, so the double S in closed form.
TEST(RestMove, AnAxisAloneTakesTheClosedFormTime) {
  const auto machine = table_machine();
  for (const double turn : {0.02, 0.3, 1.0, 3.0}) {
    const Ran run = run_blocks(machine, plain_control(), turning_rapid({0, 0, 0}, {0, 0, 0}, 0, 0, 0, turn));
    double begin = -1.0, end = 0.0;
    for (const AxisSample& sample : run.samples) {
      if (sample.velocity[4] == 0.0) continue;
      if (begin < 0.0) begin = sample.time_s - 0.001;
      end = sample.time_s;
    }
    EXPECT_NEAR(end - begin, double_s_time(turn, 2.0, 12.0, 400.0), 0.003) << turn;
  }
}

/// How far the tip leaves the straight line, and the greatest ratio to a limit, of the turning rapid.
struct Held {
  double off_mm = 0.0, ratio = 0.0, rapid_s = 0.0;
};
Held held(const kinematics::Machine& machine, const kinematics::Control& control,
          const std::vector<MotionBlock>& blocks) {
  const Ran run = run_blocks(machine, control, blocks);
  const Vec3 from = blocks[0].xyz_mm, way = blocks[1].xyz_mm - from;
  Held held;
  for (const AxisSample& sample : run.samples) {
    if (sample.line != 2 || sample.limit == Limit::stop) continue;  // before: line 1 comes to rest
    const Vec3 p = kinematics::tool_pose(machine, {}, 100.0, sample.position).tip_P_mm - from;
    const double share = way.norm() > 0.0 ? p.dot(way) / way.squaredNorm() : 0.0;
    held.off_mm = std::max(held.off_mm, (p - share * way).norm());
  }
  for (const AxisPeaks& peaks : run.report.axes) held.ratio = std::max(held.ratio, peaks.limit_ratio_max);
  held.rapid_s = run.report.time_by_cause_s.at("rapid");
  return held;
}

TEST(RestMove, TheTipStaysOnItsLineAndEveryLimitIsHeld) {
  std::mt19937 random(624);
  std::uniform_real_distribution<double> unit(-1, 1);
  double ratio = 0.0, most_off_mm = 0.0;
  for (int k = 0; k < cases(60); ++k) {
    const auto machine = k % 2 == 0 ? head_machine() : table_machine();
    const Vec3 from = 80.0 * Vec3(unit(random), unit(random), unit(random)),
               to = from + std::pow(10.0, 1.0 + unit(random)) * Vec3(unit(random), unit(random), unit(random));
    const auto blocks = turning_rapid(from, to, unit(random), 3 * unit(random), unit(random), 3 * unit(random));
    const Held one = held(machine, plain_control(), blocks);
    EXPECT_LE(one.off_mm, 1e-5) << "seed 624 case " << k;
    EXPECT_LE(one.ratio, 1.0 + 1e-9) << "seed 624 case " << k;
    ratio = std::max(ratio, one.ratio);
    most_off_mm = std::max(most_off_mm, one.off_mm);
  }
  EXPECT_GT(ratio, 0.99) << "no rapid came near a limit: the property was not tried";
  RecordProperty("most_off_mm", std::to_string(most_off_mm));
}

// The axis vector on the great circle is a smooth curve of the axes too, away from the pole and close to it.
TEST(RestMove, TheAxisVectorStaysOnItsGreatCircle) {
  std::mt19937 random(625);
  std::uniform_real_distribution<double> unit(-1, 1);
  kinematics::Control control = plain_control();
  control.orientation_interpolation = kinematics::OrientationInterpolation::great_circle;
  const auto machine = head_machine();
  int planned = 0;
  for (int k = 0; k < cases(40); ++k) {
    const Vec3 from = Vec3(unit(random), unit(random), 1.5).normalized(),
               to = Vec3(unit(random), unit(random), 1.5).normalized();
    auto blocks = turning_rapid({0, 0, 0}, {30, 10, -5}, 0, 0, 0, 0);
    blocks[0].axis_vector = from;
    blocks[1].axis_vector = to;
    const Ran run = run_blocks(machine, control, blocks);
    const Vec3 normal = from.cross(to).normalized();
    double off = 0.0, off_mm = 0.0;
    for (const AxisSample& sample : run.samples) {
      if (sample.line != 2 || sample.limit == Limit::stop) continue;
      const auto pose = kinematics::tool_pose(machine, {}, 100.0, sample.position);
      off = std::max(off, std::abs(pose.axis_P.dot(normal)));
      const Vec3 way = Vec3(30, 10, -5).normalized();
      off_mm = std::max(off_mm, (pose.tip_P_mm - pose.tip_P_mm.dot(way) * way).norm());
    }
    for (const AxisPeaks& peaks : run.report.axes)
      EXPECT_LE(peaks.limit_ratio_max, 1.0 + 1e-9) << "seed 625 case " << k;
    EXPECT_LE((kinematics::tool_pose(machine, {}, 100.0, run.samples.back().position).axis_P - to).norm(), 1e-9);
    if (off <= 1e-5 && off_mm <= 1e-4) ++planned;
  }
  EXPECT_GE(planned, cases(40) / 2);  // through the pole no smooth curve leads: what comes close to it is averaged
}

// With an average of its own the control file decides; a trapezoid needs no third order.
TEST(RestMove, AFilterOfTheControlFileStaysInForce) {
  const auto machine = head_machine();
  const auto blocks = turning_rapid({40, 0, 30}, {-40, 5, 30}, -0.6, -0.7, -0.5, 0.9);
  kinematics::Control filtered = plain_control(), steps = plain_control();
  filtered.filter_time_s = 0.02;
  steps.acceleration_profile = kinematics::AccelerationProfile::trapezoid;
  const Held plain = held(machine, plain_control(), blocks), average = held(machine, filtered, blocks),
             trapezoid = held(machine, steps, blocks);
  EXPECT_LT(plain.off_mm, 1e-5);
  EXPECT_GT(average.off_mm, 1e-4);
  EXPECT_GT(average.rapid_s, 1.2 * plain.rapid_s);
  EXPECT_LT(trapezoid.rapid_s, plain.rapid_s);
}

// Many short rapids in a row go through their corners together, as one averaged path: to rest at each would be slower.
TEST(RestMove, AChainOfShortRapidsDoesNotStop) {
  const auto machine = head_machine();
  std::vector<MotionBlock> blocks(1, line_to({0, 0, 0}, 100.0, 0.2, 0, true));
  for (int k = 1; k <= 300; ++k) {
    blocks.push_back(line_to({0.2 * k, 0, 0}, 0.0, 0.2, 0.005 * k, true));
    blocks.back().kind = MotionKind::rapid;
  }
  kinematics::Control control = plain_control();
  double time_s[2];
  for (const int look_ahead : {50, 1000}) {  // a chain that is longer than the look-ahead, and one that is not
    control.look_ahead_blocks = look_ahead;
    const Ran run = run_blocks(machine, control, blocks);
    int rests = 0;
    for (std::size_t k = 1; k < run.samples.size(); ++k)
      rests += run.samples[k].velocity.isZero(1e-9) && !run.samples[k - 1].velocity.isZero(1e-9) ? 1 : 0;
    EXPECT_LE(rests, 2) << look_ahead;
    for (const AxisPeaks& peaks : run.report.axes) EXPECT_LE(peaks.limit_ratio_max, 1.0 + 1e-9);
    time_s[look_ahead == 50 ? 0 : 1] = run.report.cycle_time_s;
  }
  EXPECT_NEAR(time_s[0], time_s[1], 0.02 * time_s[1]);
}

}  // namespace
}  // namespace volute::sim
