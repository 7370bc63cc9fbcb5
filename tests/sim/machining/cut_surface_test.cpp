#include "sim/machining/cut_surface.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <numbers>

#include "shapes.hpp"

namespace volute::sim {
namespace {

using geometry::Vec3;
using test::ball_at;

double exact_scallop(double radius, double interval) {
  return radius - std::sqrt(radius * radius - 0.25 * interval * interval);
}

TEST(CutSurface, ScallopOnAPlaneIsTheExactCircles) {
  const auto surface = test::plane(10.0, 3);
  for (const double interval : {0.3, 0.87, 1.5}) {
    for (const double tilt : {0.0, 0.3}) {
      const auto poses = test::passes_on_plane(10.0, interval, 1.0, Vec3(std::sin(tilt), 0, std::cos(tilt)));
      const auto report = measure_cut_surface(surface, test::ball(1.0), poses, {.uncut_limit_mm = 0.5});
      EXPECT_NEAR(report.scallop_max_mm, exact_scallop(1.0, interval), 1e-3 * exact_scallop(1.0, interval))
          << interval << " " << tilt;
      test::record_error("error_ppm_" + std::to_string(interval) + "_" + std::to_string(tilt), report.scallop_max_mm,
                         exact_scallop(1.0, interval));
      EXPECT_NEAR(report.gouge_max_mm, 0.0, 1e-9);
      EXPECT_EQ(report.uncut_area_mm2, 0.0);
      EXPECT_NEAR(report.area_mm2, 100.0, 1e-9);
      EXPECT_TRUE(report.findings.empty());
    }
  }
}

// One ball over the middle of a square on coarse triangles: what stands over the limit are its four corners beyond a
// circle.
TEST(CutSurface, UncutCornersSmallerThanTheAreaLimitAreMeasured) {
  const double r = 3.0, limit = 0.23, reach = std::sqrt(2.0 * r * limit - limit * limit);
  for (const double corner : {1.01, 1.05, 1.10, 1.14, 1.2}) {  // over the reach
    const double a = corner * reach / std::sqrt(2.0);
    const auto surface = test::plane(2.0 * a, 2);
    const double covered =
        reach * reach * (std::numbers::pi - 4.0 * std::acos(a / reach)) + 4.0 * a * std::sqrt(reach * reach - a * a);
    const auto report =
        measure_cut_surface(surface, test::ball(r),
                            {ball_at(Vec3(a, a, r), Vec3::UnitZ(), r, 1), ball_at(Vec3(a, a, r), Vec3::UnitZ(), r, 2)},
                            {.uncut_limit_mm = limit});
    const double exact = 4.0 * a * a - covered;
    EXPECT_NEAR(report.uncut_area_mm2, exact, 0.0125 + 0.2 * exact) << corner;
    EXPECT_EQ(report.uncut, report.uncut_area_mm2 > 0.05) << corner;
  }
}

/// Two balls whose centres stand (R + r) from the middle and an angle apart leave this much over the radius R.
double scallop_on_round(double R, double r, double angle) {
  const double c = (R + r) * std::cos(0.5 * angle), s = (R + r) * std::sin(0.5 * angle);
  return c - std::sqrt(r * r - s * s) - R;
}

TEST(CutSurface, ScallopOnACylinderIsTheExactCircles) {
  const double R = 20.0, r = 2.0, angle = 0.04;
  const auto surface = test::sheet(100, 2, [&](double u, double v) {
    return Vec3(R * std::sin(0.4 * (u - 0.5)), 6.0 * v, R * std::cos(0.4 * (u - 0.5)));
  });
  std::vector<SweptPose> poses;
  for (double a = -0.32; a < 0.33; a += angle) {
    const Vec3 out(std::sin(a), 0, std::cos(a));
    for (const double y : {-1.0, 7.0}) poses.push_back(ball_at((R + r) * out + Vec3(0, y, 0), out, r, 1));
    for (const double y : {7.0, -1.0}) poses.push_back(ball_at((R + r + 30.0) * out + Vec3(0, y, 0), out, r, 1));
  }
  const auto report = measure_cut_surface(surface, test::ball(r), poses, {.uncut_limit_mm = 0.1});
  const double expected = scallop_on_round(R, r, angle);
  EXPECT_NEAR(report.scallop_max_mm, expected, 0.01 * expected);
  test::record_error("error_ppm", report.scallop_max_mm, expected);
  EXPECT_FALSE(report.uncut);
}

TEST(CutSurface, ScallopOnASphereIsTheExactCircles) {
  const double R = 20.0, r = 3.0, angle = 0.05;
  const auto surface = test::sheet(40, 40, [&](double u, double v) {
    const double polar = 0.8 + 0.35 * v, around = 0.4 * u;
    return Vec3(R * Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)));
  });
  auto turned = surface;  // outward side up
  if ((surface.vertices_mm[1] - surface.vertices_mm[0])
          .cross(surface.vertices_mm[42] - surface.vertices_mm[0])
          .dot(surface.vertices_mm[0]) < 0.0) {
    for (auto& t : turned.triangles) std::swap(t[1], t[2]);
  }
  std::vector<SweptPose> poses;
  for (double polar = 0.6; polar < 1.36; polar += angle) {
    for (int k = -50; k <= 250; ++k) {
      const double around = 0.002 * k;
      const Vec3 out(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
      if (k == -50) poses.push_back(ball_at((R + r + 30.0) * out, out, r, 1));
      poses.push_back(ball_at((R + r) * out, out, r, 1));
      if (k == 250) poses.push_back(ball_at((R + r + 30.0) * out, out, r, 1));
    }
  }
  const auto report = measure_cut_surface(turned, test::ball(r), poses, {.uncut_limit_mm = 0.2});
  const double expected = scallop_on_round(R, r, angle);
  EXPECT_NEAR(report.scallop_max_mm, expected, 0.01 * expected);
  test::record_error("error_ppm", report.scallop_max_mm, expected);
  EXPECT_FALSE(report.uncut);
}

TEST(CutSurface, MeanDeviationOnAPlaneIsTheMeanUnderTheArc) {
  const double interval = 0.8;
  const auto report = measure_cut_surface(test::plane(8.0, 2), test::ball(1.0),
                                          test::passes_on_plane(8.0, interval, 1.0, Vec3::UnitZ()),
                                          {.sample_spacing_mm = 0.03, .uncut_limit_mm = 0.5});
  const double half = interval / 2;  // integral of 1 - sqrt(1 - x^2)
  const double mean = 1.0 - (0.5 * (half * std::sqrt(1 - half * half) + std::asin(half))) / half;
  EXPECT_NEAR(report.deviation_mean_mm, mean, 2e-3 * mean);
}

TEST(CutSurface, UncutStripHasItsArea) {
  auto poses = test::passes_on_plane(20.0, 0.5, 2.0, Vec3::UnitZ());
  // Leave out the passes over x in (8, 12): what stays higher than 0.1 mm runs between two arcs.
  std::erase_if(poses, [](const SweptPose& p) { return p.pose.tip_P_mm.x() > 8.01 && p.pose.tip_P_mm.x() < 11.99; });
  const auto report = measure_cut_surface(test::plane(20.0, 4), test::ball(2.0), poses,
                                          {.sample_spacing_mm = 0.05, .uncut_limit_mm = 0.1, .search_height_mm = 5.0});
  const double reach = std::sqrt(4.0 - 1.9 * 1.9);
  EXPECT_TRUE(report.uncut);
  EXPECT_NEAR(report.uncut_area_mm2, 20.0 * (4.0 - 2.0 * reach), 0.5);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].kind, "uncut");
  EXPECT_NEAR(report.scallop_max_mm, 2.0, 0.01);  // two balls that touch between their centres: one radius
}

// Passes 0.7 mm apart under vertices 1 mm apart: the deviations at the vertices themselves would run through all
// heights of the scallop.
TEST(CutSurface, VerticesTellTheScallopHoweverTheyStandToThePasses) {
  const auto surface = test::sheet(12, 12, [](double u, double v) { return Vec3(12 * u, 12 * v, 0.0); });
  const auto report =
      measure_cut_surface(surface, test::ball(1.5), test::passes_on_plane(12.0, 0.7, 1.5, Vec3::UnitZ()), {});
  const double scallop_mm = 1.5 - std::sqrt(1.5 * 1.5 - 0.35 * 0.35);
  ASSERT_EQ(report.vertex_deviation_mm.size(), surface.vertices_mm.size());
  int looked_at = 0;
  for (std::size_t i = 0; i < surface.vertices_mm.size(); ++i) {
    const Vec3& p = surface.vertices_mm[i];
    if (p.x() < 1.5 || p.y() < 1.5 || p.x() > 10.5 || p.y() > 10.5) continue;  // whole scallops about it
    ++looked_at;
    EXPECT_NEAR(report.vertex_deviation_mm[i], scallop_mm, 0.25 * scallop_mm) << p.transpose();
  }
  EXPECT_GT(looked_at, 50);
}

TEST(CutSurface, NoPosesLeaveEverythingUncut) {
  const auto report = measure_cut_surface(test::plane(5.0), test::ball(1.0), {}, {});
  EXPECT_TRUE(report.uncut);
  EXPECT_NEAR(report.uncut_area_mm2, 25.0, 1e-9);
  EXPECT_TRUE(std::isnan(report.vertex_deviation_mm.at(0)));
}

TEST(CutSurface, DoesNotDependOnTheNumberOfThreads) {
  const auto surface = test::sheet(
      12, 12, [](double u, double v) { return Vec3(12 * u, 12 * v, 0.3 * std::sin(9 * u) * std::cos(7 * v)); });
  const auto poses = test::passes_on_plane(12.0, 0.7, 1.5, Vec3::UnitZ());
  const auto many = measure_cut_surface(surface, test::ball(1.5), poses, {});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = measure_cut_surface(surface, test::ball(1.5), poses, {});
  EXPECT_EQ(many.scallop_max_mm, single.scallop_max_mm);
  EXPECT_EQ(many.gouge_max_mm, single.gouge_max_mm);
  EXPECT_EQ(many.uncut_area_mm2, single.uncut_area_mm2);
  EXPECT_EQ(many.histogram, single.histogram);
  ASSERT_EQ(many.findings.size(), single.findings.size());
  for (std::size_t i = 0; i < many.findings.size(); ++i) EXPECT_EQ(many.findings[i].text, single.findings[i].text);
}

TEST(CutSurface, SurfaceMovedWithItsPosesHasTheSameDeviations) {
  const auto surface = test::sheet(6, 6, [](double u, double v) { return Vec3(6 * u, 6 * v, 0.2 * std::sin(5 * u)); });
  const auto poses = test::passes_on_plane(6.0, 0.6, 1.0, Vec3(0.2, 0.1, 1.0).normalized());
  const auto here = measure_cut_surface(surface, test::ball(1.0), poses, {});
  const geometry::Transform move =
      Eigen::Translation3d(30, -20, 10) * Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized());
  auto moved_surface = surface;
  for (auto& v : moved_surface.vertices_mm) v = move * v;
  auto moved_poses = poses;
  for (auto& p : moved_poses) {
    p.pose.tip_P_mm = move * p.pose.tip_P_mm;
    p.pose.axis_P = move.linear() * p.pose.axis_P;
  }
  const auto there = measure_cut_surface(moved_surface, test::ball(1.0), moved_poses, {});
  EXPECT_NEAR(here.scallop_max_mm, there.scallop_max_mm, 1e-6);
  EXPECT_NEAR(here.gouge_max_mm, there.gouge_max_mm, 1e-6);
  EXPECT_NEAR(here.uncut_area_mm2, there.uncut_area_mm2, 1e-3);
  for (std::size_t i = 0; i < here.vertex_deviation_mm.size(); ++i) {
    if (std::isnan(here.vertex_deviation_mm[i])) continue;
    EXPECT_NEAR(here.vertex_deviation_mm[i], there.vertex_deviation_mm[i], 1e-9);
  }
}

/// A step: top z = 0 for x < 0, wall x = 0 down to z = -10. The tool cuts the wall with its flank and may not be blamed
/// for the top.
TEST(CutSurface, ACutterBesideAConvexEdgeIsNoGouge) {
  geometry::TriangleMesh step;
  step.vertices_mm = {{-5, 0, 0}, {0, 0, 0}, {0, 10, 0}, {-5, 10, 0}, {0, 0, -10}, {0, 10, -10}};
  step.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  std::vector<SweptPose> poses;
  for (double x = -6.0; x <= 0.01; x += 0.3) {
    poses.push_back({{Vec3(x, -3, 0), Vec3::UnitZ()}, 1, 0, false});
    poses.push_back({{Vec3(x, 13, 0), Vec3::UnitZ()}, 1, 0, false});
    poses.push_back({{Vec3(x, 13, 30), Vec3::UnitZ()}, 1, 0, true});
    poses.push_back({{Vec3(x, -3, 30), Vec3::UnitZ()}, 1, 0, true});
  }
  poses.push_back({{Vec3(2, -3, 30), Vec3::UnitZ()}, 2, 0, true});
  poses.push_back({{Vec3(2, -3, -14), Vec3::UnitZ()}, 2, 0, true});
  poses.push_back({{Vec3(2, 13, -14), Vec3::UnitZ()}, 3, 0, false});
  const auto report =
      measure_cut_surface(step, test::ball(2.0), poses, {.uncut_limit_mm = 0.05, .gouge_limit_mm = 0.002});
  EXPECT_TRUE(report.findings.empty()) << report.findings.at(0).text;
  EXPECT_LT(report.gouge_max_mm, 1e-6);
  EXPECT_LT(report.scallop_max_mm, 0.02);
}

// A few micrometres too low over the top of that step the cutter takes a strip off the wall that is as high: seen along
// the wall's normal it goes as deep as the cutter is wide, but nothing that it took lay deeper than those micrometres.
TEST(CutSurface, ACutterSlightlyTooLowOverAConvexEdgeGoesNoDeeperThanThat) {
  geometry::TriangleMesh step;
  step.vertices_mm = {{-2, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-2, 1, 0}, {0, 0, -2}, {0, 1, -2}};
  step.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  for (const auto& cutter : {test::flat(1.0), test::bull(1.0, 0.3), test::ball(1.0)}) {
    for (const double too_low : {0.002, 0.02}) {
      const std::vector<SweptPose> poses{{{Vec3(-3.0, 0.5, -too_low), Vec3::UnitZ()}, 1, 0, false},
                                         {{Vec3(0.7, 0.5, -too_low), Vec3::UnitZ()}, 1, 0, false}};
      const auto report = measure_cut_surface(step, cutter, poses, {.sample_spacing_mm = 0.1});
      EXPECT_NEAR(report.gouge_max_mm, too_low, 0.1 * too_low) << "corner radius " << cutter.corner_radius_mm;
      EXPECT_EQ(std::any_of(report.findings.begin(), report.findings.end(),
                            [](const Finding& f) { return f.kind == "gouge"; }),
                too_low > 0.01)
          << "corner radius " << cutter.corner_radius_mm;
    }
  }
}

TEST(CutSurface, FlatEndAcrossAPlaneLeavesNothingAndTiltedLeavesTheWedge) {
  // Tilted by `tilt` across the feed, the disc's rim is an ellipse in the section: scallop between passes.
  const double radius = 4.0, tilt = 0.1, interval = 3.0;
  const Vec3 axis(0, -std::sin(tilt), std::cos(tilt));  // lead along the feed y
  std::vector<SweptPose> poses;
  std::int64_t line = 1;
  for (double x = -6.0; x <= 18.0; x += interval) {
    for (const double y : {-8.0, 20.0}) {
      const Vec3 lowest(x, y, 0.0);  // rim point
      const Vec3 to_centre(0, -std::cos(tilt), -std::sin(tilt));
      poses.push_back({{lowest - radius * to_centre, axis}, line++, 0, false});
    }
    poses.push_back({{Vec3(x, 20, 40), axis}, line++, 0, true});
    poses.push_back({{Vec3(x, -20, 40), axis}, line++, 0, true});
  }
  const auto report = measure_cut_surface(test::plane(6.0, 2), test::flat(radius), poses,
                                          {.sample_spacing_mm = 0.2, .uncut_limit_mm = 0.3});
  // Swept along y, the rim's projection is an ellipse of half axes radius and radius * sin(tilt).
  const double expected = radius * std::sin(tilt) * (1.0 - std::sqrt(1.0 - std::pow(interval / 2 / radius, 2)));
  EXPECT_NEAR(report.scallop_max_mm, expected, 0.01 * expected);
  EXPECT_LT(report.gouge_max_mm, 1e-6);
}

}  // namespace
}  // namespace volute::sim
