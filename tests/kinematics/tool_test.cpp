// The tool's half section against the exact shapes, and the words that name cutters.
#include "kinematics/model/tool.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace volute::kinematics {
namespace {

using ::testing::HasSubstr;

Cutter cutter(const char* spec) {
  auto parsed = parse_cutter(spec);
  if (!parsed) ADD_FAILURE() << parsed.error().message;
  return parsed.value_or(Cutter{});
}

double polyline_radius(const std::vector<ProfilePoint>& profile, double z_mm) {
  double radius_mm = 0.0;
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const ProfilePoint &a = profile[k - 1], &b = profile[k];
    if (z_mm < a.z_mm || z_mm > b.z_mm || b.z_mm <= a.z_mm) continue;
    radius_mm = std::max(radius_mm, a.radius_mm + (z_mm - a.z_mm) / (b.z_mm - a.z_mm) * (b.radius_mm - a.radius_mm));
  }
  return radius_mm;
}

class Profile : public ::testing::TestWithParam<const char*> {};

TEST_P(Profile, NeverLiesInsideTheCutterAndAtMostToleranceOutside) {
  const Cutter shape = cutter(GetParam());
  constexpr double tolerance_mm = 0.002;
  const auto profile = cutter_profile(shape, tolerance_mm);
  EXPECT_EQ(profile.front().z_mm, 0.0);
  EXPECT_EQ(profile.front().radius_mm, 0.0);
  EXPECT_EQ(profile.back().z_mm, shape.length_mm);
  for (int k = 1; k < 2000; ++k) {
    const double z_mm = shape.length_mm * k / 2000.0;
    const double outside = polyline_radius(profile, z_mm) - cutter_radius_at(shape, z_mm);
    EXPECT_GE(outside, -1e-9) << z_mm;
    // Measured along the radius the gap grows where the arc is flat; across the arc it is the tolerance.
    const double slope = z_mm < shape.corner_radius_mm ? (shape.corner_radius_mm - z_mm) / shape.corner_radius_mm : 0.0;
    if (slope < 0.9) {
      EXPECT_LE(outside * std::sqrt(1.0 - slope * slope), 1.6 * tolerance_mm) << z_mm;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cutters, Profile, ::testing::Values("ball,3", "flat,5", "bull,6,1", "taper-ball,1,5"));

TEST(CutterRadius, IsExactByHand) {
  EXPECT_NEAR(cutter_radius_at(cutter("ball,5"), 1.0), 3.0, 1e-12);  // 3-4-5
  EXPECT_EQ(cutter_radius_at(cutter("ball,5"), 9.0), 5.0);
  EXPECT_EQ(cutter_radius_at(cutter("flat,5"), 0.0), 5.0);
  EXPECT_NEAR(cutter_radius_at(cutter("bull,8,5"), 1.0), 6.0, 1e-12);
  const double taper = 10.0 * M_PI / 180.0;
  EXPECT_NEAR(cutter_radius_at(cutter("taper-ball,2,10"), 12.0), 2.0 / std::cos(taper) + (12.0 - 2.0) * std::tan(taper),
              1e-12);
  EXPECT_EQ(cutter_radius_at(cutter("ball,5"), -0.1), 0.0);
  EXPECT_EQ(cutter_radius_at(cutter("ball,5"), 1000.0), 0.0);
}

TEST(AssemblyProfile, StacksShankAndHolder) {
  Tool tool;
  tool.shank_radius_mm = 4.0;
  tool.holder = {{10.0, 12.0, 40.0, 30.0}, {20.0, 20.0, 70.0, 15.0}};
  ASSERT_TRUE(validate(tool).has_value());
  const auto profile = assembly_profile(tool, 0.01);
  EXPECT_NEAR(polyline_radius(profile, 30.0), 4.0, 1e-12);
  EXPECT_NEAR(polyline_radius(profile, 55.0), 11.0, 1e-12);
  EXPECT_EQ(profile.back().z_mm, 85.0);
  EXPECT_EQ(profile.back().radius_mm, 20.0);
  for (std::size_t k = 1; k < profile.size(); ++k) EXPECT_GE(profile[k].z_mm, profile[k - 1].z_mm);
}

TEST(ParseCutter, RefusesWhatItCannotMean) {
  for (const char* spec : {"", "ball", "ball,0", "ball,-3", "ball,3,1", "bull,6", "bull,6,6", "bull,6,7", "cone,3",
                           "taper-ball,1,90", "ball,3x", "flat,nan"}) {
    const auto parsed = parse_cutter(spec);
    ASSERT_FALSE(parsed.has_value()) << spec;
    EXPECT_EQ(parsed.error().code, "cutter-spec");
    EXPECT_THAT(parsed.error().message, HasSubstr("\"" + std::string(spec) + "\""));
  }
}

TEST(ValidateTool, NamesTheKeyThatIsWrong) {
  const auto code = [](auto change) {
    Tool tool;
    change(tool);
    const auto valid = validate(tool);
    return valid ? std::string("valid") : valid.error().code;
  };
  EXPECT_EQ(code([](Tool&) {}), "valid");
  EXPECT_EQ(code([](Tool& t) { t.cutter.radius_mm = -1; }), "tool-radius");
  EXPECT_EQ(code([](Tool& t) { t.cutter.corner_radius_mm = 1; }), "tool-corner-radius");
  EXPECT_EQ(code([](Tool& t) { t.cutter.shape = CutterShape::bull; }), "tool-corner-radius");
  EXPECT_EQ(code([](Tool& t) { t.cutter.length_mm = 1; }), "tool-length");
  EXPECT_EQ(code([](Tool& t) { t.stick_out_mm = 10; }), "tool-stick-out");
  EXPECT_EQ(code([](Tool& t) { t.gauge_length_mm = 10; }), "tool-stick-out");
  EXPECT_EQ(code([](Tool& t) { t.holder = {{10, 10, 50, 5}}; }), "tool-holder");
  EXPECT_EQ(code([](Tool& t) { t.holder = {{0, 10, 40, 5}}; }), "tool-holder");
}

}  // namespace
}  // namespace volute::kinematics
