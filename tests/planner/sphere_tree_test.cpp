#include "planner/sphere_tree.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

TEST(SphereTree, PointDistanceIsExact) {
  const auto mesh = testing::sheet(-20, 20, -20, 20, 1.3,
                                   [](double x, double y) { return 3.0 * std::sin(0.2 * x) * std::cos(0.15 * y); });
  const SphereTree tree(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int n = 0; n < 200; ++n) {
    const Vec3 p(25 * any(random), 25 * any(random), 10 * any(random));
    // Independent: the nearest of many points on each triangle can only be farther, by less than the sampling.
    double sampled = 1e9;
    for (const auto& t : mesh.triangles) {
      const Vec3 &a = mesh.vertices_mm[static_cast<std::size_t>(t[0])],
                 &b = mesh.vertices_mm[static_cast<std::size_t>(t[1])],
                 &c = mesh.vertices_mm[static_cast<std::size_t>(t[2])];
      if ((a - p).norm() > sampled + 3.0) continue;
      for (int i = 0; i <= 8; ++i) {
        for (int j = 0; i + j <= 8; ++j)
          sampled = std::min(sampled, (a + (b - a) * i / 8.0 + (c - a) * j / 8.0 - p).norm());
      }
    }
    const double exact = tree.point_distance_mm(p, 100.0);
    EXPECT_LE(exact, sampled + 1e-12);
    EXPECT_GT(exact, sampled - 0.12);
    EXPECT_EQ(tree.point_distance_mm(p, 0.5 * exact), 0.5 * exact);
  }
}

TEST(SphereTree, ParityTellsInside) {
  const SphereTree tree(testing::box(Vec3(-1, -2, -3), Vec3(1, 2, 3)));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-4.0, 4.0);
  for (int n = 0; n < 500; ++n) {
    const Vec3 p(any(random), any(random), any(random));
    EXPECT_EQ(tree.contains(p), std::abs(p.x()) < 1 && std::abs(p.y()) < 2 && std::abs(p.z()) < 3) << p.transpose();
  }
}

/// Exact: in the half-plane through the axis the cone is a quadrangle; the distance to its three outer sides, 0 inside.
double cone_distance(const AxialCone& cone, const Vec3& point) {
  using geometry::Vec2;
  const Vec3 d = point - cone.base_mm;
  const double z = d.dot(cone.axis);
  const Vec2 at((d - z * cone.axis).norm(), z);
  const Vec2 a(0.0, cone.z_min_mm), b(cone.bottom_radius_mm, cone.z_min_mm), c(cone.top_radius_mm, cone.z_max_mm),
      e(0.0, cone.z_max_mm);
  const double wall = b.x() + (c.x() - b.x()) * (z - b.y()) / (c.y() - b.y());
  if (z >= a.y() && z <= e.y() && at.x() <= wall) return 0.0;
  double least = 1e9;
  for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, e)}) {
    const double t = std::clamp((at - p).dot(q - p) / std::max((q - p).squaredNorm(), 1e-300), 0.0, 1.0);
    least = std::min(least, (at - p - t * (q - p)).norm());
  }
  return least;
}

TEST(SphereTree, ClearanceIsLowerBound) {
  const auto mesh = testing::sheet(-20, 20, -20, 20, 1.0, [](double x, double y) { return 0.02 * x * y; });
  const SphereTree tree(mesh);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int n = 0; n < 100; ++n) {
    const AxialCone cylinder{Vec3(15 * any(random), 15 * any(random), 12 + 6 * any(random)),
                             Vec3(any(random), any(random), any(random)).normalized(),
                             0.0,
                             5.0,
                             2.0,
                             3.0};
    double truth = 1e9;
    for (const Vec3& v : mesh.vertices_mm) truth = std::min(truth, cone_distance(cylinder, v));
    const double bound = tree.clearance_mm(cylinder, 100.0);
    if (bound > 0.0) {
      EXPECT_LE(bound, truth);
    }
    EXPECT_GT(bound, truth - 2.5);
  }
}

/// Independent: the least distance over a fine raster of points on both triangles, above the truth by the raster.
double sampled_distance(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b, const geometry::Transform& X,
                        int cells) {
  const auto raster = [&](const geometry::TriangleMesh& mesh, const geometry::Transform& X_mesh) {
    std::vector<Vec3> points;
    for (const auto& t : mesh.triangles) {
      const Vec3 p = X_mesh * mesh.vertices_mm[static_cast<std::size_t>(t[0])],
                 q = X_mesh * mesh.vertices_mm[static_cast<std::size_t>(t[1])],
                 r = X_mesh * mesh.vertices_mm[static_cast<std::size_t>(t[2])];
      for (int i = 0; i <= cells; ++i) {
        for (int j = 0; i + j <= cells; ++j) points.push_back(p + (q - p) * i / cells + (r - p) * j / cells);
      }
    }
    return points;
  };
  double least = 1e9;
  const std::vector<Vec3> of_a = raster(a, geometry::Transform::Identity()), of_b = raster(b, X);
  for (const Vec3& p : of_a) {
    for (const Vec3& q : of_b) least = std::min(least, (p - q).norm());
  }
  return least;
}

TEST(SphereTree, MeshDistanceIsExact) {
  const auto post = testing::box(Vec3(-1, -2, -3), Vec3(1, 2, 3)),
             block = testing::box(Vec3(-2, -1, -1), Vec3(2, 1, 1));
  const SphereTree a(post), b(block);
  // Closed form: faces apart, edges apart, corners apart, crossing.
  const auto at = [](const Vec3& p) { return geometry::Transform(Eigen::Translation3d(p)); };
  EXPECT_NEAR(a.mesh_distance_mm(b, at(Vec3(5, 0, 0)), 10.0), 2.0, 1e-12);
  EXPECT_NEAR(a.mesh_distance_mm(b, at(Vec3(6, 7, 0)), 10.0), 5.0, 1e-12);
  EXPECT_NEAR(a.mesh_distance_mm(b, at(Vec3(4, 5, 6)), 10.0), 3.0, 1e-12);
  EXPECT_EQ(a.mesh_distance_mm(b, at(Vec3(1, 1, 1)), 10.0), 0.0);
  EXPECT_EQ(a.mesh_distance_mm(b, at(Vec3(50, 0, 0)), 10.0), 10.0);
  const unsigned seed = 21;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int n = 0; n < 12; ++n) {
    geometry::Transform X = geometry::Transform::Identity();
    X.linear() = Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized().toRotationMatrix();
    X.translation() = 7.0 * Vec3(any(random), any(random), any(random));
    const double exact = a.mesh_distance_mm(b, X, 100.0), sampled = sampled_distance(post, block, X, 20);
    EXPECT_LE(exact, sampled + 1e-9) << "seed " << seed << " case " << n;
    EXPECT_GT(exact, sampled - 0.45) << "seed " << seed << " case " << n;
    EXPECT_NEAR(b.mesh_distance_mm(a, X.inverse(), 100.0), exact, 1e-9) << "seed " << seed << " case " << n;
  }
}

TEST(SphereTree, DepthIsLowerBound) {
  const auto mesh = testing::sheet(-20, 20, -20, 20, 0.5, [](double, double) { return 0.0; });
  const SphereTree tree(mesh);
  // A cylinder of radius 4 standing 1.5 into the plane: the deepest point of the plane is 1.5 above its bottom.
  const AxialCone standing{Vec3(0.1, 0.2, -1.5), Vec3::UnitZ(), 0.0, 20.0, 4.0, 4.0};
  EXPECT_NEAR(tree.depth_mm(standing), 1.5, 1e-9);
  const AxialCone above{Vec3(0.1, 0.2, 0.5), Vec3::UnitZ(), 0.0, 20.0, 4.0, 4.0};
  EXPECT_EQ(tree.depth_mm(above), 0.0);
  // Lying with its axis 1 above the plane: 3 deep.
  const AxialCone lying{Vec3(-10, 0.1, 1.0), Vec3::UnitX(), 0.0, 20.0, 4.0, 4.0};
  EXPECT_LE(tree.depth_mm(lying), 3.0 + 1e-12);
  EXPECT_GT(tree.depth_mm(lying), 2.9);
  // Half angle 45 degrees, tip at the plane's level minus 2: a point on the axis is 2 / sqrt(2) from the wall.
  const AxialCone cone{Vec3(0.1, 0.2, -2.0), Vec3::UnitZ(), 0.0, 20.0, 0.0, 20.0};
  EXPECT_LE(tree.depth_mm(cone), std::sqrt(2.0) + 1e-12);
  EXPECT_GT(tree.depth_mm(cone), std::sqrt(2.0) - 0.2);
}

}  // namespace
}  // namespace volute::planner
