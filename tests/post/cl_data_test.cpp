// CL data: out and in again, other systems' statements, and errors that name their line.
#include "post/cl_data.hpp"

#include <gmock/gmock.h>

#include "tests/post/sample_paths.hpp"

namespace volute::post {
namespace {

using kinematics::MoveKind;
using ::testing::HasSubstr;

ClData read(const std::string& text) {
  auto data = parse_cl(text, "test.cls");
  if (!data) ADD_FAILURE() << data.error().message;
  return data.value_or(ClData{});
}

TEST(ClData, ComesBackAsItWentOut) {
  ClData data;
  data.part_name = "dome";
  data.path = testing::dome_spiral(3, 40);
  data.path.points[50].move = MoveKind::link;
  data.path.points[60].feed_mm_s = 5.0;
  data.tool.number = 7;
  data.tool.cutter = *kinematics::parse_cutter("bull,6,1");
  data.tool.gauge_length_mm = 123.25;
  data.spindle_rpm = 9000;
  data.coolant = true;
  const ClData back = read(write_cl(data));
  EXPECT_EQ(back.part_name, "dome");
  EXPECT_TRUE(back.warnings.empty());
  EXPECT_EQ(back.tool.number, 7);
  EXPECT_EQ(back.tool.cutter.shape, kinematics::CutterShape::bull);
  EXPECT_EQ(back.tool.cutter.radius_mm, 6.0);
  EXPECT_EQ(back.tool.cutter.corner_radius_mm, 1.0);
  EXPECT_EQ(back.tool.gauge_length_mm, 123.25);
  EXPECT_EQ(back.spindle_rpm, 9000);
  EXPECT_TRUE(back.coolant);
  ASSERT_EQ(back.path.points.size(), data.path.points.size());
  for (std::size_t i = 0; i < back.path.points.size(); ++i) {
    EXPECT_EQ(back.path.points[i].move, data.path.points[i].move) << i;
    EXPECT_EQ(back.path.points[i].feed_mm_s, data.path.points[i].feed_mm_s) << i;
    EXPECT_LT((back.path.points[i].pose.tip_P_mm - data.path.points[i].pose.tip_P_mm).norm(), 1e-6) << i;
    EXPECT_LT((back.path.points[i].pose.axis_P - data.path.points[i].pose.axis_P).norm(), 1e-8) << i;
  }
}

TEST(ClData, ReadsWhatOtherSystemsWrite) {
  const ClData data = read(
      "PARTNO/1\n$$ a "
      "comment\nunit/mm\nCUTTER/6.5,0,3.25,1.95,31.,0,105.\nLOAD/TOOL,16\nSPINDL/3462,RPM,CLW\nCOOLNT/FLOOD\nrapid/\n"
      "GOTO/67.5,107.5,25.\nFEDRAT/ 120., $\n  MMPM\nGOTO / 1, 2 3 , 0,0.6,0.8 $$ "
      "trailing\nFEDRAT/IPM,10\nGODLTA/1,0,-0.5\nSPINDL/RPM,100,CLW\nFINI\nGOTO/9,9,9\n");
  ASSERT_EQ(data.path.points.size(), 3u);
  EXPECT_EQ(data.path.points[0].move, MoveKind::rapid);
  EXPECT_EQ(data.path.points[1].move, MoveKind::cut);
  EXPECT_EQ(data.path.points[1].feed_mm_s, 2.0);
  EXPECT_LT((data.path.points[1].pose.axis_P - geometry::Vec3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_NEAR(data.path.points[2].feed_mm_s, 254.0 / 60.0, 1e-12);
  EXPECT_LT((data.path.points[2].pose.tip_P_mm - geometry::Vec3(2, 2, 2.5)).norm(), 1e-12);
  EXPECT_EQ(data.tool.number, 16);
  EXPECT_EQ(data.spindle_rpm, 3462);
}

TEST(ClData, InchesBecomeMillimetres) {
  const ClData data = read("UNITS/INCHES\nCUTTER/0.5,0.25\nFEDRAT/60,IPM\nGOTO/1,0,0\n");
  EXPECT_EQ(data.path.points[0].pose.tip_P_mm.x(), 25.4);
  EXPECT_EQ(data.path.points[0].feed_mm_s, 25.4);
  EXPECT_EQ(data.tool.cutter.shape, kinematics::CutterShape::ball);
  EXPECT_EQ(data.tool.cutter.radius_mm, 6.35);
}

TEST(ClData, ArcsBecomeChordsOnTheCircle) {
  const ClData data = read(
      "FEDRAT/600,MMPM\nGOTO/10,0,0\nMOVARC/0,0,0,0,0,1,10,ANGLE,90\nGOTO/0,10,0\nCIRCLE/0,0,0,0,0,-1,10\nGOTO/"
      "10,0,0\n");
  EXPECT_GT(data.path.points.size(), 40u);
  double angle = 0.0;
  for (std::size_t i = 0; i < data.path.points.size(); ++i) {
    EXPECT_NEAR(data.path.points[i].pose.tip_P_mm.norm(), 10.0, 1e-9);
    EXPECT_GE(data.path.points[i].pose.tip_P_mm.x(), -1e-9) << "both quarters lie in x >= 0, y >= 0";
    if (i > 0)
      angle +=
          2.0 * std::asin(0.05 * (data.path.points[i].pose.tip_P_mm - data.path.points[i - 1].pose.tip_P_mm).norm());
  }
  EXPECT_NEAR(angle, std::numbers::pi, 1e-9);
}

TEST(ClData, DrillingCyclesArePassedOverWithAWord) {
  const ClData data =
      read("FEDRAT/600,MMPM\nGOTO/0,0,9\nCYCLE/DRILL,5\nGOTO/1,1,1\nGOTO/2,2,2\nCYCLE/OFF\nGOTO/3,3,3\n");
  EXPECT_EQ(data.path.points.size(), 2u);
  ASSERT_EQ(data.warnings.size(), 1u);
  EXPECT_THAT(data.warnings[0], HasSubstr("test.cls:3: 2 points"));
}

TEST(ClData, UnknownStatementsAreListedOnce) {
  const ClData data = read("FEDRAT/600,MMPM\nTRNTYP/1\nGOTO/0,0,9\nTRNTYP/2\n");
  EXPECT_THAT(data.warnings, ::testing::ElementsAre(HasSubstr("test.cls:2: TRNTYP is passed over (2 of them)")));
}

struct Bad {
  const char *text, *code, *says;
};

TEST(ClData, ErrorsNameTheLine) {
  const std::vector<Bad> bads = {{"FEDRAT/600,MMPM\nGOTO/1,2\n", "cl-syntax", "test.cls:2: GOTO/1,2"},
                                 {"FEDRAT/600,MMPM\nGOTO/1,2,3x\n", "cl-syntax", "test.cls:2"},
                                 {"FEDRAT/600,MMPM\n\nGOTO/1,2,3,0,0,0\n", "cl-syntax", "test.cls:3"},
                                 {"GOTO/1,2,3\n", "cl-syntax", "FEDRAT"},
                                 {"FEDRAT/0,MMPM\n", "cl-syntax", "test.cls:1"},
                                 {"FEDRAT/MMPM\n", "cl-syntax", "one number"},
                                 {"UNITS/FEET\n", "cl-syntax", "MM or INCHES"},
                                 {"FEDRAT/600,MMPM\nMOVARC/1,2\n", "cl-syntax", "centre and normal"},
                                 {"PARTNO/1\n", "cl-no-motion", "test.cls"},
                                 {"", "cl-no-motion", "no GOTO"}};
  for (const Bad& bad : bads) {
    const auto data = parse_cl(bad.text, "test.cls");
    ASSERT_FALSE(data.has_value()) << bad.text;
    EXPECT_EQ(data.error().code, bad.code) << bad.text;
    EXPECT_THAT(data.error().message, HasSubstr(bad.says));
  }
}

}  // namespace
}  // namespace volute::post
