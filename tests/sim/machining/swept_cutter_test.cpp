#include "sim/machining/swept_cutter.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"
#include "sim/machining/golden_section.hpp"

namespace volute::sim {
namespace {

TEST(GoldenSection, NarrowsToTheLeastValueAndKeepsTheLowerOfEquals) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<> uniform(-2.0, 2.0);
  for (int i = 0; i < cases(200); ++i) {
    const double low = uniform(random), high = low + 0.5 + std::abs(uniform(random)), at = uniform(random);
    int calls = 0;
    const auto square = [&](double x) {
      ++calls;
      return (x - at) * (x - at);
    };
    GoldenSection section(square, low, high);
    section.narrow(30);
    EXPECT_EQ(calls, 32);
    const double best = std::clamp(at, low, high), width = (high - low) * std::pow(golden, 30);
    EXPECT_LE(section.least(), std::pow(std::abs(best - at) + width, 2)) << i;
    EXPECT_GE(section.least(), std::pow(best - at, 2)) << i;
  }
  double last = 0.0;
  const auto flat = [&](double x) { return last = x, 1.0; };
  GoldenSection section(flat, 0.0, 1.0);
  section.narrow(20);
  EXPECT_LT(last, 1e-3);
}

TEST(CapsuleEntry, EqualsTheLeastOfManyBalls) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  int hits = 0;
  for (int i = 0; i < cases(500); ++i) {
    const Vec3 from = 2.0 * Vec3(uniform(random), uniform(random), uniform(random));
    const Vec3 to = i % 7 == 0 ? from : Vec3(from + 3.0 * Vec3(uniform(random), uniform(random), uniform(random)));
    const Vec3 direction = test::random_unit(random),
               point = 2.0 * Vec3(uniform(random), uniform(random), uniform(random));
    double least = 1e9;
    bool reaches = false;
    for (int k = 0; k <= 20000; ++k) {
      const Vec3 w = from + (k / 20000.0) * (to - from) - point;
      const double along = w.dot(direction), q = 1.0 - (w - along * direction).squaredNorm();
      if (q < 0.0) continue;
      least = std::min(least, along - std::sqrt(q));
      reaches = reaches || along + std::sqrt(q) >= 0.0;
    }
    const auto entry = capsule_entry_mm(from, to, 1.0, point, direction, 10.0);
    if (!reaches) {
      EXPECT_FALSE(entry) << i;
      continue;
    }
    ++hits;
    ASSERT_TRUE(entry) << "case " << i;
    EXPECT_NEAR(*entry, least, 1e-5) << "case " << i;
  }
  EXPECT_GT(hits, cases(500) / 10);
}

/// The lowest entry over a very fine row of standing cutters.
std::optional<double> brute_force(const kinematics::Cutter& cutter, const std::vector<SweptPose>& poses,
                                  const Vec3& point, const Vec3& normal, double limit) {
  const CutterProfile profile(cutter);
  // A ball's centre runs straight from pose to pose; of any other cutter, the tip does.
  const double lift =
      cutter.shape == kinematics::CutterShape::ball || cutter.shape == kinematics::CutterShape::taper_ball
          ? cutter.radius_mm
          : 0.0;
  const auto guide = [&](std::size_t i) { return Vec3(poses[i].pose.tip_P_mm + lift * poses[i].pose.axis_P); };
  std::optional<double> least;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    for (int k = 0; k <= 1000; ++k) {
      const double s = k / 1000.0;
      const Vec3 axis = ((1 - s) * poses[i - 1].pose.axis_P + s * poses[i].pose.axis_P).normalized();
      const StandingCutter at{(1 - s) * guide(i - 1) + s * guide(i) - lift * axis, axis};
      const auto t = line_entry_mm(profile, at, point, normal, limit);
      if (t && (!least || *t < *least)) least = t;
    }
  }
  return least;
}

TEST(SweptCutter, EntryEqualsAFineRowOfStandingCuttersForEveryShape) {
  std::mt19937_64 random(22);
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  const std::vector<kinematics::Cutter> cutters{test::ball(2.0), test::flat(2.0), test::bull(3.0, 0.5),
                                                test::taper_ball(1.0, 8.0)};
  int hits = 0;
  for (int i = 0; i < cases(120); ++i) {
    const auto& cutter = cutters[static_cast<std::size_t>(i) % cutters.size()];
    std::vector<SweptPose> poses;
    Vec3 tip(uniform(random), uniform(random), 0.0),
        axis = Vec3(0.3 * uniform(random), 0.3 * uniform(random), 1.0).normalized();
    for (int k = 0; k < 4; ++k) {
      poses.push_back({{tip, axis}, k + 1, 0.0, false});
      tip += Vec3(uniform(random), uniform(random), 0.2 * uniform(random));
      axis = (axis + 0.05 * Vec3(uniform(random), uniform(random), 0.0)).normalized();
    }
    const Vec3 normal = i % 3 == 0 ? Vec3(uniform(random), uniform(random), 0.1).normalized()
                                   : Vec3(0.2 * uniform(random), 0.2 * uniform(random), 1.0).normalized();
    const Vec3 point = poses[1].pose.tip_P_mm + Vec3(uniform(random), uniform(random), 0.0) - 0.5 * normal;
    const SweptCutter swept(cutter, poses, 0.0005);
    SweptCutter::Near near;
    swept.near(point, 1e-4, normal, 2.0, near);
    const auto expected = brute_force(cutter, poses, point, normal, 2.0);
    const auto found = swept.entry(point, normal, 2.0, near);
    ASSERT_EQ(expected.has_value(), found.has_value()) << "case " << i;
    if (!expected) continue;
    ++hits;
    EXPECT_NEAR(found->height_mm, *expected, 0.0015) << "case " << i << " shape " << static_cast<int>(cutter.shape);
  }
  EXPECT_GT(hits, cases(120) / 4);
}

TEST(SweptCutter, FlankCutsAWallThatTheBallAlreadyPassed) {
  // A vertical wall x = 0; the tool stands upright beside it and only its flank reaches the wall at z = 10.
  const std::vector<SweptPose> poses{{{Vec3(2.01, -5, 0), Vec3::UnitZ()}, 1, 0, false},
                                     {{Vec3(2.01, 5, 0), Vec3::UnitZ()}, 2, 0, false}};
  const SweptCutter swept(test::ball(2.0), poses, 0.0005);
  SweptCutter::Near near;
  swept.near(Vec3(0, 0, 10), 0.1, Vec3::UnitX(), 1.0, near);
  const auto entry = swept.entry(Vec3(0, 0, 10), Vec3::UnitX(), 1.0, near);
  ASSERT_TRUE(entry);
  EXPECT_NEAR(entry->height_mm, 0.01, 0.0005);
  EXPECT_EQ(entry->pose, 1);
}

TEST(BoxTree, VisitsExactlyTheBoxesThatComeNear) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<> uniform(0.0, 10.0);
  std::vector<Box> boxes;
  for (int i = 0; i < 500; ++i) {
    const Vec3 corner(uniform(random), uniform(random), uniform(random));
    boxes.emplace_back(corner, Vec3(corner + 0.1 * Vec3(uniform(random), uniform(random), uniform(random))));
  }
  const BoxTree tree(boxes);
  for (int i = 0; i < 100; ++i) {
    const Vec3 centre(uniform(random), uniform(random), uniform(random));
    std::vector<int> expected, found;
    for (int b = 0; b < 500; ++b) {
      if (boxes[static_cast<std::size_t>(b)].squaredExteriorDistance(centre) <= 1.0) expected.push_back(b);
    }
    tree.near(centre, 1.0, [&](std::int32_t b) { found.push_back(b); });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace volute::sim
