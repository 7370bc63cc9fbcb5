#include "sim/machining/cut_picture.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"

namespace volute::sim {
namespace {

using geometry::Vec3;

TEST(CutPicture, DeviationsOfItsCornersAreTheScallop) {
  const double interval = 0.8;
  const auto picture =
      cut_picture(test::plane(4.0), test::ball(1.0), test::passes_on_plane(4.0, interval, 1.0, Vec3::UnitZ()), {}, 0.1);
  ASSERT_EQ(picture.mesh.vertices_mm.size(), picture.deviation_mm.size());
  ASSERT_EQ(picture.mesh.vertices_mm.size(), picture.colours.size());
  for (std::size_t v = 0; v < picture.deviation_mm.size(); ++v) {
    const double x = picture.mesh.vertices_mm[v].x(), off = std::abs(std::remainder(x, interval));
    EXPECT_NEAR(picture.deviation_mm[v], 1.0 - std::sqrt(1.0 - off * off), 1e-9);
  }
  double area = 0.0;
  for (const auto& t : picture.mesh.triangles) {
    const auto p = [&](std::size_t k) { return picture.mesh.vertices_mm[static_cast<std::size_t>(t[k])]; };
    area += 0.5 * (p(1) - p(0)).cross(p(2) - p(0)).norm();
  }
  EXPECT_NEAR(area, 16.0, 1e-9);
}

TEST(DeviationColour, BlueBelowWhiteOnRedAboveGreyUnknown) {
  using Colour = std::array<unsigned char, 3>;
  EXPECT_EQ(deviation_colour(-0.02, 0.01, 0.1), (Colour{0, 0, 255}));
  EXPECT_EQ(deviation_colour(0.0, 0.01, 0.1), (Colour{255, 255, 255}));
  EXPECT_EQ(deviation_colour(0.1, 0.01, 0.1), (Colour{255, 0, 0}));
  EXPECT_EQ(deviation_colour(std::nan(""), 0.01, 0.1), (Colour{96, 96, 96}));
}

}  // namespace
}  // namespace volute::sim
