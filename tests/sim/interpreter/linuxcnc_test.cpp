#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/interpreter/reading.hpp"

namespace volute::sim::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Reading linuxcnc(std::string_view text) { return read(text, kinematics::DialectFamily::linuxcnc); }

void expect_point(const MotionBlock& block, double x, double y, double z) {
  EXPECT_NEAR(block.xyz_mm.x(), x, 1e-12);
  EXPECT_NEAR(block.xyz_mm.y(), y, 1e-12);
  EXPECT_NEAR(block.xyz_mm.z(), z, 1e-12);
}

TEST(Linuxcnc, FiveAxisLinesInInverseTime) {
  const auto program = linuxcnc(
      "g21 g90\nM428 ; TCP\nG93\nG0 X 1.5 Y-2 Z3. A-71.841 C -35.93\n"
      "G1 X1.25 Y-2.5 Z2 A-70 C-400 F 159\nm429\nm30\n");
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 2U);
  const MotionBlock& rapid = program.blocks[0];
  EXPECT_EQ(rapid.kind, MotionKind::rapid);
  EXPECT_EQ(rapid.line, 4);
  EXPECT_TRUE(rapid.tcp);
  expect_point(rapid, 1.5, -2.0, 3.0);
  EXPECT_DOUBLE_EQ(rapid.rotary_rad[0], -71.841 * rad_per_deg);
  const MotionBlock& line = program.blocks[1];
  EXPECT_EQ(line.feed_mode, FeedMode::inverse_time);
  EXPECT_DOUBLE_EQ(line.feed, 159.0 / 60.0);
  EXPECT_DOUBLE_EQ(line.rotary_rad[1], -400.0 * rad_per_deg);
  EXPECT_FALSE(line.rotary_shortest);
}

TEST(Linuxcnc, WhatTheProgramHasNotSaidIsNotKnown) {
  const auto program = linuxcnc("G0 X1\nG91 G0 Y2\nX3\nM2\n");
  ASSERT_EQ(program.blocks.size(), 3U) << program.message();
  EXPECT_EQ(program.blocks[0].xyz_known, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(program.blocks[1].xyz_relative, (std::array<bool, 3>{false, true, false}));
  EXPECT_DOUBLE_EQ(program.blocks[1].xyz_mm.y(), 2.0);
  EXPECT_FALSE(program.blocks[2].xyz_relative[0]);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.x(), 4.0);
  EXPECT_FALSE(program.blocks[2].rotary_known[0]);
}

TEST(Linuxcnc, SwitchingTcpForgetsLinearPositionsAndKeepsRotaries) {
  const auto program = linuxcnc("G0 X1 Y2 Z3 A4 C5\nM428\nG0 Z9\nM2\n");
  ASSERT_EQ(program.blocks.size(), 2U) << program.message();
  EXPECT_EQ(program.blocks[1].xyz_known, (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(program.blocks[1].rotary_known, (std::array<bool, 2>{true, true}));
  EXPECT_DOUBLE_EQ(program.blocks[1].rotary_rad[1], 5.0 * rad_per_deg);
}

TEST(Linuxcnc, FeedUnits) {
  const auto program = linuxcnc("G20 G0 X0 Y0 Z0 A0 C0\nG1 X1 F6\nG1 A90 F30\nG95 G1 X2 F0.01\nM2\n");
  ASSERT_EQ(program.blocks.size(), 4U) << program.message();
  EXPECT_DOUBLE_EQ(program.blocks[1].xyz_mm.x(), 25.4);
  EXPECT_DOUBLE_EQ(program.blocks[1].feed, 6.0 * 25.4 / 60.0);
  EXPECT_FALSE(program.blocks[1].rotary_only);
  EXPECT_TRUE(program.blocks[2].rotary_only);
  EXPECT_DOUBLE_EQ(program.blocks[2].feed, 30.0 / 60.0 * rad_per_deg);
  EXPECT_EQ(program.blocks[3].feed_mode, FeedMode::per_revolution);
  EXPECT_NEAR(program.blocks[3].feed, 0.254, 1e-15);
}

TEST(Linuxcnc, MotionWithoutFeedIsRefused) {
  EXPECT_EQ(linuxcnc("g1x1\n").code(), "program-no-feed");
  EXPECT_EQ(linuxcnc("G0X0\nG93 G1 X1 F2\nX2\nM2\n").code(), "program-no-feed");
  EXPECT_EQ(linuxcnc("G0X0\nF100\nG93 G1 X1 F2\nG94\nG1X2\nM2\n").code(), "program-no-feed");
}

TEST(Linuxcnc, ArcsInEveryPlane) {
  const auto program = linuxcnc(
      "G0 X0 Y0 Z0\nF100\nG17 G2 X10 Y0 I5 J0\nG3 X0 Y0 I-5 Z2\nG18 G2 X10 Z2 I5 K0\n"
      "G19 G3 Y4 Z2 R2\nG17 G2 I5\nG3 X14 Y8 R-4\nG3 X14 Y8 I-1 P3\nM2\n");
  ASSERT_EQ(program.blocks.size(), 8U) << program.message();
  const double pi = std::numbers::pi;
  EXPECT_NEAR(program.blocks[1].sweep_rad, -pi, 1e-12);
  EXPECT_TRUE(program.blocks[1].centre_mm.isApprox(Vec3(5, 0, 0)));
  EXPECT_NEAR(program.blocks[2].sweep_rad, pi, 1e-12);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.z(), 2.0);
  // G18: clockwise about +Y goes from +x to +z ... seen against Y; the end point is half a turn away in any case.
  EXPECT_TRUE(program.blocks[3].plane_normal.isApprox(Vec3::UnitY()));
  EXPECT_NEAR(program.blocks[3].sweep_rad, -pi, 1e-12);
  EXPECT_TRUE(program.blocks[4].plane_normal.isApprox(Vec3::UnitX()));
  EXPECT_NEAR(program.blocks[5].sweep_rad, -2.0 * pi, 1e-12);
  // R < 0: more than half a turn. From (10, 4) to (14, 8) the long way round, counter-clockwise, about (14, 4).
  EXPECT_NEAR(program.blocks[6].sweep_rad, 1.5 * pi, 1e-9);
  EXPECT_NEAR(program.blocks[7].sweep_rad, 6.0 * pi, 1e-12);
}

/// Property: turning the start about the centre by the sweep gives the end.
TEST(Linuxcnc, SweepLeadsFromStartToEnd) {
  const auto program =
      linuxcnc("G0 X3 Y-4 Z5\nF100\nG2 X4 Y3 R5\nG3 X-5 Y0 I-4 J-3\nG18 G2 X-2 Z8 R3\nG19 G3 Y3 Z11 J3\nM2\n");
  ASSERT_EQ(program.blocks.size(), 5U) << program.message();
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    const MotionBlock& arc = program.blocks[i];
    const Vec3 start = program.blocks[i - 1].xyz_mm;
    const Eigen::AngleAxisd turn(arc.sweep_rad, arc.plane_normal);
    EXPECT_LT((arc.centre_mm + turn * (start - arc.centre_mm) - arc.xyz_mm).norm(), 1e-9) << i;
  }
}

TEST(Linuxcnc, BadArcsAreRefused) {
  const std::string start = "G0 X0 Y0 Z0\nF100\n";
  EXPECT_EQ(linuxcnc(start + "G2 X10 Y0 I6\n").code(), "program-arc");
  EXPECT_EQ(linuxcnc(start + "G2 X10 Y0 R4.9\n").code(), "program-arc");
  EXPECT_EQ(linuxcnc(start + "G2 X10 Y0 K1\n").code(), "program-arc");
  EXPECT_EQ(linuxcnc(start + "G2 X0 Y0 R5\n").code(), "program-arc");
  EXPECT_EQ(linuxcnc(start + "G2 X10\n").code(), "program-arc");
  EXPECT_EQ(linuxcnc("F100\nG2 X10 Y0 I5\n").code(), "program-position-unknown");
}

TEST(Linuxcnc, PathModes) {
  const auto program = linuxcnc("G0 X0\nG64 P0.01 Q0.005 X1\nG61 X2\nG61.1 X3\nG64 X4\nG64 P0.02 X5\nM2\n");
  ASSERT_EQ(program.blocks.size(), 6U) << program.message();
  EXPECT_EQ(program.blocks[0].path_mode, PathMode::continuous);
  EXPECT_DOUBLE_EQ(program.blocks[1].path_tolerance_mm, 0.01);
  EXPECT_DOUBLE_EQ(program.blocks[1].naive_cam_tolerance_mm, 0.005);
  EXPECT_EQ(program.blocks[2].path_mode, PathMode::exact_path);
  EXPECT_EQ(program.blocks[3].path_mode, PathMode::exact_stop);
  EXPECT_LT(program.blocks[4].path_tolerance_mm, 0.0);
  EXPECT_DOUBLE_EQ(program.blocks[5].naive_cam_tolerance_mm, 0.02);
}

TEST(Linuxcnc, EveryWordIsUnderstoodOrRefusedByLineAndColumn) {
  struct Case {
    const char* text;
    const char* place;
    const char* code;
  };
  for (const Case& c : std::initializer_list<Case>{{"G0 X0\nG21 G99.9 X3\n", "p.nc:2:5: ", "program-unknown-code"},
                                                   {"G0 X1 E2\n", "p.nc:1:7: ", "program-unknown-word"},
                                                   {"G0 X1 B2\n", "p.nc:1:7: ", "program-unknown-word"},
                                                   {"G0 X1 X2\n", "p.nc:1:7: ", "program-syntax"},
                                                   {"G0 X1 I2\n", "p.nc:1:7: ", "program-unknown-word"},
                                                   {"G0 G1 X1\n", "p.nc:1:4: ", "program-syntax"},
                                                   {"G0 X\n", "p.nc:1:4: ", "program-syntax"},
                                                   {"G0 X1 (open\n", "p.nc:1:7: ", "program-syntax"},
                                                   {"G0 X1*57\n", "p.nc:1:6: ", "program-syntax"},
                                                   {"\n\nG41 D1\n", "p.nc:3:1: ", "program-unknown-code"},
                                                   {"G0 X1 M200\n", "p.nc:1:7: ", "program-unknown-code"},
                                                   {"X1\n", "p.nc:1:1: ", "program-no-motion"},
                                                   {"G0 X1,5\n", "p.nc:1:6: ", "program-syntax"},
                                                   {"G0 X1\n", "p.nc:1:1: ", "program-ended-early"}}) {
    const auto program = linuxcnc(c.text);
    EXPECT_EQ(program.code(), c.code) << c.text;
    EXPECT_THAT(program.message(), StartsWith(c.place)) << c.text;
    EXPECT_EQ(program.message().find('\n'), std::string::npos);
  }
}

TEST(Linuxcnc, PercentSignsOpenAndClose) {
  EXPECT_FALSE(linuxcnc("%\nG0 X1\n%\nthis is not read\n").error);
  EXPECT_EQ(linuxcnc("%\nG0 X1\n%\nrest").blocks.size(), 1U);
  EXPECT_FALSE(linuxcnc("G0 X1\r\nM2\r\n").error);
}

TEST(Linuxcnc, ExpressionsParametersAndFunctions) {
  const auto program = linuxcnc(
      "#<r> = 60\n#1=[2+3*4**2]\n#2=[-#1/[5 MOD 3]]\nG0 X#1 Y[#2] Z[#<r>*cos[60]]\n"
      "G0 X[atan[1]/[1]] Y-[3 gt 2] Z[fix[-2.5]+fup[1.1]]\n#100=[1 AND 0] #101=[10-4-3]\nG0 X##103 Y#101\nM2\n");
  EXPECT_EQ(program.code(), "program-parameter");  // ##103: parameter 0
  ASSERT_EQ(program.blocks.size(), 2U);
  expect_point(program.blocks[0], 50.0, -25.0, 30.0);
  expect_point(program.blocks[1], 45.0, -1.0, -1.0);
}

TEST(Linuxcnc, ParametersAreSetAfterTheirLineIsRead) {
  const auto program = linuxcnc("#5=1\n#5=2 G0 X#5\nG0 X#5\nM2\n");
  ASSERT_EQ(program.blocks.size(), 2U) << program.message();
  EXPECT_DOUBLE_EQ(program.blocks[0].xyz_mm.x(), 1.0);
  EXPECT_DOUBLE_EQ(program.blocks[1].xyz_mm.x(), 2.0);
}

TEST(Linuxcnc, LoopsConditionsAndSubprograms) {
  const auto program = linuxcnc(R"(o100 sub
G0 X#1 Y#2
o101 if [#2 gt 5]
  o100 return
o101 elseif [#2 eq 3]
  G0 Z33
o101 else
  G0 Z1
o101 endif
o100 endsub
o100 call [1] [9]
o100 call [2] [3] (comment)
o100 call [3] [4]
#9=0
o102 while [#9 lt 5]
  #9=[#9+1]
  o103 if [#9 eq 2]
    o102 continue
  o103 endif
  o104 if [#9 eq 4]
    o102 break
  o104 endif
  G0 X[100+#9]
o102 endwhile
o105 repeat [2]
  G0 X7
o105 endrepeat
#8=0
o106 do
  #8=[#8+1]
  G0 X[200+#8]
o106 while [#8 lt 3]
o107 repeat [0]
  G0 X-1
o107 endrepeat
M2
)");
  ASSERT_FALSE(program.error) << program.message();
  std::vector<double> x;
  for (const auto& block : program.blocks) x.push_back(block.xyz_programmed[0] ? block.xyz_mm.x() : -block.xyz_mm.z());
  EXPECT_THAT(x, ::testing::ElementsAre(1, 2, -33, 3, -1, 101, 103, 7, 7, 201, 202, 203));
}

TEST(Linuxcnc, RecursionKeepsItsOwnParameters) {
  const auto program = linuxcnc(
      "o<f> sub\no<a> if [#1 gt 0]\no<f> call [#1-1]\no<f> call [#1-1]\no<a> endif\nG0 X#1\no<f> endsub\n"
      "o<f> call [3]\nM2\n");
  ASSERT_FALSE(program.error) << program.message();
  EXPECT_EQ(program.blocks.size(), 15U);
  EXPECT_DOUBLE_EQ(program.blocks.back().xyz_mm.x(), 3.0);
}

TEST(Linuxcnc, EndlessProgramsAreRefused) {
  EXPECT_EQ(linuxcnc("o1 while [1]\n#1=2\no1 endwhile\nM2\n").code(), "program-endless");
  EXPECT_EQ(linuxcnc("o1 sub\no1 call\no1 endsub\no1 call\nM2\n").code(), "program-oword");
  EXPECT_EQ(linuxcnc("o1 while [1]\n").code(), "program-ended-early");
  EXPECT_EQ(linuxcnc("o1 while [0]\nM2\n").code(), "program-oword");
  EXPECT_EQ(linuxcnc("o1 call\nM2\n").code(), "program-oword");
}

TEST(Linuxcnc, ShiftsOfZero) {
  const auto program = linuxcnc("G0 X10 Y0 Z0\nG92 X2\nG1 X3 F10\nG10 L20 P1 Y5\nG1 Y6\nG92 X0 C0\nM2\n");
  EXPECT_EQ(program.code(), "program-position-unknown");  // C was never named
  ASSERT_EQ(program.blocks.size(), 3U);
  EXPECT_DOUBLE_EQ(program.blocks[1].xyz_mm.x(), 11.0);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.y(), 1.0);
}

TEST(Linuxcnc, G92OfAnAxisThatHasNotMovedTakesTheStartAndSaysSo) {
  const auto program =
      read_with_tool("G92 X5 A30\nG0 X5 A31\nG92.2\nG0 X5\nG92.3\nG0 X5\nG92.1\nG92.3\nG0 X5\nM2\n", 0.0);
  ASSERT_EQ(program.blocks.size(), 4U) << program.message();
  EXPECT_DOUBLE_EQ(program.blocks[0].xyz_mm.x(), 0.0);
  EXPECT_NEAR(program.blocks[0].rotary_rad[0], rad_per_deg, 1e-15);
  EXPECT_DOUBLE_EQ(program.blocks[1].xyz_mm.x(), 5.0);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.x(), 0.0);
  EXPECT_DOUBLE_EQ(program.blocks[3].xyz_mm.x(), 5.0);
  ASSERT_EQ(program.warnings.size(), 2U);
  EXPECT_NE(program.warnings[1].find("G92 gives A a value before the program has moved it"), std::string::npos);
  // What has moved to where the text does not tell is not at the start any more.
  for (const char* text : {"G91 G0 X5\nG92 X5\nM2\n", "G0 X1\nG43\nG92 X5\nM2\n", "M428\nG92 X5\nM2\n"})
    EXPECT_EQ(read_with_tool(text, 0.0).code(), "program-position-unknown") << text;
}

TEST(Linuxcnc, DynamicToolOffsetMovesTheTipByTheDifferenceToTheTool) {
  const auto program = read_with_tool(
      "G43\nG0 X10 Z20\nG43.1 Z50\nG0 Z30\nG43.1 X2\nG0 X11\nG43\nG0 X11 Z30\nG49\nG43.1 Z80\nG0 Z1\nM2\n", 80.0);
  ASSERT_EQ(program.blocks.size(), 5U) << program.message();
  EXPECT_DOUBLE_EQ(program.blocks[1].xyz_mm.z(), 30.0 + 50.0 - 80.0);
  EXPECT_DOUBLE_EQ(program.blocks[1].xyz_mm.x(), 10.0);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.x(), 13.0);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.z(), 0.0);
  EXPECT_DOUBLE_EQ(program.blocks[3].xyz_mm.z(), 30.0);
  EXPECT_DOUBLE_EQ(program.blocks[4].xyz_mm.z(), 1.0);  // the tool's own length: as G43
  EXPECT_TRUE(program.blocks[4].tool_length_active);
  ASSERT_EQ(program.warnings.size(), 1U);
  EXPECT_NE(program.warnings[0].find("X0 Y0 Z50 mm, the job's tool is 80 mm long"), std::string::npos);
}

TEST(Linuxcnc, DynamicToolOffsetIsRefusedWhereItWouldTurnAboutAnotherPoint) {
  EXPECT_EQ(read_with_tool("G43.1 Z80\nM428\nG0 X1\nM2\n", 80.0).message(), "");
  EXPECT_EQ(read_with_tool("G43.1 Z50\nM428\nM2\n", 80.0).code(), "program-tool-offset");
  EXPECT_EQ(read_with_tool("G43\nM428\nG43.1 Z50\nM2\n", 80.0).code(), "program-tool-offset");
  EXPECT_EQ(read_with_tool("G43.1\nM2\n", 80.0).code(), "program-syntax");
  EXPECT_EQ(read_with_tool("G43.1 A5\nM2\n", 80.0).code(), "program-syntax");
  EXPECT_EQ(read_with_tool("G43.1 Z5 G0 X4\nM2\n", 80.0).code(), "program-syntax");
  EXPECT_EQ(linuxcnc("G43.1 Z5\nM2\n").code(), "program-tool-offset");
}

TEST(Linuxcnc, WordsThatLeadOutOfAllMeasureAreRefused) {
  EXPECT_EQ(linuxcnc("G0 X1000000 C3600000\nM2\n").message(), "");
  for (const char* text : {"G0 X1000001\nM2\n", "G20\nG0 Z-39371\nM2\n", "G0 C3600001\nM2\n",
                           "G0 X900000 Y0\nG91\nG0 X900000\nM2\n", "G0 X0 Y0\nF1 G2 X9e9 I4.5e9\nM2\n"})
    EXPECT_TRUE(linuxcnc(text).error.has_value()) << text;
  EXPECT_NE(linuxcnc("G20\nG0 Z-39371\nM2\n").message().find("p.nc:2:1: Z leads to -1.00002e+06 mm"), std::string::npos)
      << linuxcnc("G20\nG0 Z-39371\nM2\n").message();
}

TEST(Linuxcnc, AByteOrderMarkIsNoPartOfTheProgram) {
  const auto program = linuxcnc("\xef\xbb\xbf%\nG0 X1\n%\n");
  ASSERT_EQ(program.blocks.size(), 1U) << program.message();
  EXPECT_EQ(program.blocks[0].line, 2);
  EXPECT_TRUE(linuxcnc("%\n\xef\xbb\xbfG0 X1\n%\n").error.has_value());
}

TEST(Linuxcnc, WorkOffsetsInMachineCoordinatesNeedTheSetup) {
  const std::string text = "G10 L2 P1 X100 Y0 Z0\nG0 X1 Y2\nM2\n";
  EXPECT_EQ(linuxcnc(text).code(), "program-set-data");
  ReaderOptions options;
  options.work_zero_machine_mm = Vec3(40, 0, 0);
  const auto program = read(text, machine_with('A', 'C'), control_of(kinematics::DialectFamily::linuxcnc), options);
  ASSERT_EQ(program.blocks.size(), 1U) << program.message();
  EXPECT_DOUBLE_EQ(program.blocks[0].xyz_mm.x(), 61.0);
}

TEST(Linuxcnc, MachineCoordinates) {
  const auto program = linuxcnc("G0 X1 Y1 Z1\nG53 G0 Z0\nG0 X2\nG28\nM2\n");
  ASSERT_EQ(program.blocks.size(), 4U) << program.message();
  EXPECT_TRUE(program.blocks[1].machine_coordinates);
  EXPECT_EQ(program.blocks[1].xyz_programmed, (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(program.blocks[2].xyz_known, (std::array<bool, 3>{true, true, false}));
  EXPECT_EQ(program.blocks[3].rotary_programmed, (std::array<bool, 2>{true, true}));
  EXPECT_EQ(linuxcnc("G0X0\nM428\nG53 G0 Z0\nM2\n").code(), "program-machine-tcp");
}

TEST(Linuxcnc, SpindleToolAndDwell) {
  const auto program = linuxcnc("S600 M3\nT4 M6\nG43 H4\nG0 Z1\nG4 P0.25\nM0\nM5\nG0 Z2\nM2\n");
  ASSERT_EQ(program.blocks.size(), 5U) << program.message();
  EXPECT_EQ(program.blocks[0].kind, MotionKind::stop);
  EXPECT_EQ(program.blocks[1].tool_number, 4);
  EXPECT_TRUE(program.blocks[1].tool_length_active);
  EXPECT_NEAR(program.blocks[1].spindle_rad_s, 600.0 * std::numbers::pi / 30.0, 1e-12);
  EXPECT_DOUBLE_EQ(program.blocks[2].dwell_s, 0.25);
  EXPECT_EQ(program.blocks[3].kind, MotionKind::stop);
  EXPECT_FALSE(program.blocks[4].spindle_on);
}

TEST(Linuxcnc, TcpByAnalogOutput) {
  auto control = control_of(kinematics::DialectFamily::linuxcnc);
  control.tcp_on = {"M68 E3 Q1", "M66 E0 L0"};
  control.tcp_off = {"M68 E3 Q0", "M66 E0 L0"};
  const auto program = read("M68 E3 Q1\nM66 E0 L0\nG0 X0\nM68 E3 Q0\nG0 X1\nM2\n", machine_with('A', 'C'), control);
  ASSERT_EQ(program.blocks.size(), 2U) << program.message();
  EXPECT_TRUE(program.blocks[0].tcp);
  EXPECT_FALSE(program.blocks[1].tcp);
}

}  // namespace
}  // namespace volute::sim::test
