#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/interpreter/reading.hpp"

namespace volute::sim::test {
namespace {

using kinematics::DialectFamily;
using kinematics::OrientationInterpolation;
using ::testing::StartsWith;

Reading siemens(std::string_view text) { return read(text, DialectFamily::siemens); }

TEST(Siemens, FinishingProgram) {
  const auto program = siemens(R"(%_N_FINISH_MPF
;$PATH=/_N_MPF_DIR
; %_N_FINISH_MPF
N10 G17 G90 G94 G40 G71
N20 G0 SUPA Z0 D0
N30 T1
N40 M6
N50 G54 D1
N60 CYCLE832(0.01,_ORI_FINISH,0.5)    ; profile string
N70 S12000 M3
N80 G0 A-12.345 C=DC(45.678)
N90 TRAORI
N100 ORIWKS
N110 ORIAXES
N120 M8
N130 G0 X10 Y20 Z150
N140 G1 Z5 F3000
N150 G1 X10.123 Y20.456 Z3.789 A-12.345 C45.678 F2500
N160 ORIVECT
N170 G1 X1 Y2 Z3 A3=0.36 B3=0.48 C3=0.8
N900 G0 Z150
N910 TRAFOOF
N920 CYCLE832()
N930 G0 SUPA Z0 D0
N940 M9
N950 M5
N960 M30
)");
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 9U);
  EXPECT_TRUE(program.blocks[0].machine_coordinates);
  EXPECT_FALSE(program.blocks[0].tool_length_active);
  EXPECT_EQ(program.blocks[1].kind, MotionKind::stop);
  EXPECT_EQ(program.blocks[1].tool_number, 1);
  EXPECT_FALSE(program.blocks[2].tcp);
  EXPECT_DOUBLE_EQ(program.blocks[2].path_tolerance_mm, 0.01);
  EXPECT_DOUBLE_EQ(program.blocks[2].rotary_tolerance_rad, 0.5 * rad_per_deg);
  const MotionBlock& cut = program.blocks[5];
  EXPECT_TRUE(cut.tcp);
  EXPECT_TRUE(cut.tool_length_active);
  EXPECT_EQ(cut.line, 18);
  EXPECT_DOUBLE_EQ(cut.feed, 2500.0 / 60.0);
  EXPECT_EQ(cut.orientation_interpolation, OrientationInterpolation::axes);
  EXPECT_DOUBLE_EQ(cut.rotary_rad[1], 45.678 * rad_per_deg);
  ASSERT_TRUE(program.blocks[6].axis_vector);
  EXPECT_TRUE(program.blocks[6].axis_vector->isApprox(Vec3(0.36, 0.48, 0.8)));
  EXPECT_EQ(program.blocks[6].orientation_interpolation, OrientationInterpolation::great_circle);
  EXPECT_LT(program.blocks[8].path_tolerance_mm, 0.0);
}

TEST(Siemens, ValuesOfAxes) {
  const auto program = siemens(
      "G90 G0 X10 C0 A0\nX=IC(5) Y=AC(3)\nG91 X1 Y=AC(4)\nG90 C=DC(350)\nC=ACP(10)\nC=ACN(5)\nR1=2 R2=R1*3+1\nX=R2 "
      "Z=-(R1+1)\nX=SIN(30)\nM30\n");
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 8U);
  EXPECT_DOUBLE_EQ(program.blocks[1].xyz_mm.x(), 15.0);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.x(), 16.0);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.y(), 4.0);
  EXPECT_NEAR(program.blocks[3].rotary_rad[1], -10.0 * rad_per_deg, 1e-12);
  EXPECT_NEAR(program.blocks[4].rotary_rad[1], 10.0 * rad_per_deg, 1e-12);
  EXPECT_NEAR(program.blocks[5].rotary_rad[1], 5.0 * rad_per_deg, 1e-12);
  EXPECT_DOUBLE_EQ(program.blocks[6].xyz_mm.x(), 7.0);
  EXPECT_DOUBLE_EQ(program.blocks[6].xyz_mm.z(), -3.0);
  EXPECT_NEAR(program.blocks[7].xyz_mm.x(), 0.5, 1e-15);
}

TEST(Siemens, TheShortWayFromAnUnknownTurnIsLeftToTheControl) {
  const auto program = siemens("G0 C=DC(45)\nG0 C=DC(50) A3\nG0 C=DC(50) A109\nG0 C=DC(50) A-109\nM30\n");
  ASSERT_EQ(program.blocks.size(), 3U) << program.message();
  EXPECT_TRUE(program.blocks[0].rotary_shortest);
  EXPECT_EQ(program.code(), "program-position-unknown");
}

TEST(Siemens, Arcs) {
  const auto program = siemens(
      "G0 X0 Y0 Z0\nF100\nG2 X10 Y0 CR=5\nG3 X0 Y0 AR=180\nG3 X10 Y0 I=AC(5) J=AC(0) TURN=1\nG2 X10 Y0 I-5 J0\nM30\n");
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 5U);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(program.blocks[1].sweep_rad, -pi, 1e-9);
  EXPECT_NEAR(program.blocks[2].sweep_rad, pi, 1e-7);
  EXPECT_NEAR(program.blocks[3].sweep_rad, 3.0 * pi, 1e-12);
  EXPECT_NEAR(program.blocks[4].sweep_rad, -2.0 * pi, 1e-12);
}

TEST(Siemens, FramesAndUnits) {
  const auto program = siemens("G0 X0 Y0\nTRANS X10\nX1\nATRANS X5 Y1\nX1 Y0\nTRANS\nX1\nG700 G1 X1 F10\nM30\n");
  ASSERT_FALSE(program.error) << program.message();
  ASSERT_EQ(program.blocks.size(), 5U);
  EXPECT_DOUBLE_EQ(program.blocks[1].xyz_mm.x(), 11.0);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.x(), 16.0);
  EXPECT_DOUBLE_EQ(program.blocks[2].xyz_mm.y(), 1.0);
  EXPECT_DOUBLE_EQ(program.blocks[3].xyz_mm.x(), 1.0);
  EXPECT_DOUBLE_EQ(program.blocks[4].xyz_mm.x(), 25.4);
  EXPECT_DOUBLE_EQ(program.blocks[4].feed, 254.0 / 60.0);
}

TEST(Siemens, EveryWordIsUnderstoodOrRefusedByLineAndColumn) {
  struct Case {
    const char* text;
    const char* place;
    const char* code;
  };
  for (const Case& c : std::initializer_list<Case>{{"G0 X1\nG1 X1 F10 FOO\n", "p.nc:2:11: ", "program-unknown-word"},
                                                   {"G0 X1 B3\n", "p.nc:1:7: ", "program-unknown-word"},
                                                   {"G41 X1\n", "p.nc:1:1: ", "program-unknown-code"},
                                                   {"G0 CYCLE800(1,2)\n", "p.nc:1:4: ", "program-unknown-word"},
                                                   {"CYCLE81(1,2\n", "p.nc:1:8: ", "program-syntax"},
                                                   {"G0 X\n", "p.nc:1:4: ", "program-syntax"},
                                                   {"G1 X1\n", "p.nc:1:1: ", "program-no-feed"},
                                                   {"A3=1\n", "p.nc:1:1: ", "program-vector"},
                                                   {"X1\n", "p.nc:1:1: ", "program-no-motion"},
                                                   {"G0 X1 I2\n", "p.nc:1:1: ", "program-unknown-word"},
                                                   {"G0 X=R7\n", "p.nc:1:6: ", "program-parameter"},
                                                   {"FGREF[C]=10\n", "p.nc:1:1: ", "program-unknown-word"},
                                                   {"IF R1==2\n", "p.nc:1:1: ", "program-unknown-word"},
                                                   {"G0 X1 ?\n", "p.nc:1:7: ", "program-syntax"},
                                                   {"TRAORI\nG0 SUPA Z0\n", "p.nc:2:1: ", "program-machine-tcp"},
                                                   {"G0 X1\n", "p.nc:1:1: ", "program-ended-early"}}) {
    const auto program = siemens(c.text);
    EXPECT_EQ(program.code(), c.code) << c.text;
    EXPECT_THAT(program.message(), StartsWith(c.place)) << c.text;
  }
}

}  // namespace
}  // namespace volute::sim::test
