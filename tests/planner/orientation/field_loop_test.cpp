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

/// Every placement, interpolated and as a spline, follows the field that is fitted apart from the loop over the box of
/// the contacts.
TEST(FieldLoop, FollowsEveryPlacement) {
  Strip strip({});
  // Round the middle instead of along it, so that the angle about z says something.
  const auto on_circle = [](double angle) {
    const double x = 50.0 + 12.0 * std::cos(angle);
    return Vec3(x, 12.0 * std::sin(angle), 2.0 * std::sin(0.05 * x));
  };
  strip.piece.points.resize(150);
  for (std::size_t k = 0; k < strip.piece.points.size(); ++k) {
    strip.piece.points[k].point_P_mm = on_circle(0.04 * static_cast<double>(k));
    strip.piece.points[k].normal_P = Vec3(-0.1 * std::cos(0.05 * strip.piece.points[k].point_P_mm.x()), 0.0, 1.0);
    strip.piece.points[k].normal_P.normalize();
  }
  const Vec3 lean = Vec3(0.1, 0.3, 1.0).normalized();
  strip.options.keys = {{{}, on_circle(0.3), lean}, {{}, on_circle(2.2), Vec3::UnitZ()}, {{}, on_circle(4.4), lean}};
  std::vector<PointKey> keys;
  for (const KeyOrientation& key : strip.options.keys) keys.push_back({*key.point_P_mm, key.axis_P});
  std::vector<std::vector<Vec3>> fields;
  for (const FieldPlacement placement : {FieldPlacement::straight, FieldPlacement::box, FieldPlacement::cylinder}) {
    for (const bool spline : {false, true}) {
      if (spline && placement == FieldPlacement::straight) continue;
      strip.options.field = {};
      strip.options.field.placement = placement;
      strip.options.field.spline = spline;
      const AllowedStrip allowed(strip);
      const auto result = run_field_loop(allowed.set, upright(allowed), {}, strip.options);
      ASSERT_TRUE(result) << result.error().message;
      std::vector<Vec3> contacts;
      for (const Station& station : allowed.stations) contacts.push_back(station.contact_P_mm);
      const auto field = SurfaceField::fit(FieldFrame(placement, contacts), keys, strip.options.field);
      ASSERT_TRUE(field) << field.error().message;
      for (std::size_t i = 0; i < result->axes_P.size(); i += 7)
        EXPECT_NEAR((result->axes_P[i] - *field->axis(contacts[i])).norm(), 0.0, 1e-12) << i;
      fields.push_back(result->axes_P);
    }
  }
  // They are different fields.
  for (std::size_t a = 0; a < fields.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      double apart = 0.0;
      for (std::size_t i = 0; i < fields[a].size(); ++i) apart = std::max(apart, (fields[a][i] - fields[b][i]).norm());
      EXPECT_GT(apart, 1e-6) << a << " " << b;
    }
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
