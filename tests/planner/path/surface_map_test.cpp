#include "planner/surface/surface_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/index.hpp"
#include "planner/surface/geodesic_distance.hpp"
#include "sample_surfaces.hpp"
#include "tests/cases.hpp"

namespace volute::planner {

using geometry::at;
namespace {

/// Triangles of no or negative area, counted here again from the coordinates.
int flipped_in_rectangle(const Annulus& annulus, const RectangleMap& map) {
  int flips = 0;
  for (const geometry::Triangle& t : annulus.sheet.triangles) {
    const auto u = [&](std::size_t k) { return map.u_mm[at(t[k])]; };
    const auto v = [&](std::size_t k) { return map.v_mm[at(t[k])]; };
    if (!((u(1) - u(0)) * (v(2) - v(0)) - (u(2) - u(0)) * (v(1) - v(0)) > 0.0)) ++flips;
  }
  return flips;
}

TEST(CylinderMap, OfAFlatRingIsLogarithmAndAngle) {
  const auto annulus = make_annulus(samples::ring(5.0, 20.0, 120, 60));
  ASSERT_TRUE(annulus);
  const auto map = cylinder_map(*annulus);
  ASSERT_TRUE(map) << map.error().message;
  EXPECT_EQ(map->quality.flips, 0);
  EXPECT_LT(map->quality.quasi_conformal_error, 0.03);
  const double zero = std::atan2(annulus->ring.vertices_mm[at(annulus->seam[0])].y(),
                                 annulus->ring.vertices_mm[at(annulus->seam[0])].x());
  for (std::size_t v = 0; v < annulus->ring.vertices_mm.size(); ++v) {
    const Vec3& p = annulus->ring.vertices_mm[v];
    EXPECT_NEAR(map->height[v], std::log(20.0 / p.norm()) / std::log(4.0), 2e-3);
    const double turns = (std::atan2(p.y(), p.x()) - zero) / (2.0 * std::numbers::pi) - map->turn.vertex[v];
    EXPECT_NEAR(turns, std::round(turns), 2e-3);
  }
}

TEST(RectangleMap, PutsTheCornersAndSidesOnTheRectangle) {
  const auto annulus = make_annulus(samples::random_plate(7, 3));
  ASSERT_TRUE(annulus) << annulus.error().message;
  const auto map = rectangle_map(*annulus);
  ASSERT_TRUE(map) << map.error().message;
  for (Index v : annulus->bottom) EXPECT_EQ(map->v_mm[at(v)], 0.0);
  for (Index v : annulus->top) EXPECT_NEAR(map->v_mm[at(v)], map->height_mm, 1e-9);
  for (Index v : annulus->left) EXPECT_EQ(map->u_mm[at(v)], 0.0);
  for (Index v : annulus->right) EXPECT_NEAR(map->u_mm[at(v)], map->width_mm, 1e-9);
  for (std::size_t i = 0; i < annulus->left.size(); ++i)
    EXPECT_NEAR(map->v_mm[at(annulus->left[i])], map->v_mm[at(annulus->right[i])], 1e-9)
        << "both sides of the seam agree";
}

TEST(SurfaceMaps, NoTriangleFlipsOnRandomSurfaces) {
  const int plates = cases(24);
  int raised = 0;
  for (int i = 0; i < plates; ++i) {
    const auto annulus = make_annulus(samples::random_plate(static_cast<std::uint32_t>(1000 + i), i % 9));
    ASSERT_TRUE(annulus) << "seed " << 1000 + i << ": " << annulus.error().message;
    const auto rectangle = rectangle_map(*annulus);
    ASSERT_TRUE(rectangle) << "seed " << 1000 + i << ": " << rectangle.error().message;
    EXPECT_EQ(flipped_in_rectangle(*annulus, *rectangle), 0) << "seed " << 1000 + i;
    const auto cylinder = cylinder_map(*annulus);
    ASSERT_TRUE(cylinder) << "seed " << 1000 + i << ": " << cylinder.error().message;
    EXPECT_EQ(cylinder->quality.flips, 0) << "seed " << 1000 + i;
    raised += rectangle->quality.positive_weights || cylinder->quality.positive_weights ? 1 : 0;
  }
  RecordProperty("surfaces_with_raised_weights", raised);
}

TEST(SurfaceMaps, NoTriangleFlipsOnStretchedTrianglesAndUnevenDensity) {
  const int plates = cases(4);
  for (int i = 0; i < plates; ++i) {
    const auto seed = static_cast<std::uint32_t>(7000 + i);
    const auto annulus = make_annulus(samples::stretched_plate(seed, i % 5));
    ASSERT_TRUE(annulus) << "seed " << seed << ": " << annulus.error().message;
    const auto rectangle = rectangle_map(*annulus);
    ASSERT_TRUE(rectangle) << "seed " << seed << ": " << rectangle.error().message;
    EXPECT_EQ(flipped_in_rectangle(*annulus, *rectangle), 0) << "seed " << seed;
    const auto cylinder = cylinder_map(*annulus);
    ASSERT_TRUE(cylinder) << "seed " << seed << ": " << cylinder.error().message;
    EXPECT_EQ(cylinder->quality.flips, 0) << "seed " << seed;
  }
}

TEST(SurfaceMaps, StretchedPlatesHaveTheAnglesTheyAreMeantToHave) {
  samples::PlateOptions o;
  o.bricks = true;
  o.columns = 20;
  o.rows = 500;
  const TriangleMesh mesh = samples::plate(o);
  double least = 180.0, greatest = 0.0;
  for (const geometry::Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &p = mesh.vertices_mm[at(t[k])], &q = mesh.vertices_mm[at(t[(k + 1) % 3])],
                 &r = mesh.vertices_mm[at(t[(k + 2) % 3])];
      const double angle = std::atan2((q - p).cross(r - p).norm(), (q - p).dot(r - p)) * 180.0 / std::numbers::pi;
      least = std::min(least, angle);
      greatest = std::max(greatest, angle);
    }
  EXPECT_LT(least, 5.0);
  EXPECT_GT(greatest, 170.0);
}

TEST(GeodesicDistance, OnAFlatRingIsTheRadiusLeft) {
  const TriangleMesh ring = samples::ring(5.0, 20.0, 120, 60);
  std::vector<Index> outer;
  for (Index i = 0; i < 120; ++i) outer.push_back(60 * 120 + i);
  const auto distance = geodesic_distance_mm(ring, outer);
  ASSERT_TRUE(distance);
  for (std::size_t v = 0; v < ring.vertices_mm.size(); ++v)
    EXPECT_NEAR((*distance)[v], 20.0 - ring.vertices_mm[v].norm(), 0.15);
}

}  // namespace
}  // namespace volute::planner
