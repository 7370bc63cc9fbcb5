// Method even on two of the example parts, judged by balls along the path and not by the planner's own measure.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "geometry/mesh_io.hpp"
#include "planner/path/cc_path.hpp"
#include "tests/planner/path/dense_scallop.hpp"

namespace volute::planner {
namespace {

/// What a part may at most have: 9 corners over 60 degrees, 1.10 times the scallop by either measure, 0.15 % of the
/// area above it.
struct Bounds {
  double length_ratio;
  int sharp_corners_60 = 9;
  double scallop_ratio = 1.10, independent_scallop_ratio = 1.10, area_above_percent = 0.15;
};

void expect_sound(const std::string& name, double radius_mm, double scallop_mm, const Bounds& at_most) {
  const auto part =
      geometry::load_mesh(std::filesystem::path(VOLUTE_SOURCE_DIR) / "examples" / "parts" / (name + ".stl"));
  ASSERT_TRUE(part.has_value()) << part.error().message;
  kinematics::Cutter ball;
  ball.radius_mm = ball.corner_radius_mm = radius_mm;
  PathOptions options;
  options.scallop_mm = scallop_mm;
  const auto result = plan_cc_path(part->mesh, ball, options, {});
  ASSERT_TRUE(result.has_value()) << result.error().message;
  const PathReport& report = result->report;
  EXPECT_EQ(report.method, "even");
  EXPECT_EQ(report.pieces, 1);
  EXPECT_LE(report.length_ratio, at_most.length_ratio);
  EXPECT_LE(report.sharp_corners_60, at_most.sharp_corners_60);
  EXPECT_LE(*report.scallop_ratio_p9999, 1.05);
  EXPECT_LE(*report.scallop_ratio_max, at_most.scallop_ratio);
  EXPECT_LE(*report.scallop_area_above_percent, at_most.area_above_percent);
  // Heights grow with the square of the interval: 1.10 times the height, 1.05 times the interval.
  ASSERT_TRUE(report.interval_ratio_max.has_value());
  EXPECT_NEAR(*report.interval_ratio_max, std::sqrt(*report.scallop_ratio_max), 0.01);
  EXPECT_LE(samples::greatest_scallop_ratio(part->mesh, result->path, radius_mm, scallop_mm, 2000, 11),
            at_most.independent_scallop_ratio);
}

TEST(EvenParts, AMouseIsHeldWithinTheScallop) { expect_sound("mouse", 1.0, 0.1, {1.15}); }

TEST(EvenParts, APlateWithTwoHolesIsHeldWithinTheScallop) { expect_sound("plate-two-holes", 3.0, 0.2, {1.40}); }

}  // namespace
}  // namespace volute::planner
