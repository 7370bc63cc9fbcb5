#include "sim/machining/stock_run.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>
#include <numbers>

#include "shapes.hpp"
#include "sim/machining/stock_setup.hpp"

namespace volute::sim {
namespace {

using geometry::Vec3;
using test::pose_at;

kinematics::Tool tool() {
  kinematics::Tool t;
  t.cutter = test::ball(3, 12);
  t.shank_radius_mm = 3;
  t.stick_out_mm = 20;
  t.holder = {{15, 15, 20, 20}};
  return t;
}

const Finding* finding_of(const StockReport& report, const std::string& pair) {
  for (const auto& f : report.findings) {
    if (f.axis_or_pair == pair) return &f;
  }
  return nullptr;
}

TEST(StockRun, VolumesByLineAddUp) {
  Stock stock = Stock::box({0, 0, 0}, {40, 40, 20}, 0.25);
  const std::vector<SweptPose> poses{pose_at({-5, 10, 18}, Vec3::UnitZ(), 1), pose_at({45, 10, 18}, Vec3::UnitZ(), 2),
                                     pose_at({45, 20, 18}, Vec3::UnitZ(), 3), pose_at({-5, 20, 18}, Vec3::UnitZ(), 4)};
  const auto report = run_through_stock(stock, tool(), poses, {});
  double sum = 0.0;
  for (const auto& l : report.removed) sum += l.removed_mm3;
  EXPECT_NEAR(report.first_mm3 - report.left_mm3, sum, 1e-6 * report.first_mm3);
  ASSERT_EQ(report.removed.size(), 2u);
  EXPECT_EQ(report.removed[0].line, 2);
  EXPECT_EQ(report.removed[1].line, 4);
  EXPECT_NEAR(report.removed[0].time_s, 0.1, 1e-9);
  EXPECT_TRUE(report.findings.empty());
}

/// Blocks shorter than the places stand apart still get what is theirs: a straight groove, the same section everywhere.
TEST(StockRun, ShortBlocksShareTheGrooveEvenly) {
  Stock stock = Stock::box({0, 0, 0}, {40, 30, 12}, 0.1);
  const double r = 3.0, depth = 2.0, step = 0.05;
  std::vector<SweptPose> poses;
  for (int k = 0; k <= 1000; ++k) poses.push_back(pose_at({-5 + step * k, 15, 12 - depth}, Vec3::UnitZ(), k + 1));
  const auto report = run_through_stock(stock, tool(), poses, {});
  const double half = std::acos((r - depth) / r), section = r * r * (half - std::sin(half) * std::cos(half));
  int looked = 0;
  for (std::size_t i = 0; i + 20 < report.removed.size(); i += 20) {  // a millimetre each, away from the ends
    double volume = 0.0;
    for (std::size_t k = i; k < i + 20; ++k) volume += report.removed[k].removed_mm3;
    const double x = -5 + step * static_cast<double>(report.removed[i].line);
    if (x < 6.0 || x > 30.0) continue;
    EXPECT_NEAR(volume, section, 0.03 * section) << "x = " << x;
    ++looked;
  }
  EXPECT_GT(looked, 20);
}

TEST(StockRun, ARapidThroughStockIsFoundWithLineTimeAndPose) {
  Stock stock = Stock::box({0, 0, 0}, {40, 40, 20}, 0.25);
  const auto report = run_through_stock(stock, tool(),
                                        std::vector<SweptPose>{pose_at({-30, 10, 18}, Vec3::UnitZ(), 1, true),
                                                               pose_at({70, 10, 18}, Vec3::UnitZ(), 2, true)},
                                        {});
  const Finding* found = finding_of(report, "cutter-stock");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, "collision");
  EXPECT_EQ(found->line, 2);
  EXPECT_NEAR(found->value, report.first_mm3 - report.left_mm3, 1e-6);
  ASSERT_TRUE(found->pose_P);
  EXPECT_NE(found->text.find("line 2"), std::string::npos);
  // The same at feed is what tools are for.
  Stock again = Stock::box({0, 0, 0}, {40, 40, 20}, 0.25);
  EXPECT_TRUE(
      run_through_stock(
          again, tool(),
          std::vector<SweptPose>{pose_at({-30, 10, 18}, Vec3::UnitZ(), 1), pose_at({70, 10, 18}, Vec3::UnitZ(), 2)}, {})
          .findings.empty());
}

/// The holder (radius 15, its face 20 over the tip) runs with its face 4 mm under the top of a wall at x = 10.
TEST(StockRun, AHolderThatMeetsWhatIsLeftIsFoundWithTimeAndDepth) {
  for (const double grid : {0.25, 0.5}) {
    Stock stock = Stock::box({10, -60, 0}, {60, 60, 40}, grid);
    const std::vector<SweptPose> poses{pose_at({-90, 0, 16}, Vec3::UnitZ(), 1, true),
                                       pose_at({-3, 0, 16}, Vec3::UnitZ(), 2)};
    const auto report = run_through_stock(stock, tool(), poses, {});
    const Finding* found = finding_of(report, "holder-stock");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 2);
    // It touches with the tip at x = -5 and is known half a step later; the sliver inside must pass 0.5 mm3 first.
    const double touch_s = 0.1 + 0.1 * (85.0 / 87.0);
    EXPECT_GE(found->time_s, touch_s);
    EXPECT_LE(found->time_s, touch_s + 0.1 * 1.0 / 87.0);
    EXPECT_NEAR(found->value, 2.0, 0.6 * grid);  // ends 2 mm inside, sideways; rays stand a grid apart
    EXPECT_FALSE(finding_of(report, "shank-stock"));
  }
}

TEST(StockRun, AHolderIsFreeWhereTheCutterMadeRoom) {
  // A wall is cut away first; the holder then passes where it stood.
  Stock stock = Stock::box({0, 0, 0}, {12, 40, 30}, 0.25);
  kinematics::Tool wide = tool();
  wide.cutter = test::flat(8, 40);
  wide.stick_out_mm = 45;
  wide.shank_radius_mm = 8;
  wide.holder = {};
  std::vector<SweptPose> clear;
  for (double x = 0.0; x <= 12.0; x += 6.0) {
    clear.push_back(pose_at({x, -20, 5}, Vec3::UnitZ(), 1));
    clear.push_back(pose_at({x, 60, 5}, Vec3::UnitZ(), 1));
  }
  const std::vector<SweptPose> deep{pose_at({6, -40, 5.5}, Vec3::UnitZ(), 7), pose_at({6, 80, 5.5}, Vec3::UnitZ(), 8)};
  kinematics::Tool small = tool();
  small.cutter = test::ball(1, 4);
  small.shank_radius_mm = 5;
  Stock full = stock;
  EXPECT_TRUE(finding_of(run_through_stock(full, small, deep, {}), "shank-stock"));
  EXPECT_TRUE(run_through_stock(stock, wide, clear, {}).findings.empty());
  EXPECT_TRUE(run_through_stock(stock, small, deep, {}).findings.empty());
}

/// Looks are put off while material is far: a run looked at with a tenth of the step finds the same meetings.
TEST(StockRun, PuttingOffLooksLosesNothing) {
  std::mt19937_64 random(81);
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  int met = 0;
  for (int i = 0; i < cases(12); ++i) {
    std::vector<SweptPose> poses;
    for (int k = 0; k < 12; ++k) {
      const Vec3 axis = Vec3(0.6 * uniform(random), 0.6 * uniform(random), 1.0).normalized();
      poses.push_back(pose_at({35 * uniform(random), 35 * uniform(random), 21 + 8 * uniform(random)}, axis, k + 1));
    }
    Stock coarse = Stock::box({-20, -20, 0}, {20, 20, 25}, 0.5), fine = coarse;
    StockRunOptions often;
    often.step_mm = 0.05;
    const auto report = run_through_stock(coarse, tool(), poses, {}),
               closer = run_through_stock(fine, tool(), poses, often);
    for (const auto& f : closer.findings) {
      if (f.value < 0.6) continue;  // a step's motion: what is less deep may pass between two looks
      ++met;
      const auto same = [&](const Finding& g) { return g.line == f.line && g.axis_or_pair == f.axis_or_pair; };
      EXPECT_TRUE(std::any_of(report.findings.begin(), report.findings.end(), same))
          << "seed 81, case " << i << ": " << f.text;
    }
  }
  EXPECT_GT(met, 3);
}

TEST(StockRun, DoesNotDependOnTheNumberOfThreads) {
  std::vector<SweptPose> poses;
  for (int k = 0; k < 60; ++k)
    poses.push_back(
        pose_at({-5.0 + k, 15 + 3 * std::sin(0.3 * k), 16}, Vec3(0.2 * std::sin(0.1 * k), 0.1, 1).normalized(), k));
  Stock many = Stock::box({0, 0, 0}, {50, 30, 20}, 0.4), single = many;
  const auto a = run_through_stock(many, tool(), poses, {});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto b = run_through_stock(single, tool(), poses, {});
  EXPECT_EQ(a.left_mm3, b.left_mm3);
  ASSERT_EQ(a.removed.size(), b.removed.size());
  for (std::size_t i = 0; i < a.removed.size(); ++i) EXPECT_EQ(a.removed[i].removed_mm3, b.removed[i].removed_mm3);
  ASSERT_EQ(a.findings.size(), b.findings.size());
  for (std::size_t i = 0; i < a.findings.size(); ++i) EXPECT_EQ(a.findings[i].text, b.findings[i].text);
}

TEST(MakeStock, ANearNetBlankIsAClosedShell) {
  // A quarter of the sphere of radius 20 between latitudes 10 and 60 degrees: its walls are radial.
  constexpr double radius_mm = 20.0, allowance_mm = 0.5, low_rad = std::numbers::pi / 18,
                   high_rad = std::numbers::pi / 3;
  const auto surface = test::sheet(60, 40, [&](double u, double v) {
    const double longitude = 0.5 * std::numbers::pi * u, latitude = low_rad + v * (high_rad - low_rad);
    return Vec3(radius_mm * std::cos(latitude) * std::cos(longitude),
                radius_mm * std::cos(latitude) * std::sin(longitude), radius_mm * std::sin(latitude));
  });
  const auto blank = near_net_blank(surface, allowance_mm);
  std::map<std::pair<geometry::Index, geometry::Index>, int> directed;
  double volume_mm3 = 0.0;
  for (const auto& t : blank.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
    const auto& v = blank.vertices_mm;
    const auto at = [&](std::size_t k) { return v[static_cast<std::size_t>(t[k])]; };
    volume_mm3 += at(0).dot(at(1).cross(at(2))) / 6.0;
  }
  for (const auto& [edge, count] : directed) {
    ASSERT_EQ(count, 1) << edge.first << " " << edge.second;
    ASSERT_EQ(directed.count({edge.second, edge.first}), 1U) << edge.first << " " << edge.second;
  }
  const auto cube = [](double r) { return r * r * r; };
  const double shell_mm3 = 0.5 * std::numbers::pi * (std::sin(high_rad) - std::sin(low_rad)) / 3.0 *
                           (cube(radius_mm + allowance_mm) - cube(radius_mm - near_net_body_mm));
  EXPECT_NEAR(volume_mm3, shell_mm3, 0.02 * shell_mm3);
  const StockSetup setup = near_net_stock(surface, allowance_mm);
  EXPECT_FALSE(setup.assumed);
  const auto stock = make_stock(setup);
  ASSERT_TRUE(stock) << stock.error().message;
  EXPECT_NEAR(stock->volume_mm3(), shell_mm3, 0.02 * shell_mm3);
}

TEST(MakeStock, ABoxAMeshAndWhatIsRefused) {
  const auto surface = test::plane(20.0);
  const StockSetup assumed = assumed_stock(surface, 1.5);
  EXPECT_TRUE(assumed.assumed);
  const auto stock = make_stock(assumed);
  ASSERT_TRUE(stock) << stock.error().message;
  EXPECT_NEAR(stock->volume_mm3(), 23.0 * 23.0 * 3.0, 0.02 * 23 * 23 * 3);
  EXPECT_NEAR(stock->grid_mm(), 23.0 / 200, 1e-12);
  StockSetup flat = assumed;
  flat.box_P_mm.min().z() = flat.box_P_mm.max().z();
  ASSERT_FALSE(make_stock(flat));
  EXPECT_EQ(make_stock(flat).error().code, "stock-box-empty");
  StockSetup fine = assumed;
  fine.grid_mm = 0.002;
  ASSERT_FALSE(make_stock(fine));
  EXPECT_EQ(make_stock(fine).error().code, "stock-grid-too-fine");
  StockSetup open = assumed;
  open.solid_P = surface;
  ASSERT_FALSE(make_stock(open));
}

}  // namespace
}  // namespace volute::sim
