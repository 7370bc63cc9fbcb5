// What can be known of a picture without an eye: where things must be seen, and that two drawings agree.
#include <gtest/gtest.h>

#include "view/camera.hpp"
#include "view/colour_map.hpp"
#include "view/image.hpp"
#include "view/overlay.hpp"
#include "view/renderer.hpp"

namespace volute::view {
namespace {

geometry::TriangleMesh square_mm(double half) {
  return {{{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

std::array<int, 3> rgb_at(const Image& image, int x, int y) {
  const std::size_t at =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 4;
  return {image.bgra[at + 2], image.bgra[at + 1], image.bgra[at]};
}

TEST(Camera, BoxFillsThePictureFromAbove) {
  const Camera camera = fit_camera({{-10, -5, 0}, {10, 5, 0}}, Vec3::UnitZ(), 2.0, 0.0);
  const Vec2 corner = project(camera, {-10, 5, 0}, 800, 400);
  EXPECT_NEAR(corner.x(), 0.0, 1e-6);
  EXPECT_NEAR(corner.y(), 0.0, 1e-6);
  EXPECT_NEAR(project(camera, {0, 0, 0}, 800, 400).x(), 400.0, 1e-9);
}

TEST(Renderer, SquareCoversItsPixelsAndNoOthers) {
  const geometry::TriangleMesh mesh = square_mm(5.0);
  Scene3d scene;
  scene.meshes.push_back({&mesh, {}, {0.9F, 0.2F, 0.1F}, 1.0F});
  const Camera camera = fit_camera({{-10, -10, 0}, {10, 10, 0}}, Vec3::UnitZ(), 1.0, 0.0);
  const auto image = render(scene, camera, 200, 200);
  ASSERT_TRUE(image);
  int covered = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) covered += rgb_at(*image, x, y) != std::array<int, 3>{255, 255, 255} ? 1 : 0;
  EXPECT_NEAR(covered, 100 * 100, 4 * 100) << "a square of half the width covers a quarter of the picture";
  EXPECT_GT(rgb_at(*image, 100, 100)[0], rgb_at(*image, 100, 100)[2] + 80) << "it is red";
}

TEST(Renderer, NearerHidesFarther) {
  geometry::TriangleMesh low = square_mm(5.0), high = square_mm(5.0);
  for (Vec3& vertex : high.vertices_mm) vertex.z() = 1.0;
  Scene3d scene;
  scene.meshes.push_back({&high, {}, {0.1F, 0.8F, 0.1F}, 1.0F});
  scene.meshes.push_back({&low, {}, {0.8F, 0.1F, 0.1F}, 1.0F});
  const auto image = render(scene, fit_camera({{-6, -6, 0}, {6, 6, 1}}, Vec3::UnitZ(), 1.0), 64, 64);
  ASSERT_TRUE(image);
  EXPECT_GT(rgb_at(*image, 32, 32)[1], rgb_at(*image, 32, 32)[0]);
}

TEST(Renderer, SameSceneSameBytes) {
  const geometry::TriangleMesh mesh = square_mm(5.0);
  Scene3d scene;
  scene.meshes.push_back({&mesh, {}, {0.5F, 0.5F, 0.5F}, 1.0F});
  scene.lines.push_back({{{-4, 0, 0}, {4, 1, 0}}, {}, {0.0F, 0.0F, 0.0F}, 2.0, 0.1});
  const Camera camera = fit_camera({{-6, -6, 0}, {6, 6, 0}}, {0.3, -1.0, 1.0}, 1.0);
  const auto first = render(scene, camera, 120, 120), second = render(scene, camera, 120, 120);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(png_bytes(*first), png_bytes(*second));
}

TEST(Image, ReducedIsTheMean) {
  Image large{2, 2, {0, 0, 0, 255, 100, 0, 0, 255, 0, 40, 0, 255, 0, 0, 8, 255}};
  const Image small = reduced(large, 2);
  EXPECT_EQ(small.bgra, (std::vector<std::uint8_t>{25, 10, 2, 255}));
}

TEST(ColourMap, LightnessRisesAllTheWay) {
  double before = -1.0;
  for (int i = 0; i <= 100; ++i) {
    const Colour c = sequential_colour(i / 100.0);
    const double lightness = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    EXPECT_GT(lightness, before) << i;
    before = lightness;
  }
}

TEST(RoundStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_step(100.0, 5), 20.0);
  EXPECT_DOUBLE_EQ(round_step(0.37, 4), 0.1);
  EXPECT_DOUBLE_EQ(round_step(9.0, 3), 5.0);
}

}  // namespace
}  // namespace volute::view
