// Method even on two of the example parts, judged by balls along the path and not by the planner's own measure.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "geometry/mesh_io.hpp"
#include "planner/path/cc_path.hpp"
#include "tests/planner/path/dense_scallop.hpp"

namespace volute::planner {
namespace {

void expect_sound(const std::string& name, double radius_mm, double scallop_mm, double length_ratio_max) {
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
  EXPECT_LE(report.length_ratio, length_ratio_max);
  EXPECT_LT(report.sharp_corners_60, 10);
  EXPECT_LE(*report.scallop_ratio_p9999, 1.05);
  EXPECT_LE(*report.scallop_ratio_max, 1.10);
  EXPECT_LE(*report.scallop_area_above_percent, 0.15);
  // Heights grow with the square of the interval: 1.10 times the height, 1.05 times the interval.
  ASSERT_TRUE(report.interval_ratio_max.has_value());
  EXPECT_NEAR(*report.interval_ratio_max, std::sqrt(*report.scallop_ratio_max), 0.01);
  EXPECT_LE(samples::greatest_scallop_ratio(part->mesh, result->path, radius_mm, scallop_mm, 2000, 11), 1.10);
}

TEST(EvenParts, AMouseIsHeldWithinTheScallop) { expect_sound("mouse", 1.0, 0.1, 1.15); }

TEST(EvenParts, APlateWithTwoHolesIsHeldWithinTheScallop) { expect_sound("plate-two-holes", 3.0, 0.2, 1.41); }

}  // namespace
}  // namespace volute::planner
