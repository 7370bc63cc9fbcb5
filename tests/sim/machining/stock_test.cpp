#include "sim/machining/stock.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>
#include <numbers>
#include <random>

#include "shapes.hpp"

namespace volute::sim {
namespace {

using geometry::Vec3;
using test::pose_at;
constexpr double pi = std::numbers::pi;

double removed(Stock& stock, const kinematics::Cutter& cutter, const std::vector<SweptPose>& poses) {
  double sum = 0.0;
  for (const double v : stock.cut(cutter, poses, 0.002)) sum += v;
  return sum;
}

geometry::TriangleMesh block(const Vec3& low, const Vec3& high) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices_mm.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

double mesh_volume(const geometry::TriangleMesh& mesh) {
  double six = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto v = [&](std::size_t k) { return mesh.vertices_mm[static_cast<std::size_t>(t[k])]; };
    six += v(0).dot(v(1).cross(v(2)));
  }
  return six / 6.0;
}

/// Closed, oriented, every edge with two triangles and every vertex with one ring of them.
void expect_manifold(const geometry::TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  std::vector<std::map<int, int>> ring(mesh.vertices_mm.size());  // of a vertex: which neighbour follows which
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{t[k], t[(k + 1) % 3]}];
      ring[static_cast<std::size_t>(t[k])][t[(k + 1) % 3]] = t[(k + 2) % 3];
    }
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << edge.first << " " << edge.second;
    ASSERT_TRUE(edges.contains({edge.second, edge.first})) << edge.first << " " << edge.second;
  }
  for (std::size_t v = 0; v < ring.size(); ++v) {
    ASSERT_FALSE(ring[v].empty()) << v;
    std::size_t steps = 0;
    int at = ring[v].begin()->first;
    do at = ring[v].at(at);
    while (++steps <= ring[v].size() && at != ring[v].begin()->first);
    ASSERT_EQ(steps, ring[v].size()) << v;
  }
}

TEST(Stock, ABoxHasItsVolume) { EXPECT_NEAR(Stock::box({0, 0, 0}, {30, 20, 10}, 0.2).volume_mm3(), 6000.0, 1e-6); }

TEST(Stock, AFlatSlotRemovesALengthAndTwoHalfDiscs) {
  Stock stock = Stock::box({0, 0, 0}, {60, 30, 12}, 0.1);
  const double radius = 5.03, depth = 4.97;
  const double volume =
      removed(stock, test::flat(radius, 30), {pose_at({12, 15, 12 - depth}), pose_at({48, 15, 12 - depth})});
  const double expected = depth * (36.0 * 2 * radius + pi * radius * radius);
  EXPECT_NEAR(volume, expected, 0.005 * expected);
  test::record_error("error_ppm", volume, expected);
  EXPECT_NEAR(stock.volume_mm3() + volume, 60.0 * 30 * 12, 1e-6 * 21600);
}

TEST(Stock, ABallGrooveRemovesACircleSegmentTimesItsLength) {
  Stock stock = Stock::box({0, 0, 0}, {40, 30, 12}, 0.1);
  const double r = 4.0, depth = 2.5;  // right through the block, so the ends do not matter
  const double volume =
      removed(stock, test::ball(r, 30), {pose_at({-8, 15, 12 - depth}), pose_at({48, 15, 12 - depth})});
  const double half = std::acos((r - depth) / r), segment = r * r * (half - std::sin(half) * std::cos(half));
  EXPECT_NEAR(volume, 40.0 * segment, 0.005 * 40.0 * segment);
  test::record_error("error_ppm", volume, 40.0 * segment);
}

TEST(Stock, ATiltedCylinderThroughAPlateRemovesAreaTimesLengthWithin) {
  Stock stock = Stock::box({0, 0, 0}, {40, 40, 10}, 0.1);
  const double tilt = 0.5, r = 4.0;
  const Vec3 axis(std::sin(tilt), 0, std::cos(tilt));
  const double volume = removed(stock, test::flat(r, 60), {pose_at(Vec3(20, 20, 5) - 30.0 * axis, axis)});
  const double expected = pi * r * r * 10.0 / std::cos(tilt);
  EXPECT_NEAR(volume, expected, 0.005 * expected);
  test::record_error("error_ppm", volume, expected);
}

TEST(Stock, BullAndTaperPlungesRemoveTheirOwnVolume) {
  const double R = 5.0, c = 1.5, depth = 6.0;
  Stock a = Stock::box({-10, -10, 0}, {10, 10, 10}, 0.1);
  const double bull = removed(a, test::bull(R, c, 30), {pose_at({0, 0, 10 - depth})});
  // A full cylinder less the ring outside the rounded rim (Pappus).
  const double corner = (1 - pi / 4) * c * c;
  // The spandrel's centroid lies (10 - 3 pi) / (12 - 3 pi) * c from the square's outer corner.
  const double from_axis = R - c * (10 - 3 * pi) / (12 - 3 * pi);
  const double expected_bull = pi * R * R * depth - 2 * pi * from_axis * corner;
  EXPECT_NEAR(bull, expected_bull, 0.005 * expected_bull);
  test::record_error("error_bull_ppm", bull, expected_bull);

  Stock b = Stock::box({-10, -10, 0}, {10, 10, 10}, 0.1);
  const double r = 2.0, t = 0.3;
  const double taper = removed(b, test::taper_ball(r, t * 180 / pi, 30), {pose_at({0, 0, 10 - depth})});
  const double z = r * (1 - std::sin(t)), rim = r * std::cos(t), top = rim + (depth - z) * std::tan(t);
  const double cap = pi * z * z * (r - z / 3), cone = pi * (depth - z) / 3 * (rim * rim + rim * top + top * top);
  EXPECT_NEAR(taper, cap + cone, 0.005 * (cap + cone));
}

TEST(Stock, SlantedMoveOfABallIsACapsuleWithinTheBlock) {
  Stock stock = Stock::box({-20, -20, -20}, {20, 20, 20}, 0.2);
  // The ball alone: flutes no longer than the ball's half.
  const double r = 3.0, length = 15.0;
  const Vec3 way = Vec3(1, 0.5, -0.7).normalized();
  // Its sharp rim leaves straight steps between places, so they stand close here.
  double volume = 0.0;
  const std::vector<SweptPose> way_poses{pose_at(Vec3(-5, -3, 4)), pose_at(Vec3(-5, -3, 4) + length * way)};
  for (const double v : stock.cut(test::ball(r, r), way_poses, 0.0001)) volume += v;
  // A lower half ball swept: half balls at the ends, between them the projected area of the half ball across the way.
  const double along = std::abs(way.z());
  const double area = 0.5 * pi * r * r * (1.0 + along);
  const double expected = 2.0 / 3.0 * pi * r * r * r + length * area;
  EXPECT_NEAR(volume, expected, 0.005 * expected);
}

TEST(Stock, CuttingTwiceRemovesNothingMore) {
  Stock stock = Stock::box({0, 0, 0}, {20, 20, 10}, 0.2);
  const std::vector<SweptPose> poses{pose_at({0, 5, 7}), pose_at({20, 12, 6}, Vec3(0.2, 0, 1).normalized())};
  EXPECT_GT(removed(stock, test::ball(3, 20), poses), 0.0);
  EXPECT_EQ(removed(stock, test::ball(3, 20), poses), 0.0);
}

TEST(Stock, SolidOfAClosedMeshHasItsVolumeAndAnOpenOneIsRefused) {
  auto mesh = block({0, 0, 0}, {20, 15, 10});
  const Eigen::AngleAxisd turn(0.4, Vec3(1, 2, 3).normalized());
  for (auto& v : mesh.vertices_mm) v = turn * v;
  const auto stock = Stock::solid(mesh, 0.1);
  ASSERT_TRUE(stock) << stock.error().message;
  EXPECT_NEAR(stock->volume_mm3(), 3000.0, 0.002 * 3000.0);
  mesh.triangles.pop_back();
  const auto open = Stock::solid(mesh, 0.1);
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().code, "stock-not-closed");
  EXPECT_FALSE(Stock::solid({}, 0.1));
}

TEST(Stock, SkinIsClosedAndHoldsTheVolume) {
  Stock stock = Stock::box({0, 0, 0}, {20, 16, 10}, 0.25);
  removed(stock, test::ball(4, 20), {pose_at({-6, 8, 6}), pose_at({26, 9, 7}, Vec3(0, 0.3, 1).normalized())});
  const auto skin = stock.skin();
  EXPECT_NEAR(mesh_volume(skin), stock.volume_mm3(), 0.01 * stock.volume_mm3());
  expect_manifold(skin);
}

// Nodes taken out at random: inside corners lie across from each other on many faces, in cells of many sheets.
TEST(Stock, SkinIsAManifoldHoweverTheMaterialLies) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    constexpr int nodes = 12;
    Stock stock = Stock::box({0, 0, 0}, {nodes, nodes, nodes}, 1.0);
    std::uniform_int_distribution<int> node(0, nodes - 1);
    const int taken = 150 * static_cast<int>(seed);
    for (int i = 0; i < taken; ++i)  // a ball about the node that reaches no other
      removed(stock, test::ball(0.45, 0.9), {pose_at({node(random) + 0.5, node(random) + 0.5, node(random) + 0.05})});
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto skin = stock.skin();
    EXPECT_GT(skin.triangles.size(), 1000u);
    expect_manifold(skin);
  }
}

TEST(Stock, DoesNotDependOnTheNumberOfThreads) {
  const std::vector<SweptPose> poses{pose_at({0, 5, 7}), pose_at({20, 12, 6}, Vec3(0.2, 0, 1).normalized()),
                                     pose_at({3, 18, 5})};
  Stock many = Stock::box({0, 0, 0}, {20, 20, 10}, 0.2), single = many;
  const auto a = many.cut(test::ball(3, 20), poses, 0.01);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(a, single.cut(test::ball(3, 20), poses, 0.01));
  EXPECT_EQ(many.volume_mm3(), single.volume_mm3());
}

}  // namespace
}  // namespace volute::sim
