#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/interpreter/reading.hpp"

namespace volute::sim::test {
namespace {

using kinematics::DialectFamily;
using kinematics::OrientationInterpolation;
using ::testing::StartsWith;

Reading heidenhain(std::string_view text) { return read(text, DialectFamily::heidenhain); }

TEST(Heidenhain, FinishingProgram) {
  const auto program = heidenhain(R"(0 BEGIN PGM FINISH MM
1 BLK FORM 0.1 Z X-50 Y-50 Z-20
2 BLK FORM 0.2 X+50 Y+50 Z+0
3 L Z+0 R0 FMAX M91
4 TOOL CALL 1 Z S12000
5 CYCL DEF 32.0 TOLERANCE
6 CYCL DEF 32.1 T+0.013
7 CYCL DEF 32.2 HSC-MODE:0 TA0.5
8 M126
9 L A-12.345 C+45.678 R0 FMAX M3
10 M128                     ;or FUNCTION TCPM
11 L X+10 Y+20 Z+150 R0 FMAX M8
12 L Z+5 R0 F3000
13 L X+10.123 Y+20.456 Z+3.789 A-12.345 C+45.678 R0 F2500
14 LN X+1 Y+2 Z+3 NX+0 NY+0 NZ+1 TX+0.6 TY+0 TZ+0.8
* - a heading
90 L Z+150 R0 FMAX
91 M129
92 L Z+0 R0 FMAX M91
93 M127
94 L A+0 C+0 FMAX M94
95 M30
96 END PGM FINISH MM
)");
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 10U);
  EXPECT_TRUE(program.blocks[0].machine_coordinates);
  EXPECT_EQ(program.blocks[1].kind, MotionKind::stop);
  EXPECT_TRUE(program.blocks[2].rotary_shortest);
  EXPECT_TRUE(program.blocks[2].spindle_on);
  const MotionBlock& cut = program.blocks[5];
  EXPECT_EQ(cut.line, 14);
  EXPECT_TRUE(cut.tcp);
  EXPECT_EQ(cut.kind, MotionKind::line);
  EXPECT_DOUBLE_EQ(cut.feed, 2500.0 / 60.0);
  EXPECT_DOUBLE_EQ(cut.path_tolerance_mm, 0.013);
  EXPECT_DOUBLE_EQ(cut.rotary_tolerance_rad, 0.5 * rad_per_deg);
  EXPECT_TRUE(cut.tool_length_active);
  ASSERT_TRUE(program.blocks[6].axis_vector);
  EXPECT_TRUE(program.blocks[6].axis_vector->isApprox(Vec3(0.6, 0, 0.8)));
  EXPECT_DOUBLE_EQ(program.blocks[6].feed, 2500.0 / 60.0);
  EXPECT_EQ(program.blocks[7].kind, MotionKind::rapid);
  EXPECT_FALSE(program.blocks[8].tcp);
}

TEST(Heidenhain, TcpmFunction) {
  const std::string frame = "0 BEGIN PGM P MM\n";
  const auto program = heidenhain(frame +
                                  "1 FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\n2 L X+1 FMAX\n3 FUNCTION RESET "
                                  "TCPM\n4 L X+2 FMAX\n5 END PGM P MM\n");
  ASSERT_EQ(program.blocks.size(), 2U) << program.message();
  EXPECT_TRUE(program.blocks[0].tcp);
  EXPECT_EQ(program.blocks[0].orientation_interpolation, OrientationInterpolation::great_circle);
  EXPECT_FALSE(program.blocks[1].tcp);
  EXPECT_FALSE(program.blocks[1].orientation_interpolation);
  EXPECT_EQ(heidenhain(frame + "FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\n").code(), "program-unknown-word");
}

TEST(Heidenhain, CirclesAndIncrements) {
  const auto program = heidenhain(
      "0 BEGIN PGM P MM\nL X+0 Y+0 Z+0 FMAX\nCC X+5 Y+0\nC X+10 Y+0 DR- F100\nCR X+0 Y+0 R+5 DR+\nL IX+3 IY-1\nEND PGM "
      "P MM\n");
  ASSERT_EQ(program.blocks.size(), 4U) << program.message();
  EXPECT_NEAR(program.blocks[1].sweep_rad, -std::numbers::pi, 1e-12);
  EXPECT_NEAR(program.blocks[2].sweep_rad, std::numbers::pi, 1e-9);
  EXPECT_DOUBLE_EQ(program.blocks[3].xyz_mm.x(), 3.0);
  EXPECT_DOUBLE_EQ(program.blocks[3].xyz_mm.y(), -1.0);
}

TEST(Heidenhain, LabelsAndQParameters) {
  const auto program = heidenhain(R"(0 BEGIN PGM P MM
1 L X+0 Y+0 FMAX
2 LBL 1
3 L IX+1 FMAX
4 CALL LBL 1 REP 3
5 Q1 = 2 * (3 + 4)
6 FN 1: Q2 = +Q1 + +1
7 CALL LBL 5
8 FN 0: Q7 = +0
9 LBL 7
10 FN 1: Q7 = +Q7 + +1
11 L Y+Q7 FMAX
12 FN 12: IF +Q7 LT +3 GOTO LBL 7
13 STOP
14 M30
15 LBL 5
16 L X+Q2 FMAX
17 LBL 0
18 END PGM P MM
)");
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 10U);
  EXPECT_DOUBLE_EQ(program.blocks[4].xyz_mm.x(), 4.0);
  EXPECT_DOUBLE_EQ(program.blocks[5].xyz_mm.x(), 15.0);
  EXPECT_DOUBLE_EQ(program.blocks[8].xyz_mm.y(), 3.0);
  EXPECT_EQ(program.blocks[9].kind, MotionKind::stop);
}

TEST(Heidenhain, ReducingTurnsKeepsTheAxisWhereItStands) {
  const auto program = heidenhain("0 BEGIN PGM P MM\nL A+0 C+400 FMAX\nL C+0 FMAX M94\nEND PGM P MM\n");
  ASSERT_EQ(program.blocks.size(), 2U) << program.message();
  EXPECT_NEAR(program.blocks[1].rotary_rad[1], 360.0 * rad_per_deg, 1e-12);
}

TEST(Heidenhain, ToolCallDwellAndDatum) {
  const auto program = heidenhain(
      "0 BEGIN PGM P MM\nTOOL CALL \"BALL6\" Z S5000 F300\nCYCL DEF 9.0 DWELL\nCYCL DEF 9.1 DWELL 1.5\nCYCL DEF 7.0 "
      "DATUM SHIFT\nCYCL DEF 7.1 X+10\nL X+1 R0\nEND PGM P MM\n");
  ASSERT_EQ(program.blocks.size(), 3U) << program.message();
  EXPECT_DOUBLE_EQ(program.blocks[1].dwell_s, 1.5);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.x(), 11.0);
  EXPECT_DOUBLE_EQ(program.blocks[2].feed, 5.0);
}

TEST(Heidenhain, EveryWordIsUnderstoodOrRefusedByLineAndColumn) {
  struct Case {
    const char* text;
    const char* place;
    const char* code;
  };
  for (const Case& c :
       std::initializer_list<Case>{{"0 BEGIN PGM P INCH\n", "p.nc:1:8: ", "program-unknown-word"},
                                   {"1 L X+1 E+2 F9\n", "p.nc:1:9: ", "program-unknown-word"},
                                   {"1 L X+1 B+2 F9\n", "p.nc:1:9: ", "program-unknown-word"},
                                   {"1 L X+1 RL F9\n", "p.nc:1:9: ", "program-unknown-word"},
                                   {"1 L X+1\n", "p.nc:1:1: ", "program-no-feed"},
                                   {"1 L X+1 X+2 F9\n", "p.nc:1:9: ", "program-syntax"},
                                   {"1 L X+1 FMAX M77\n", "p.nc:1:14: ", "program-unknown-code"},
                                   {"1 CYCL DEF 200 DRILLING\n", "p.nc:1:12: ", "program-unknown-word"},
                                   {"1 PLANE SPATIAL SPA+45 SPB+0 SPC+0\n", "p.nc:1:9: ", "program-unknown-word"},
                                   {"1 CP IPA+90\n", "p.nc:1:3: ", "program-unknown-word"},
                                   {"1 CALL LBL 3\n", "p.nc:1:13: ", "program-subprogram"},
                                   {"1 L X+Q4 FMAX\n", "p.nc:1:7: ", "program-parameter"},
                                   {"1 M128\n2 TOOL CALL 1 Z\n", "p.nc:2:12: ", "program-tool-change"},
                                   {"1 L M140 MB MAX\n", "p.nc:1:5: ", "program-unknown-code"},
                                   {"1 L X+1 FMAX\n", "p.nc:1:1: ", "program-ended-early"}}) {
    const auto program = heidenhain(c.text);
    EXPECT_EQ(program.code(), c.code) << c.text;
    EXPECT_THAT(program.message(), StartsWith(c.place)) << c.text;
  }
}

}  // namespace
}  // namespace volute::sim::test
