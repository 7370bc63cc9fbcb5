#include "planner/path/baselines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/path/surface_locator.hpp"
#include "sample_surfaces.hpp"

namespace volute::planner {
namespace {

using geometry::TriangleMesh;

PathOptions with(Strategy strategy) {
  PathOptions options;
  options.strategy = strategy;
  options.scallop_mm = 0.2;
  return options;
}

TriangleMesh plate_with_hole() {
  samples::PlateOptions o;
  o.columns = o.rows = 60;
  o.holes = {{4.0, 3.0, 6.0}};
  return samples::plate(o);
}

TEST(IsoPlanar, AFullPlateIsOneZigzag) {
  samples::PlateOptions o;
  const auto result = plan_cc_path(samples::plate(o), {}, with(Strategy::iso_planar), {});
  ASSERT_TRUE(result) << result.error().message;
  const int planes = static_cast<int>(std::ceil(40.0 / path_interval_mm(3.0, 0.2, 0.0)));
  EXPECT_EQ(result->report.pieces, 1);
  EXPECT_EQ(result->report.linkings, planes - 1);
  EXPECT_EQ(result->report.liftings, 2);
  EXPECT_EQ(result->report.sharp_corners, 2 * (planes - 1)) << "two a link";
  EXPECT_NEAR(result->report.length_mm, 40.0 * planes + 40.0 * (planes - 1) / planes, 1.0);
}

TEST(IsoPlanar, AHoleInterruptsThePassesAcrossIt) {
  const auto result = plan_cc_path(plate_with_hole(), {}, with(Strategy::iso_planar), {});
  ASSERT_TRUE(result);
  EXPECT_GT(result->report.rapid_traversals, 0);
  EXPECT_EQ(result->report.liftings, 2 * (result->report.rapid_traversals + 1));
  for (const CcPiece& piece : result->path.pieces)
    for (const CcPoint& p : piece.points)
      EXPECT_GT(std::hypot(p.point_P_mm.x() - 4.0, p.point_P_mm.y() - 3.0), 6.0 - 0.67);
}

TEST(ProjectedSpiral, IsLiftedOverHolesAndCornersOnly) {
  const auto result = plan_cc_path(plate_with_hole(), {}, with(Strategy::projected_spiral), {});
  ASSERT_TRUE(result);
  EXPECT_GT(result->report.rapid_traversals, 4) << "the plate's corners and the hole";
  EXPECT_EQ(result->report.linkings, 0);
  const auto disk = plan_cc_path(samples::ring(0.4, 20.0, 120, 30), {}, with(Strategy::projected_spiral), {});
  ASSERT_TRUE(disk);
  EXPECT_LE(disk->report.rapid_traversals, 2) << "the outer half turn leaves the polygon at most";
}

TEST(ContourOffset, FollowsASquareWithFourCornersAPass) {
  samples::PlateOptions o;
  o.columns = o.rows = 60;
  const auto result = plan_cc_path(samples::plate(o), {}, with(Strategy::contour_offset), {});
  ASSERT_TRUE(result);
  const int passes = static_cast<int>(std::floor(20.0 / path_interval_mm(3.0, 0.2, 0.0))) + 1;
  EXPECT_EQ(result->report.pieces, 1);
  EXPECT_NEAR(result->report.linkings, passes - 1, 1);
  EXPECT_GT(result->report.sharp_corners, 3 * (passes - 2));
  EXPECT_GT(result->report.scallop_ratio_max.value(), 1.5) << "the corners of offsets stay uncut";
}

TEST(SurfaceLocator, DropsOntoTheHighestFaceAndFindsTheNearestPoint) {
  const TriangleMesh dome = samples::dome(10.0, 0.2, 120, 60);
  std::vector<Vec3> normals;
  for (const Vec3& v : dome.vertices_mm) normals.push_back(v.normalized());
  const SurfaceLocator locator(dome, normals);
  const auto hit = locator.drop(4.0, -3.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point_mm.z(), std::sqrt(75.0), 0.02);
  EXPECT_LT((hit->normal - hit->point_mm.normalized()).norm(), 0.01);
  EXPECT_FALSE(locator.drop(0.0, 0.5)) << "the opening";
  EXPECT_FALSE(locator.drop(11.0, 0.0));
  const Vec3 outside(6.0, 6.0, 7.0);
  const auto nearest = locator.nearest(outside, 3.0);
  ASSERT_TRUE(nearest);
  EXPECT_LT((nearest->point_mm - 10.0 * outside.normalized()).norm(), 0.05);
  EXPECT_FALSE(locator.nearest(outside, 0.5));
}

}  // namespace
}  // namespace volute::planner
