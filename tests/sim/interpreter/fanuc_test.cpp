#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/interpreter/reading.hpp"

namespace volute::sim::test {
namespace {

using kinematics::DialectFamily;
using ::testing::HasSubstr;

constexpr const char* finishing = R"(%
O0001 (PART FINISH 5AX)
N10 G21 G90 G94 G17 G40 G49 G80
N20 G53 G0 Z0.
N30 T1 M6
N40 G54
N50 S12000 M3
N60 G0 A-12.345 C45.678
N70 G05.1 Q1
N80 G43.4 H1 X10. Y20. Z150.
N90 M8
N100 G1 Z5. F3000.
N110 G1 X10.123 Y20.456 Z3.789 A-12.345 C45.678 F2500.
N900 G1 Z150. F5000.
N910 G49
N920 G05.1 Q0
N930 G53 G0 Z0.
N940 M9
N950 M5
N960 G53 G0 A0. C0.
N970 M30
%
)";

TEST(Fanuc, FinishingProgram) {
  const auto program = read(finishing, DialectFamily::fanuc);
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 9U);
  EXPECT_TRUE(program.blocks[0].machine_coordinates);
  EXPECT_EQ(program.blocks[1].kind, MotionKind::stop);
  EXPECT_FALSE(program.blocks[2].tcp);
  EXPECT_TRUE(program.blocks[3].tcp);
  EXPECT_EQ(program.blocks[3].kind, MotionKind::rapid);
  EXPECT_EQ(program.blocks[5].line, 13);
  EXPECT_DOUBLE_EQ(program.blocks[5].feed, 2500.0 / 60.0);
  EXPECT_TRUE(program.blocks[5].spindle_on);
  EXPECT_FALSE(program.blocks[7].tcp);
  EXPECT_TRUE(program.blocks[7].machine_coordinates);
  EXPECT_FALSE(program.blocks[7].tool_length_active);
  EXPECT_TRUE(program.warnings.empty());
}

TEST(Fanuc, VectorsUnderG435) {
  const auto program =
      read("G21\nG0 B10. C20.\nG43.5 H1 X0. Y0. Z9.\nG1 X1. I0. J3. K4. F100.\nX2.\nG49\nG0 B5.\nM30\n",
           DialectFamily::fanuc, 'B', 'C');
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 5U);
  ASSERT_TRUE(program.blocks[2].axis_vector);
  EXPECT_TRUE(program.blocks[2].axis_vector->isApprox(Vec3(0, 0.6, 0.8)));
  EXPECT_FALSE(program.blocks[3].axis_vector);
  EXPECT_FALSE(program.blocks[3].rotary_known[0]);
  EXPECT_EQ(read("G0 G43.5 H1 X0. Y0. Z9.\nG1 X1. I0. J0. K0. F100.\nM30\n", DialectFamily::fanuc).code(),
            "program-vector");
  EXPECT_EQ(read("G0 G43.4 H1 X0. Y0. Z9.\nG1 X1. I0. J0. K1. F100.\nM30\n", DialectFamily::fanuc).code(),
            "program-unknown-word");
}

TEST(Fanuc, RollOverTakesTheShortWay) {
  auto control = control_of(DialectFamily::fanuc);
  control.rotary_shortest_way = true;
  const auto program = read("G0 A0. C350.\nC10.\nG91 C20.\nM30\n", machine_with('A', 'C'), control);
  ASSERT_EQ(program.blocks.size(), 3U) << program.message();
  EXPECT_TRUE(program.blocks[1].rotary_shortest);
  EXPECT_DOUBLE_EQ(program.blocks[1].rotary_rad[1], 10.0 * rad_per_deg);
  EXPECT_TRUE(program.blocks[2].rotary_relative[1]);
  EXPECT_DOUBLE_EQ(program.blocks[2].rotary_rad[1], 20.0 * rad_per_deg);
}

TEST(Fanuc, IncrementalReferenceReturnMovesOnlyHome) {
  const auto program = read("G0 X1. Y1. Z1.\nG28 G91 Z0.\nG90 X5.\nM30\n", DialectFamily::fanuc);
  ASSERT_EQ(program.blocks.size(), 3U) << program.message();
  EXPECT_TRUE(program.blocks[1].machine_coordinates);
  EXPECT_EQ(program.blocks[1].xyz_programmed, (std::array<bool, 3>{false, false, true}));
  EXPECT_FALSE(program.blocks[2].xyz_known[2]);
}

TEST(Fanuc, Subprograms) {
  const auto program =
      read("%\nO1\nG0 X0.\nM98 P20002\nM98 P3 L3\nM30\nO2\nG91 G0 X1.\nM98 P3\nM99\nO3\nG90 G0 Y1.\nM99\n%\n",
           DialectFamily::fanuc);
  ASSERT_FALSE(program.error) << program.message();
  EXPECT_EQ(program.blocks.size(), 8U);
  EXPECT_EQ(read("M98 P7\nM30\n", DialectFamily::fanuc).code(), "program-subprogram");
  EXPECT_EQ(read("O1\nM98 P1\nM30\n", DialectFamily::fanuc).code(), "program-subprogram");
  EXPECT_EQ(read("O1\nG0 X1.\nO2\nM99\n", DialectFamily::fanuc).code(), "program-ended-early");
}

TEST(Fanuc, DwellAndExactStop) {
  const auto program =
      read("G0 X0.\nG4 P1500\nG4 X2.5\nG9 G1 X1. F100.\nX2.\nG61 X3.\nG64 X4.\nM30\n", DialectFamily::fanuc);
  ASSERT_EQ(program.blocks.size(), 7U) << program.message();
  EXPECT_DOUBLE_EQ(program.blocks[1].dwell_s, 1.5);
  EXPECT_DOUBLE_EQ(program.blocks[2].dwell_s, 2.5);
  EXPECT_EQ(program.blocks[3].path_mode, PathMode::exact_stop);
  EXPECT_EQ(program.blocks[4].path_mode, PathMode::continuous);
  EXPECT_EQ(program.blocks[5].path_mode, PathMode::exact_stop);
}

TEST(Fanuc, AWordWithoutDecimalPointIsToldOnce) {
  const auto program = read("G0 X10 Y0\nY7\nM30\n", DialectFamily::fanuc);
  ASSERT_EQ(program.warnings.size(), 1U);
  EXPECT_THAT(program.warnings[0], HasSubstr("p.nc:1: the word X10 has no decimal point"));
}

TEST(Fanuc, ControlsWithoutTcpRefuseIt) {
  const auto program = read("G43.4 H1 X0.\nM30\n", machine_with('A', 'C'), control_of(DialectFamily::fanuc, false));
  EXPECT_EQ(program.code(), "program-no-tcp");
}

TEST(Haas, PointControlAndSmoothing) {
  const auto program = read(
      "%\nO00001\nG21\nG187 P3 E0.05\nG0 B10. C20.\nG0 G234 H1\nX1. Y2. Z3.\nG1 Z0. F100.\nG49\nG53 G0 Z0.\nM30\n%\n",
      DialectFamily::haas, 'B', 'C');
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 4U);
  EXPECT_TRUE(program.blocks[1].tcp);
  EXPECT_DOUBLE_EQ(program.blocks[1].path_tolerance_mm, 0.05);
  EXPECT_FALSE(program.blocks[3].tcp);
  EXPECT_EQ(read("G43.4 H1\nM30\n", DialectFamily::haas).code(), "program-unknown-code");
  EXPECT_EQ(read("G254\nM30\n", DialectFamily::haas).code(), "program-unknown-code");
}

TEST(Mazak, PointControl) {
  const auto program =
      read("G21\nG5 P2\nG0 A1. C2.\nG43.4 H1 X1. Y2. Z3.\nG1 X2. F100.\nG49\nG5 P0\nM30\n", DialectFamily::mazak);
  ASSERT_EQ(program.blocks.size(), 3U) << program.message();
  EXPECT_TRUE(program.blocks[2].tcp);
}

}  // namespace
}  // namespace volute::sim::test
