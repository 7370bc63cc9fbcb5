#include "planner/field/rbf_field.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/planner/field/reference.hpp"

namespace volute::planner {
namespace {

struct Setting {
  const char* key;
  RadialBasis basis;
  FieldMetric metric;
};

std::vector<FieldKey> reference_keys() {
  std::vector<FieldKey> keys;
  const Json& rbf = reference()["rbf5"];
  for (std::size_t i = 0; i < rbf["keys_uv"].size(); ++i)
    keys.push_back({{vec2(rbf["keys_uv"][i]), Vec3::Zero()}, vec3(rbf["keys_T"][i])});
  return keys;
}

const std::vector<Setting> settings{
    {"gaussian_a2_euclid_uv", {BasisKind::gaussian, 2.0, 1.0, 2}, {FieldDistance::parameters, 1.0}},
    {"imq_c0.8_beta1_euclid_uv", {BasisKind::inverse_multiquadric, 0.8, 1.0, 2}, {FieldDistance::parameters, 1.0}},
    {"cos5_a0.4_cylinder_wu0.25", {BasisKind::half_open, 0.4, 1.0, 2}, {FieldDistance::cylinder, 0.25}},
    {"cos5_a0.4_cylinder_wu1over2pi",
     {BasisKind::half_open, 0.4, 1.0, 2},
     {FieldDistance::cylinder, 0.5 / std::numbers::pi}}};

TEST(RbfField, AgreesWithWorkedNumbers) {
  for (const Setting& setting : settings) {
    const Json& expected = reference()["rbf5"][setting.key];
    const auto field = RbfField::fit(reference_keys(), setting.basis, setting.metric);
    ASSERT_TRUE(field) << setting.key << ": " << field.error().message;
    for (std::size_t i = 0; i < field->coefficients().size(); ++i)
      EXPECT_LT((field->coefficients()[i] - vec3(expected["coefficients"][i])).norm(), 1e-10)
          << setting.key << " coefficient " << i;
    for (std::size_t i = 0; i < expected["eval"].size(); ++i) {
      const FieldPlace place{vec2(reference()["rbf5"]["eval_uv"][i]), Vec3::Zero()};
      EXPECT_LT((field->raw(place) - vec3(expected["eval"][i]["T"])).norm(), 1e-10) << setting.key << " place " << i;
      EXPECT_LT((*field->axis(place) - vec3(expected["eval"][i]["T_unit"])).norm(), 1e-10)
          << setting.key << " place " << i;
    }
  }
}

// The first row of the interpolation's matrix: basis and distance alone.
TEST(RbfField, BasisAndDistanceAgreeWithWorkedNumbers) {
  const std::vector<FieldKey> keys = reference_keys();
  for (const Setting& setting : settings) {
    const Json& row = reference()["rbf5"][setting.key]["matrix_row0"];
    ASSERT_EQ(row.size(), keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const double distance = field_distance(setting.metric, keys[0].place, keys[i].place);
      EXPECT_NEAR(basis_value(setting.basis, distance), row[i].get<double>(), 1e-15) << setting.key << " key " << i;
    }
  }
}

/// Property 1 over random keys in space.
TEST(RbfField, MeetsEveryKey) {
  const unsigned seed = 20161207;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 100.0), lean(-0.7, 0.7);
  for (int round = 0; round < 20; ++round) {
    std::vector<FieldKey> keys;
    for (int i = 0; i < 15; ++i)
      keys.push_back({{Vec2::Zero(), {place(random), place(random), 0.1 * place(random)}},
                      Vec3(lean(random), lean(random), 1.0).normalized()});
    const auto field = RbfField::fit(keys, {BasisKind::inverse_multiquadric, 20.0, 1.0, 2}, {});
    ASSERT_TRUE(field) << "seed " << seed << " round " << round;
    for (const FieldKey& key : keys)
      EXPECT_LT((field->raw(key.place) - key.axis_P).norm(), 1e-13 / field->reciprocal_condition()) << "seed " << seed;
  }
}

TEST(RbfField, HalfOpenFieldIsContinuousAcrossTheSeam) {
  const auto field =
      RbfField::fit(reference_keys(), {BasisKind::half_open, 0.4, 1.0, 2}, {FieldDistance::cylinder, 0.25});
  ASSERT_TRUE(field);
  for (double u = 0.0; u <= 1.0; u += 0.1)
    EXPECT_LT((field->raw({{u, 1e-9}, {}}) - field->raw({{u, 1.0 - 1e-9}, {}})).norm(), 1e-6);
}

TEST(RbfField, SeamKeysAtBothEndsAreRefused) {
  std::vector<FieldKey> keys = reference_keys();
  keys[0].place.uv = {0.3, 0.0};
  keys[1].place.uv = {0.3, 1.0};
  const auto field = RbfField::fit(keys, {BasisKind::half_open, 0.4, 1.0, 2}, {FieldDistance::cylinder, 0.25});
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().code, "field-keys-coincide");
}

TEST(RbfField, FlatBasisIsRefusedAsSingular) {
  const auto field =
      RbfField::fit(reference_keys(), {BasisKind::gaussian, 1e-4, 1.0, 2}, {FieldDistance::parameters, 1.0});
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().code, "field-singular");
}

TEST(RbfField, OppositeKeysVanishInBetween) {
  std::vector<FieldKey> keys{{{{0, 0}, {}}, Vec3::UnitX()}, {{{1, 0}, {}}, -Vec3::UnitX()}};
  const auto field = RbfField::fit(keys, {BasisKind::gaussian, 1.0, 1.0, 2}, {FieldDistance::parameters, 1.0});
  ASSERT_TRUE(field);
  EXPECT_FALSE(field->axis({{0.5, 0.0}, {}}).has_value());
}

TEST(RadialBasis, HalfOpenFallsToZeroWithZeroSlopeAtBothEnds) {
  const RadialBasis basis{BasisKind::half_open, 0.4, 1.0, 2};
  EXPECT_DOUBLE_EQ(basis_value(basis, 0.0), 1.0);
  EXPECT_EQ(basis_value(basis, 0.41), 0.0);
  EXPECT_NEAR((basis_value(basis, 1e-6) - 1.0) / 1e-6, 0.0, 1e-4);
  EXPECT_NEAR(basis_value(basis, 0.4 - 1e-4) / 1e-4, 0.0, 1e-6);
}

}  // namespace
}  // namespace volute::planner
