#include "planner/orientation/motion.hpp"

#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "planner/orientation/neighbours.hpp"

namespace volute::planner {
namespace {

std::vector<double> random_places(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(0.02, 1.5);
  std::vector<double> s = {0.0};
  while (s.size() < count) s.push_back(s.back() + step(random));
  return s;
}

TEST(MotionPeaks, CubicsGiveTheirDerivatives) {
  const std::vector<double> s = random_places(3, 200);
  std::vector<double> phi;
  for (const double x : s) phi.push_back(0.25 * x * x * x);
  const double feed = 2.0;
  const AxisMotionPeaks peaks = motion_peaks(s, phi, feed);
  EXPECT_NEAR(peaks.jerk_max, 1.5 * feed * feed * feed, 1e-4);
  EXPECT_NEAR(peaks.jerk_rms, 1.5 * feed * feed * feed, 1e-4);
  std::vector<double> square;
  for (const double x : s) square.push_back(0.5 * x * x);
  const AxisMotionPeaks of_square = motion_peaks(s, square, feed);
  EXPECT_NEAR(of_square.acceleration_max, feed * feed, 1e-8);
  EXPECT_NEAR(of_square.acceleration_rms, feed * feed, 1e-8);
}

TEST(MotionPeaks, NoQuotientPassesTheDerivative) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<double> s = random_places(seed, 500);
    std::vector<double> phi;
    const double w = 0.7;
    for (const double x : s) phi.push_back(std::sin(w * x));
    const AxisMotionPeaks peaks = motion_peaks(s, phi, 1.0);
    EXPECT_LE(peaks.velocity_max, w) << "seed " << seed;
    EXPECT_LE(peaks.acceleration_max, w * w + 1e-9) << "seed " << seed;
    EXPECT_LE(peaks.jerk_max, w * w * w + 1e-7) << "seed " << seed;
    EXPECT_GT(peaks.jerk_max, 0.8 * w * w * w) << "seed " << seed;
  }
}

/// An Archimedean spiral of 2 mm a turn in the plane.
std::vector<Station> spiral(int turns, int per_turn) {
  std::vector<Station> stations;
  for (int i = 0; i <= turns * per_turn; ++i) {
    const double turn = static_cast<double>(i) / per_turn, angle = 2.0 * std::numbers::pi * turn;
    Station station;
    station.contact_P_mm = (30.0 - 2.0 * turn) * Vec3(std::cos(angle), std::sin(angle), 0.0);
    station.turn = turn;
    if (i > 0) station.s_mm = stations.back().s_mm + (station.contact_P_mm - stations.back().contact_P_mm).norm();
    stations.push_back(station);
  }
  return stations;
}

TEST(Neighbours, LieOneTurnBeforeAndAfter) {
  const int per_turn = 180;
  const std::vector<Station> stations = spiral(6, per_turn);
  const std::vector<int> wanted = {400, 10, 6 * per_turn - 10};
  const auto beside = neighbouring_stations(stations, wanted, 5.0);
  EXPECT_NEAR(beside[0][0], 400 - per_turn, 2);
  EXPECT_NEAR(beside[0][1], 400 + per_turn, 2);
  EXPECT_EQ(beside[1][0], -1);
  EXPECT_NEAR(beside[1][1], 10 + per_turn, 2);
  EXPECT_EQ(beside[2][1], -1);
}

TEST(Neighbours, TheLargestTurnIsFound) {
  const int per_turn = 180;
  const std::vector<Station> stations = spiral(5, per_turn);
  std::vector<Vec3> axes(stations.size(), Vec3::UnitZ());
  EXPECT_NEAR(neighbour_turn_max_rad(stations, axes, 5.0), 0.0, 1e-12);
  // One turn leans by 0.3: both its neighbours stand 0.3 away.
  for (std::size_t i = 2 * per_turn; i < 3 * per_turn; ++i) axes[i] = Vec3(std::sin(0.3), 0.0, std::cos(0.3));
  EXPECT_NEAR(neighbour_turn_max_rad(stations, axes, 5.0), 0.3, 1e-9);
  EXPECT_EQ(neighbour_turn_max_rad(stations, axes, 1.0), 0.0);  // out of reach
}

}  // namespace
}  // namespace volute::planner
