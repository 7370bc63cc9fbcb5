// Signs by hand: poses that follow from ISO 841 and each machine's description, not from the code.
// ISO 841: a positive rotary turns the TOOL right-handed about its axis as seen from the workpiece, whichever of the
// two moves.
#include "kinematics/inverse/inverse.hpp"
#include "tests/kinematics/machine_fixture.hpp"

namespace volute::kinematics {
namespace {

using testing::angle_between;

constexpr double half_pi = 0.5 * std::numbers::pi;

Vec3 tool_axis(const Machine& machine, char first, double first_deg, char second, double second_deg) {
  AxisVector q = AxisVector::Zero();
  q[machine.axis_index(first)] = geometry::Angle::degrees(first_deg).radians();
  q[machine.axis_index(second)] = geometry::Angle::degrees(second_deg).radians();
  return forward(machine, 100.0, q).linear().col(2);
}

void expect_axis(const Vec3& actual, const Vec3& expected) {
  EXPECT_LT(angle_between(actual, expected.normalized()), 1e-12) << actual.transpose();
}

TEST(Signs, AcHeadIsEquation22OfThePaper) {
  const Machine machine = testing::machine_named("ac-head");
  for (const double a : {-100.0, -30.0, 20.0, 75.0})
    for (const double c : {-200.0, -40.0, 10.0, 140.0}) {
      const double ra = geometry::Angle::degrees(a).radians(), rc = geometry::Angle::degrees(c).radians();
      expect_axis(tool_axis(machine, 'A', a, 'C', c),
                  {std::sin(rc) * std::sin(ra), -std::cos(rc) * std::sin(ra), std::cos(ra)});
    }
}

TEST(Signs, AcHeadAtAPlus90PointsItsToolFromMinusY) {
  // Right-handed about +X by 90 degrees: the spindle, once above, lies on the -Y side; the tip points to +Y.
  const Machine machine = testing::machine_named("ac-head");
  expect_axis(tool_axis(machine, 'A', 90, 'C', 0), {0, -1, 0});
  expect_axis(tool_axis(machine, 'A', 90, 'C', 90), {1, 0, 0});
}

TEST(Signs, AcHeadPivotLengthMovesTheTip) {
  // Pivot 250 mm above the gauge line, tool 100 mm: at A = 90 the tip stands 350 mm on the +Y side of the pivot.
  const Machine machine = testing::machine_named("ac-head");
  AxisVector q = AxisVector::Zero();
  q[3] = half_pi;
  const Vec3 upright = forward(machine, 100.0, AxisVector::Zero()).translation(),
             turned = forward(machine, 100.0, q).translation();
  EXPECT_LT((turned - (upright + Vec3(0, 350, 350))).norm(), 1e-9);
}

TEST(Signs, TrunnionIsSeenFromTheWorkpiece) {
  // The same positive angles as on the head turn the tool the same way in the part: only the table moves instead.
  const Machine head = testing::machine_named("ac-head"), table = testing::machine_named("xyzac-trunnion");
  for (const double a : {-90.0, 25.0})
    for (const double c : {-70.0, 120.0})
      expect_axis(tool_axis(table, 'A', a, 'C', c), tool_axis(head, 'A', a, 'C', c));
  expect_axis(tool_axis(table, 'A', 90, 'C', 0), {0, -1, 0});
}

TEST(Signs, TrunnionTableTurnsAgainstTheTool) {
  // A place 100 mm in +X of the part: at C = +90 the tool reaches it in machine -Y, because the table has turned by
  // -90.
  const Machine machine = testing::machine_named("xyzac-trunnion");
  const AxisVector reference = program_zero(machine, {}, 100.0);
  const AxisVector q = solve_linear(machine, 100.0, Vec3(100, 0, 0), 0.0, half_pi);
  EXPECT_NEAR(q[0] - reference[0], 0.0, 1e-9);
  EXPECT_NEAR(q[1] - reference[1], -100.0, 1e-9);
}

TEST(Signs, BcTableTiltsTheToolTowardsPlusX) {
  const Machine machine = testing::machine_named("xyzbc-table");
  expect_axis(tool_axis(machine, 'B', 90, 'C', 0), {1, 0, 0});
  expect_axis(tool_axis(machine, 'B', 90, 'C', 90), {0, 1, 0});
}

TEST(Signs, BHeadCTable) {
  const Machine machine = testing::machine_named("b-head-c-table");
  EXPECT_EQ(machine.kind, "head-table");
  expect_axis(tool_axis(machine, 'B', 30, 'C', 0), {0.5, 0, std::sqrt(0.75)});
  expect_axis(tool_axis(machine, 'B', 30, 'C', 180), {-0.5, 0, std::sqrt(0.75)});
}

TEST(Signs, NutatingHeadLiesLevelAtHalfATurn) {
  const Machine machine = testing::machine_named("bc-head-45");
  expect_axis(tool_axis(machine, 'B', 180, 'C', 0), {0, 1, 0});
  // cos tilt = (1 + cos B) / 2: at B = 90 the tilt is 60 degrees, and the axis has swung to +X as far as to +Y ... by
  // hand: (1/sqrt 2, 1/2, 1/2).
  expect_axis(tool_axis(machine, 'B', 90, 'C', 0), {std::sqrt(0.5), 0.5, 0.5});
}

TEST(Signs, LinuxcncSimulationTurnsAgainstIso841) {
  // Issue 2435: its shown angles are those of the table. A mirror of the trunnion's: +90 shows the part's +Y side.
  const Machine machine = testing::machine_named("linuxcnc-xyzac");
  expect_axis(tool_axis(machine, 'A', 90, 'C', 0), {0, 1, 0});
  EXPECT_LT(
      tool_axis(machine, 'A', 90, 'C', 0).dot(tool_axis(testing::machine_named("xyzac-trunnion"), 'A', 90, 'C', 0)),
      -0.999);
}

TEST(Signs, LinuxcncSimulationAgreesWithItsOwnKinematics) {
  // Its inverse as its source has it: x y z are programmed, world coordinates of the spindle's gauge line with the tool
  // length added.
  const Machine machine = testing::machine_named("linuxcnc-xyzac");
  testing::Random random;
  const double gauge_mm = 87.0, dy = 20.0, dz = 10.0 + gauge_mm;
  for (int k = 0; k < 200; ++k) {
    const Vec3 tip = random.point(60.0);
    const double a = random.uniform(-1.7, 0.8), c = random.uniform(-7.0, 7.0), x = tip.x(), y = tip.y(),
                 z = tip.z() + gauge_mm;
    const double sc = std::sin(c), cc = std::cos(c), sa = std::sin(a), ca = std::cos(a);
    const Vec3 joints(cc * x - sc * y, sc * ca * x + cc * ca * y - sa * z - ca * dy + sa * dz + dy,
                      sc * sa * x + cc * sa * y + ca * z - sa * dy - ca * dz + dz);
    EXPECT_LT((solve_linear(machine, gauge_mm, tip, a, c).head<3>() - joints).norm(), 1e-9);
  }
}

TEST(Signs, LinuxcncSimulationBringsPlusXToPlusYAtC90) {
  const Machine machine = testing::machine_named("linuxcnc-xyzac");
  const AxisVector q = solve_linear(machine, 0.0, Vec3(400, 0, 0), 0.0, half_pi);
  EXPECT_NEAR(q[0], 0.0, 1e-9);
  EXPECT_NEAR(q[1], 400.0, 1e-9);
}

}  // namespace
}  // namespace volute::kinematics
