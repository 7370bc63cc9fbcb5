#include "sim/machining/pose_thinner.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"

namespace volute::sim {
namespace {

using geometry::Vec3;

double off_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double s = std::clamp((p - a).dot(b - a) / std::max(1e-300, (b - a).squaredNorm()), 0.0, 1.0);
  return (p - a - s * (b - a)).norm();
}

TEST(PoseThinner, LeavesOutOnlyWhatStaysWithinTheTolerance) {
  std::vector<SweptPose> all;
  for (int i = 0; i < 20000; ++i) {
    const double t = i * 0.001, turn = 0.3 * std::sin(0.7 * t);
    all.push_back(
        {{Vec3(10 * std::cos(t), 10 * std::sin(t), t), Vec3(std::sin(turn), 0, std::cos(turn))}, i / 100, t, false});
  }
  PoseThinner thinner(0.001, 20.0);
  for (const auto& p : all) thinner.add(p);
  const auto kept = thinner.finish();
  EXPECT_LT(kept.size(), all.size() / 10);
  EXPECT_EQ(kept.front().time_s, all.front().time_s);
  EXPECT_EQ(kept.back().time_s, all.back().time_s);
  std::size_t k = 1;
  double worst = 0.0;
  for (const auto& p : all) {
    while (k + 1 < kept.size() && kept[k].time_s < p.time_s) ++k;
    const auto& a = kept[k - 1].pose;
    const auto& b = kept[k].pose;
    worst = std::max(
        {worst, off_segment(p.pose.tip_P_mm, a.tip_P_mm, b.tip_P_mm),
         off_segment(p.pose.tip_P_mm + 20 * p.pose.axis_P, a.tip_P_mm + 20 * a.axis_P, b.tip_P_mm + 20 * b.axis_P)});
  }
  EXPECT_LE(worst, 0.001);
  EXPECT_GT(worst, 0.0002);  // it uses what it is given
}

TEST(PoseThinner, KeepsTheChangeFromRapidToFeed) {
  PoseThinner thinner(0.001, 20.0);
  for (int i = 0; i <= 10; ++i) thinner.add({{Vec3(i, 0, 0), Vec3::UnitZ()}, 1, 0.1 * i, true});
  for (int i = 11; i <= 20; ++i) thinner.add({{Vec3(i, 0, 0), Vec3::UnitZ()}, 2, 0.1 * i, false});
  const auto kept = thinner.finish();
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[1].pose.tip_P_mm.x(), 10.0);
  EXPECT_TRUE(kept[1].rapid);
  EXPECT_FALSE(kept[2].rapid);
}

TEST(PoseThinner, ATurnBackIsNotShortened) {
  PoseThinner thinner(0.001, 20.0);
  for (int i = 0; i <= 50; ++i) thinner.add({{Vec3(0.1 * i, 0, 0), Vec3::UnitZ()}, 1, 0.1 * i, false});
  for (int i = 49; i >= 20; --i) thinner.add({{Vec3(0.1 * i, 0, 0), Vec3::UnitZ()}, 1, 10 - 0.1 * i, false});
  double farthest = 0.0;
  for (const auto& p : thinner.finish()) farthest = std::max(farthest, p.pose.tip_P_mm.x());
  EXPECT_NEAR(farthest, 5.0, 1e-3);
}

}  // namespace
}  // namespace volute::sim
