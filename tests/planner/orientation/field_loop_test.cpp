#include "planner/orientation/field_loop.hpp"

#include <gtest/gtest.h>

#include "planner/field/mesh_field.hpp"
#include "tests/planner/orientation/strip.hpp"

namespace volute::planner {
namespace {

using testing::AllowedStrip;
using testing::Strip;

std::vector<Vec3> upright(const AllowedStrip& strip) { return std::vector<Vec3>(strip.stations.size(), Vec3::UnitZ()); }

TEST(FieldLoop, WithoutObstaclesTheKeysStandAndTheFieldMeetsThem) {
  Strip strip({});
  const Vec3 lean = Vec3(0.0, 0.2, 1.0).normalized();
  strip.options.keys = {{{}, Vec3(10, 0, 0), lean}, {{}, Vec3(90, 0, 0), Vec3::UnitZ()}};
  const AllowedStrip allowed(strip);
  const auto result = run_field_loop(allowed.set, upright(allowed), {{100, lean}}, strip.options);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->allowed);
  EXPECT_EQ(result->keys, 3);
  EXPECT_EQ(result->iterations, 1);
  EXPECT_NEAR((result->axes_P[100] - lean).norm(), 0.0, 1e-6);  // a fixed pin stands on its station
}

/// The same interpolation, fitted apart from the loop.
TEST(FieldLoop, FollowsTheFieldOfItsKeys) {
  Strip strip({});
  const Vec3 lean = Vec3(0.1, 0.3, 1.0).normalized();
  strip.options.keys = {{{}, Vec3(10, 0, 1), lean}, {{}, Vec3(50, 0, 1), Vec3::UnitZ()}, {{}, Vec3(90, 0, -1), lean}};
  const AllowedStrip allowed(strip);
  const auto result = run_field_loop(allowed.set, upright(allowed), {}, strip.options);
  ASSERT_TRUE(result) << result.error().message;
  std::vector<FieldKey> keys;
  for (const KeyOrientation& key : strip.options.keys)
    keys.push_back({{geometry::Vec2::Zero(), *key.point_P_mm}, key.axis_P});
  const auto field = RbfField::fit(keys, with_width(strip.options.field.basis, keys, {}), {});
  ASSERT_TRUE(field);
  for (std::size_t i = 0; i < result->axes_P.size(); i += 7) {
    const auto axis = field->axis({geometry::Vec2::Zero(), allowed.stations[i].contact_P_mm});
    EXPECT_NEAR((result->axes_P[i] - *axis).norm(), 0.0, 1e-12) << i;
  }
}

TEST(FieldLoop, AddsKeysWhereSomethingTouchesUntilNothingDoes) {
  Strip strip({testing::wall_beside_the_middle()});
  const AllowedStrip allowed(strip);
  const std::vector<FixedPin> ends = {{0, Vec3::UnitZ()},
                                      {static_cast<int>(allowed.stations.size()) - 1, Vec3::UnitZ()}};
  const auto result = run_field_loop(allowed.set, upright(allowed), ends, strip.options);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->allowed);
  EXPECT_GT(result->keys, 2);
  EXPECT_GT(result->iterations, 1);
  for (std::size_t i = 0; i < result->axes_P.size(); ++i)
    EXPECT_EQ(allowed.set.blocked(static_cast<int>(i), result->axes_P[i]), Blocked::no) << i;
}

TEST(FieldLoop, EndsWhereThereIsNoRoomForAKey) {
  // A cover over the middle: nothing is allowed there, so no key helps, and the loop says so instead of going on.
  Strip strip({testing::box(Vec3(40, -14, 12), Vec3(60, 14, 20))});
  const AllowedStrip allowed(strip);
  const auto result = run_field_loop(allowed.set, upright(allowed), {{0, Vec3::UnitZ()}}, strip.options);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_FALSE(result->allowed);
  EXPECT_LE(result->iterations, strip.options.iterations_max);
}

TEST(FieldLoop, TwoKeysAtOnePlaceAreOne) {
  Strip strip({});
  strip.options.keys = {{{}, Vec3(10, 0, 0), Vec3::UnitZ()}, {{}, Vec3(10, 0, 0), Vec3::UnitZ()}};
  const AllowedStrip allowed(strip);
  const auto result = run_field_loop(allowed.set, upright(allowed), {}, strip.options);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->keys, 1);
}

}  // namespace
}  // namespace volute::planner
