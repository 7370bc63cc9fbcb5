#include "geometry/turn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/cases.hpp"

namespace volute::geometry {
namespace {

void expect_shortest(const Vec3& axis) {
  const Eigen::Quaterniond turn = turn_from_z(axis);
  EXPECT_LT((turn * Vec3::UnitZ() - axis.normalized()).norm(), 2e-15) << axis.transpose();
  EXPECT_NEAR(turn.norm(), 1.0, 1e-15) << axis.transpose();
  EXPECT_EQ(turn.z(), 0.0) << axis.transpose();  // its axis lies across z
  const double angle = std::atan2(axis.head<2>().norm(), axis.z());
  EXPECT_NEAR(2.0 * std::atan2(turn.vec().norm(), turn.w()), angle, 4e-15) << axis.transpose();
}

TEST(TurnFromZ, TakesZToTheAxisByTheShortestWay) {
  std::mt19937_64 random(71);
  std::normal_distribution<> normal;
  for (int i = 0; i < cases(2000); ++i)
    expect_shortest(std::exp(3.0 * normal(random)) * Vec3(normal(random), normal(random), normal(random)));
}

TEST(TurnFromZ, KeepsItsDigitsNextToTheOppositeDirection) {
  for (double off = 1e-3; off > 1e-17; off /= 7.0) {
    for (const double way : {0.0, 1.0, 2.5, 4.0}) {
      expect_shortest(Vec3(std::sin(off) * std::cos(way), std::sin(off) * std::sin(way), -std::cos(off)));
      expect_shortest(Vec3(std::sin(off) * std::cos(way), std::sin(off) * std::sin(way), std::cos(off)));
    }
  }
}

TEST(TurnFromZ, EndsOfTheAxisItself) {
  EXPECT_TRUE(turn_from_z(Vec3::UnitZ()).isApprox(Eigen::Quaterniond::Identity(), 0.0));
  const Eigen::Quaterniond over = turn_from_z(-Vec3::UnitZ());
  EXPECT_EQ(over.coeffs(), Eigen::Vector4d(1, 0, 0, 0));
}

}  // namespace
}  // namespace volute::geometry
