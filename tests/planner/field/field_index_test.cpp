#include "planner/field/field_index.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/planner/field/reference.hpp"

namespace volute::planner {
namespace {

using std::numbers::pi;

TEST(FieldIndex, AgreesWithWorkedNumbersInEveryReading) {
  const Json& expected = reference()["S_TD"];
  FieldGrid grid;
  for (const Json& row : expected["T"]) grid.push_back(vec3_list(row));
  const SmoothnessIndexes indexes = smoothness(grid);
  EXPECT_NEAR(indexes.s_td_literal, expected["eq9_literal_times_du_dv_mean"].get<double>(), 1e-15);
  EXPECT_NEAR(indexes.s_td_derivative, expected["derivative_mean_(divide_by_du_dv)"].get<double>(), 1e-12);
  EXPECT_NEAR(indexes.s_td_sum, expected["sum_over_8_no_mean_no_du_dv"].get<double>(), 1e-12);
  EXPECT_NEAR(indexes.dirichlet, expected["dirichlet_mean_no_cross_term"].get<double>(), 1e-12);
  // The sums that they are made of: central differences over 2 / 4 and 2 / 5, mean over the inner points.
  const double inner = expected["interior_points"].get<double>(), du_sq = expected["sum_du.du"].get<double>(),
               dv_sq = expected["sum_dv.dv"].get<double>(), du_dv = expected["sum_du.dv"].get<double>();
  EXPECT_NEAR(indexes.dirichlet, 0.5 * (4.0 * du_sq + 6.25 * dv_sq) / inner, 1e-12);
  EXPECT_NEAR(indexes.s_td_derivative - indexes.dirichlet, 5.0 * du_dv / inner, 1e-12);
  EXPECT_NEAR(fitting_accuracy(vec3_list(reference()["I_fa"]["key"]), vec3_list(reference()["I_fa"]["fit"])),
              reference()["I_fa"]["I_fa"].get<double>(), 1e-15);
}

/// The half-sphere of [Huang2016] case 3: tool axes 10 degrees beyond the latitude.
Vec3 half_sphere_axis(const Vec2& uv) {
  const double lean = pi * uv.x() / 2 + pi / 18, around = 2 * pi * uv.y();
  return {std::sin(lean) * std::cos(around), std::sin(lean) * std::sin(around), std::cos(lean)};
}

TEST(FieldIndex, HalfSphereTendsToItsClosedForm) {
  const double limit = reference()["half_sphere_limit"]["mean_derivative_energy_limit"].get<double>();
  const double coarse = std::abs(smoothness(sample_grid(half_sphere_axis, 41, 121)).s_td_derivative - limit);
  const double fine = std::abs(smoothness(sample_grid(half_sphere_axis, 161, 481)).s_td_derivative - limit);
  EXPECT_LT(fine, 0.01 * limit);
  EXPECT_LT(fine, 0.5 * coarse);
}

/// Why the source's index is no smoothness measure: a field that turns as u - v has S_TD = 0.
TEST(FieldIndex, CrossTermHidesTurning) {
  const auto turning = [](double sign) {
    return [sign](const Vec2& uv) {
      const double angle = uv.x() + sign * uv.y();
      return Vec3(std::cos(angle), std::sin(angle), 0.0);
    };
  };
  const SmoothnessIndexes minus = smoothness(sample_grid(turning(-1.0), 200, 200)),
                          plus = smoothness(sample_grid(turning(1.0), 200, 200));
  EXPECT_NEAR(minus.s_td_derivative, 0.0, 1e-12);
  EXPECT_NEAR(plus.s_td_derivative, 2.0, 1e-3);
  EXPECT_NEAR(minus.dirichlet, 1.0, 1e-3);
  EXPECT_NEAR(plus.dirichlet, 1.0, 1e-3);
}

TEST(FieldIndex, LargestAngleSeesWhatTheMeanHides) {
  const std::vector<Vec3> keys(100, Vec3::UnitZ());
  std::vector<Vec3> fitted = keys;
  fitted[7] = Vec3(std::sin(0.2), 0.0, std::cos(0.2));
  EXPECT_GT(fitting_accuracy(keys, fitted), 0.9998);
  EXPECT_NEAR(largest_angle(keys, fitted).radians(), 0.2, 1e-12);
}

}  // namespace
}  // namespace volute::planner
