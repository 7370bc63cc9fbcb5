#include "sim/machining/cutter_profile.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"

namespace volute::sim {
namespace {

using test::ball;
using test::bull;
using test::flat;
using test::taper_ball;

std::vector<kinematics::Cutter> every_cutter() {
  return {ball(3.0), flat(5.0), bull(6.0, 1.0), bull(6.0, 4.0), taper_ball(1.0, 5.0), taper_ball(2.0, 15.0, 12.0)};
}

/// Distance to the boundary, by walking along it: shares nothing with the code but the radius law below.
double walked_distance(const kinematics::Cutter& cutter, double radius, double z) {
  const auto wall = [&](double height) {
    const double r = cutter.radius_mm, c = cutter.corner_radius_mm;
    if (cutter.shape == kinematics::CutterShape::flat) return r;
    const double t = cutter.taper.radians(), lift = c * (1.0 - std::sin(t));
    if (height < lift) return r - c + std::sqrt(std::max(0.0, c * c - (c - height) * (c - height)));
    return r - c + c * std::cos(t) + (height - lift) * std::tan(t);
  };
  double best = 1e9;
  const int steps = 200000;
  for (int i = 0; i <= steps; ++i) {
    // Denser at the bottom, where the arc runs flat.
    const double share = static_cast<double>(i) / steps, height = cutter.length_mm * share * share;
    best = std::min(best, std::hypot(radius - wall(height), z - height));
  }
  const double bottom = wall(0.0), top = wall(cutter.length_mm);
  best = std::min(best, std::hypot(std::max(0.0, radius - bottom), z));
  return std::min(best, std::hypot(std::max(0.0, radius - top), z - cutter.length_mm));
}

TEST(CutterProfile, DistanceEqualsAWalkAlongTheOutline) {
  std::mt19937_64 random(11);
  for (const auto& cutter : every_cutter()) {
    const CutterProfile profile(cutter);
    for (int i = 0; i < 20; ++i) {
      const double radius = std::uniform_real_distribution<>(0.0, 12.0)(random);
      const double z = std::uniform_real_distribution<>(-6.0, 26.0)(random);
      EXPECT_NEAR(std::abs(profile.distance(radius, z).value_mm), walked_distance(cutter, radius, z), 2e-4)
          << static_cast<int>(cutter.shape) << " at " << radius << " " << z;
    }
  }
}

TEST(CutterProfile, SignSaysInsideOrOutside) {
  const CutterProfile profile(bull(6.0, 1.0));
  EXPECT_LT(profile.distance(0.0, 0.5).value_mm, 0.0);
  EXPECT_GT(profile.distance(0.0, -0.5).value_mm, 0.0);
  EXPECT_GT(profile.distance(5.95, 0.05).value_mm, 0.0);  // beside the rounded corner
  EXPECT_LT(profile.distance(5.6, 0.3).value_mm, 0.0);
  EXPECT_NEAR(profile.distance(5.0 + 2.0 / std::numbers::sqrt2, 1.0 - 2.0 / std::numbers::sqrt2).value_mm, 1.0, 1e-12);
}

TEST(CutterProfile, GradientHasUnitLengthAndIsTheSlope) {
  std::mt19937_64 random(12);
  for (const auto& cutter : every_cutter()) {
    const CutterProfile profile(cutter);
    for (int i = 0; i < 200; ++i) {
      const double radius = std::uniform_real_distribution<>(0.1, 12.0)(random);
      const double z = std::uniform_real_distribution<>(-6.0, 26.0)(random);
      const auto d = profile.distance(radius, z);
      const double step = 1e-6;
      const double slope_r =
          (profile.distance(radius + step, z).value_mm - profile.distance(radius - step, z).value_mm) / (2 * step);
      const double slope_z =
          (profile.distance(radius, z + step).value_mm - profile.distance(radius, z - step).value_mm) / (2 * step);
      EXPECT_NEAR(d.gradient.norm(), 1.0, 1e-9);
      if (d.value_mm > 0.0) {  // inside, the gradient turns where two sides are equally near
        EXPECT_NEAR(d.gradient.x(), slope_r, 1e-4);
        EXPECT_NEAR(d.gradient.y(), slope_z, 1e-4);
      }
    }
  }
}

TEST(CutterProfile, SupportIsTheFarthestPointOfTheOutline) {
  for (const auto& cutter : every_cutter()) {
    const CutterProfile profile(cutter);
    for (double along = -1.0; along <= 0.999; along += 0.1) {
      const Vec2 direction(std::sqrt(1.0 - along * along), along);
      const double reach = profile.support(along).dot(direction);
      for (double z = 0.0; z <= cutter.length_mm; z += 0.05) {
        for (double radius = 0.0; radius < 14.0; radius += 0.1) {
          if (profile.distance(radius, z).value_mm <= 0.0) {
            ASSERT_LE(direction.dot(Vec2(radius, z)), reach + 1e-9);
          }
        }
      }
      EXPECT_NEAR(profile.distance(profile.support(along).x(), profile.support(along).y()).value_mm, 0.0, 1e-9);
    }
  }
}

TEST(LineEntry, BallBeginsAtTheSphere) {
  const CutterProfile profile(ball(3.0));
  const StandingCutter cutter{Vec3(0, 0, 1), Vec3::UnitZ()};
  EXPECT_NEAR(*line_entry_mm(profile, cutter, Vec3(0, 0, 0), Vec3::UnitZ(), 5.0), 1.0, 1e-9);
  EXPECT_NEAR(*line_entry_mm(profile, cutter, Vec3(1, 0, 0), Vec3::UnitZ(), 5.0), 4.0 - std::sqrt(8.0), 1e-9);
  EXPECT_FALSE(line_entry_mm(profile, cutter, Vec3(1, 0, 0), Vec3::UnitZ(), 1.0));
  EXPECT_FALSE(line_entry_mm(profile, cutter, Vec3(3.01, 0, 0), Vec3::UnitZ(), 5.0));
}

TEST(LineEntry, StartInsideGivesTheDepthBelow) {
  const CutterProfile profile(flat(5.0));
  const StandingCutter cutter{Vec3(0, 0, -0.02), Vec3::UnitZ()};
  EXPECT_NEAR(*line_entry_mm(profile, cutter, Vec3(1, 2, 0), Vec3::UnitZ(), 1.0), -0.02, 1e-9);
}

TEST(LineEntry, CutterWhollyBelowDoesNotCount) {
  const CutterProfile profile(ball(1.0, 3.0));
  const StandingCutter cutter{Vec3(0, 0, -10), Vec3::UnitZ()};
  EXPECT_FALSE(line_entry_mm(profile, cutter, Vec3(0, 0, 0), Vec3::UnitZ(), 1.0));
}

TEST(LineEntry, IsTheFirstPointOfTheSolidOnRandomLines) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  int hits = 0;
  for (int i = 0; i < cases(400); ++i) {
    const auto cutters = every_cutter();
    const CutterProfile profile(cutters[static_cast<std::size_t>(i) % cutters.size()]);
    const StandingCutter cutter{Vec3(uniform(random), uniform(random), uniform(random)), test::random_unit(random)};
    const Vec3 start = cutter.tip_mm + 8.0 * Vec3(uniform(random), uniform(random), uniform(random));
    const Vec3 direction = test::random_unit(random);
    const auto inside = [&](double t) {
      const Vec3 w = start + t * direction - cutter.tip_mm;
      const double z = w.dot(cutter.axis);
      return profile.distance((w - z * cutter.axis).norm(), z).value_mm;
    };
    const auto entry = line_entry_mm(profile, cutter, start, direction, 30.0);
    double first = 1e9;  // by steps from 60 mm below upwards; counts only when the solid reaches t >= 0
    bool above = false;
    for (double t = -60.0; t <= 30.0; t += 0.01) {
      if (inside(t) > 0.0) continue;
      first = std::min(first, t);
      above = above || t >= 0.0;
    }
    if (!above) {
      EXPECT_TRUE(!entry || std::abs(inside(*entry)) < 1e-6) << "case " << i;
      continue;
    }
    ++hits;
    ASSERT_TRUE(entry) << "case " << i;
    EXPECT_NEAR(inside(*entry), 0.0, 1e-8);
    EXPECT_LE(*entry, first + 1e-9);
    EXPECT_GE(*entry, first - 0.0101);
  }
  EXPECT_GT(hits, cases(400) / 10);
}

}  // namespace
}  // namespace volute::sim
