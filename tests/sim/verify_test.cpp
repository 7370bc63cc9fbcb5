#include "sim/verify.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <filesystem>

#include "geometry/number_text.hpp"

namespace volute::sim {
namespace {

using geometry::fixed_text;
using geometry::Vec3;

geometry::TriangleMesh plate(double side) {
  return {{{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

/// Passes along y over the plate [0, side]^2 with an upright ball, under TCP; `depth_at_line` goes lower by 0.05 mm at
/// one pass.
std::string zigzag(double side, double interval, int deep_pass = -1) {
  std::string text = "G21 G90 G17\nT1 M6\nS5000 M3\nG43.4 H1\nG0 X0 Y-2 Z20 A0 C0\nG1 X0 Y-2 Z0 F1200\n";
  int pass = 0;
  for (double x = 0.0; x <= side + 1e-9; x += interval, ++pass) {
    const std::string z = pass == deep_pass ? "-0.05" : "0";
    const double from = pass % 2 == 0 ? -2.0 : side + 2.0, to = side - from;
    text += "X" + fixed_text(x, 3) + " Y" + fixed_text(from, 3) + " Z" + z + "\nY" + fixed_text(to, 3) + "\nZ0\n";
  }
  return text + "G0 Z20\nG49\nM30\n";
}

VerifyRequest request(std::string text) {
  VerifyRequest r;
  r.text = std::move(text);
  r.file_name = "plate.nc";
  auto profile = kinematics::load_profile(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines", "ac-head-fanuc");
  EXPECT_TRUE(profile) << profile.error().message;
  if (profile) r.profile = *profile;
  r.tool.cutter = {kinematics::CutterShape::ball, 2.0, 2.0, {}, 20.0, 2};
  r.tool.shank_radius_mm = 2.0;
  r.tool.holder = {{15, 15, 40, 40}};
  r.surface_P = plate(10.0);
  r.cut.uncut_limit_mm = 0.1;
  r.cut.gouge_limit_mm = 0.01;
  return r;
}

TEST(Verify, ACleanProgramHasNoFindingAndTheScallopOfItsInterval) {
  const auto result = verify(request(zigzag(10.0, 0.5)));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->findings.empty()) << result->findings.at(0).text;
  const double scallop = 2.0 - std::sqrt(4.0 - 0.0625);
  EXPECT_NEAR(result->cut->scallop_max_mm, scallop,
              0.02 * scallop + 0.001);  // the run's corners and servo lag move the tool a little
  EXPECT_EQ(result->collision->sim_hits, 0);
  EXPECT_GT(result->run.samples, 1000);
  EXPECT_EQ(result->trace.samples.size(), result->trace.poses_P.size());
  EXPECT_LE(result->trace.samples.size(), 200000u);
  EXPECT_TRUE(result->loads.known);
  EXPECT_GT(result->loads.axes[2].peak, 0.0);
}

TEST(Verify, AProgramTooDeepIsAGougeAtItsLine) {
  const auto result = verify(request(zigzag(10.0, 0.5, 7)));
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_FALSE(result->findings.empty());
  bool gouge = false;
  for (const Finding& f : result->findings) {
    if (f.kind != "gouge") continue;
    gouge = true;
    EXPECT_GE(f.line, 6 + 3 * 7 - 1);
    EXPECT_LE(f.line, 6 + 3 * 7 + 4);
  }
  EXPECT_TRUE(gouge);
  EXPECT_NEAR(result->cut->gouge_max_mm, 0.05, 0.002);
  for (std::size_t i = 1; i < result->findings.size(); ++i) {
    EXPECT_LE(severity(result->findings[i - 1].kind), severity(result->findings[i].kind));
  }
}

TEST(Verify, AMissingPassIsUncut) {
  auto r = request(zigzag(10.0, 3.0));
  const auto result = verify(r);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->cut->uncut);
}

TEST(Verify, ExpectedPosesAreComparedWithTheText) {
  auto r = request(zigzag(10.0, 2.5));
  r.expected_poses = {
      {Vec3(0, -2, 0), Vec3::UnitZ()}, {Vec3(0, 12, 0), Vec3::UnitZ()}, {Vec3(2.5, 12, 0.1), Vec3::UnitZ()}};
  r.expected_tolerance_mm = 0.001;
  r.expected_tolerance_rad = 1e-5;
  const auto result = verify(r);
  ASSERT_TRUE(result) << result.error().message;
  int disagreements = 0;
  for (const Finding& f : result->findings) disagreements += f.kind == "disagreement" ? 1 : 0;
  EXPECT_EQ(disagreements, 1);
  EXPECT_GT(result->commanded_points, 10);
}

TEST(Verify, BrokenTextIsAnErrorWithItsLine) {
  const auto result = verify(request("G21 G90\nG1 X1Y\nM30\n"));
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("plate.nc"), std::string::npos);
}

/// The stock stands 3 mm over the plate: a pass at feed takes it, a rapid through it is a finding where the stock was
/// given, and a word of warning where it was assumed.
TEST(Verify, ARapidThroughStockIsAFindingOrAWarning) {
  std::string text = zigzag(10.0, 0.5);
  const std::string plain = text;
  text.insert(text.find("G1 X0"), "G0 X20 Y5 Z1\nG0 X-20 Y5 Z1\nG0 Z20\n");
  for (const bool assumed : {true, false}) {
    auto r = request(text);
    StockSetup stock;
    stock.box_P_mm = Eigen::AlignedBox3d(Vec3(-1, -1, -2), Vec3(11, 11, 3));
    stock.assumed = assumed;
    r.stock = stock;
    r.picture_vertices_max = 3000;
    const auto result = verify(r);
    ASSERT_TRUE(result) << result.error().message;
    const auto& told = assumed ? result->warnings : result->findings;
    bool found = false;
    for (const Finding& f : told) found = found || (f.axis_or_pair == "cutter-stock" && f.line >= 5 && f.line <= 8);
    EXPECT_TRUE(found) << "assumed " << assumed;
    if (assumed) {
      for (const Finding& f : result->findings) EXPECT_EQ(f.axis_or_pair.find("stock"), std::string::npos) << f.text;
    }
    ASSERT_TRUE(result->stock && result->picture);
    EXPECT_GT(result->stock->report.first_mm3 - result->stock->report.left_mm3, 0.9 * 3 * 11 * 12);
    EXPECT_GT(result->stock->skin_P.triangles.size(), 1000u);
    EXPECT_LE(result->picture->mesh.vertices_mm.size(), 3000u);
  }
  auto r = request(plain);
  r.stock = StockSetup{{}, Eigen::AlignedBox3d(Vec3(-1, -1, -2), Vec3(11, 11, 3)), 0.0, false};
  const auto result = verify(r);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->findings.empty()) << result->findings.at(0).text;
}

TEST(Verify, AnOpenSolidAsStockIsRefused) {
  auto r = request(zigzag(10.0, 2.0));
  r.stock = StockSetup{plate(10.0), {}, 0.2, false};
  const auto result = verify(r);
  ASSERT_FALSE(result);
}

TEST(Verify, TellsTheTimeWithoutJerkLimitsWhereTheControlLimitsJerk) {
  VerifyRequest limited = request(zigzag(10.0, 0.5));
  VerifyRequest unlimited = limited;
  unlimited.profile.control.acceleration_profile = kinematics::AccelerationProfile::trapezoid;
  const auto slow = verify(limited), fast = verify(unlimited);
  ASSERT_TRUE(slow && fast);
  EXPECT_FALSE(fast->unlimited_jerk) << "a trapezoid has no jerk limit to take away";
  ASSERT_TRUE(slow->unlimited_jerk);
  EXPECT_EQ(slow->unlimited_jerk->cycle_time_s, fast->run.cycle_time_s);
  EXPECT_EQ(slow->unlimited_jerk->feed_loss_percent, fast->run.feed_loss_percent);
  EXPECT_EQ(slow->unlimited_jerk->machining_time_s, fast->machining_time_s);
  EXPECT_LT(fast->run.cycle_time_s, slow->run.cycle_time_s);
}

TEST(Verify, DoesNotDependOnTheNumberOfThreads) {
  const auto many = verify(request(zigzag(10.0, 0.7, 3)));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = verify(request(zigzag(10.0, 0.7, 3)));
  ASSERT_TRUE(many && single);
  EXPECT_EQ(many->cut->scallop_max_mm, single->cut->scallop_max_mm);
  EXPECT_EQ(many->cut->gouge_max_mm, single->cut->gouge_max_mm);
  EXPECT_EQ(many->collision->closest_mm, single->collision->closest_mm);
  EXPECT_EQ(many->loads.axes[2].rms, single->loads.axes[2].rms);
  ASSERT_EQ(many->findings.size(), single->findings.size());
  for (std::size_t i = 0; i < many->findings.size(); ++i) EXPECT_EQ(many->findings[i].text, single->findings[i].text);
}

}  // namespace
}  // namespace volute::sim
