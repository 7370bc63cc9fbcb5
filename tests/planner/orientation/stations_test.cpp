// Stations: the ball stays out of the part at them and on the way between them.
#include "planner/orientation/stations.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/cases.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

/// Two half-planes that meet in a ridge or a valley along y; slopes are dz per mm away from it.
struct Fold {
  double slope_left, slope_right;
  [[nodiscard]] double height_mm(double x) const { return x < 0.0 ? -x * slope_left : x * slope_right; }
  [[nodiscard]] Vec3 normal(double x) const {
    return (x < 0.0 ? Vec3(slope_left, 0.0, 1.0) : Vec3(-slope_right, 0.0, 1.0)).normalized();
  }
  /// Closed form: to the nearer of two rays in the plane y = 0.
  [[nodiscard]] double distance_mm(const Vec3& p) const {
    const auto to_ray = [&](const Vec3& along) { return (p - std::max(p.dot(along), 0.0) * along).norm(); };
    return std::min(to_ray(Vec3(-1.0, 0.0, slope_left).normalized()), to_ray(Vec3(1.0, 0.0, slope_right).normalized()));
  }
};

Vec3 ball_centre_mm(const Station& station, double radius_mm) {
  return station.contact_P_mm + radius_mm * station.normal_P;
}

std::vector<Station> across(const Fold& fold, const std::function<double()>& step_mm) {
  CcPiece piece;
  for (double x = -12.0; x <= 12.0; x += step_mm())
    piece.points.push_back({Vec3(x, 0.0, fold.height_mm(x)), fold.normal(x), 0.0, false});
  return make_stations(piece, 1.0);
}

TEST(Stations, BallKeepsTheToleranceOnTheWholeWay) {
  const double tolerance_mm = 0.01;
  double deepest_mm = 0.0, unlifted_mm = 0.0;
  std::size_t put_in = 0;
  for (int n = 0; n < cases(40); ++n) {
    const auto seed = static_cast<unsigned>(1000 + n);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> slope(-0.8, 0.8), radius(1.0, 5.0), step(0.1, 2.5);
    const Fold fold{slope(random), slope(random)};
    const double r = radius(random);
    const kinematics::Cutter cutter{kinematics::CutterShape::ball, r, r, {}, 20.0, 2};
    kinematics::Tool tool = testing::ball_tool();
    tool.cutter = cutter;
    Scene scene;
    scene.part = testing::sheet(-30, 30, -10, 10, 1.0, [&](double x, double) { return fold.height_mm(x); });
    const Interference interference(scene, tool, nullptr, nullptr);
    std::vector<Station> stations = across(fold, [&] { return step(random); });
    const std::size_t before = stations.size();
    const auto deepest = [&] {
      double depth_mm = 0.0;
      for (std::size_t i = 1; i < stations.size(); ++i) {
        const Vec3 a = ball_centre_mm(stations[i - 1], r), b = ball_centre_mm(stations[i], r);
        for (int k = 0; k <= 200; ++k)
          depth_mm = std::max(depth_mm, r - fold.distance_mm(a + static_cast<double>(k) / 200.0 * (b - a)));
      }
      return depth_mm;
    };
    unlifted_mm = std::max(unlifted_mm, deepest());
    lift_out_of_part(stations, cutter, interference, tolerance_mm);
    ASSERT_LE(deepest(), tolerance_mm + 1e-6) << "seed " << seed;
    deepest_mm = std::max(deepest_mm, deepest());
    put_in += stations.size() - before;
    int points = 0;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      points += stations[i].between ? 0 : 1;
      EXPECT_EQ(stations[i].source, points - 1) << "seed " << seed;
      const double s_before_mm = i == 0 ? -1.0 : stations[i - 1].s_mm;
      EXPECT_GT(stations[i].s_mm, s_before_mm) << "seed " << seed;
      EXPECT_NEAR(stations[i].feed_P.dot(stations[i].normal_P), 0.0, 1e-12);
    }
    EXPECT_EQ(static_cast<std::size_t>(points), before);
  }
  EXPECT_GT(unlifted_mm, 0.1);  // it was needed
  EXPECT_GT(deepest_mm, 0.5 * tolerance_mm);
  EXPECT_GT(put_in, 0u);
}

TEST(Stations, OnAPlaneNothingIsLiftedOrPutIn) {
  const Fold plane{0.0, 0.0};
  Scene scene;
  scene.part = testing::sheet(-30, 30, -10, 10, 1.0, [](double, double) { return 0.0; });
  const kinematics::Tool tool = testing::ball_tool();
  const Interference interference(scene, tool, nullptr, nullptr);
  std::vector<Station> stations = across(plane, [] { return 1.7; });
  const std::size_t before = stations.size();
  lift_out_of_part(stations, tool.cutter, interference, 0.01);
  ASSERT_EQ(stations.size(), before);
  for (const Station& station : stations) EXPECT_EQ(station.lift_mm, 0.0);
}

}  // namespace
}  // namespace volute::planner
