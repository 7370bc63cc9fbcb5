#include "planner/field/field_spline.hpp"

#include <gtest/gtest.h>

#include "tests/planner/field/reference.hpp"

namespace volute::planner {
namespace {

/// The reference's grid: data at i / 5 and j / 6.
Vec3 grid_value(const Vec2& uv) {
  const auto i = static_cast<std::size_t>(std::lround(uv.x() * 5)),
             j = static_cast<std::size_t>(std::lround(uv.y() * 6));
  return vec3(reference()["closed_spline_grid"]["grid_G"][i][j]);
}

void expect_reference(KnotRule rule, const char* key) {
  const FieldSpline spline(grid_value, {5, 6, true, rule});
  const Json& expected = reference()["closed_spline_grid"][key];
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      EXPECT_LT((spline.control_points()[i][j] - vec3(expected["control_points"][i][j])).norm(), 1e-11)
          << key << " " << i << " " << j;
  for (std::size_t k = 0; k < expected["eval"].size(); ++k)
    EXPECT_LT((spline.value(vec2(reference()["closed_spline_grid"]["eval_uv"][k])) - vec3(expected["eval"][k])).norm(),
              1e-11)
        << key << " " << k;
}

TEST(FieldSpline, AgreesWithWorkedNumbersForBothKnotRules) {
  expect_reference(KnotRule::eq3, "eq3_knots");
  expect_reference(KnotRule::averaged, "averaged_knots");
}

// In one closed direction: the same data on every row of u. Collocation at a knot has 1/6, 4/6, 1/6.
TEST(FieldSpline, ClosedDirectionAgreesWithWorkedNumbers) {
  const Json& worked = reference()["closed_spline_1d"];
  const auto data = worked["data"].get<std::vector<double>>();
  const auto value = [&](const Vec2& uv) {
    return Vec3(data[static_cast<std::size_t>(std::lround(5.0 * uv.y())) % 5], 0.0, 1.0);
  };
  const FieldSpline spline(value, {4, 5, true, KnotRule::averaged});
  const auto& control = spline.control_points();
  for (const auto& row : control) {
    ASSERT_EQ(row.size(), 5u);
    for (std::size_t j = 0; j < 5; ++j) EXPECT_NEAR(row[j].x(), worked["control"][j].get<double>(), 1e-12) << j;
  }
  for (std::size_t k = 0; k < worked["t"].size(); ++k)
    EXPECT_NEAR(spline.value({0.3, worked["t"][k].get<double>()}).x(), worked["value"][k].get<double>(), 1e-12) << k;
  const CubicBasis basis = cubic_basis(closed_knots(6), 0.0);
  const Json& row = reference()["closed_spline_grid"]["closed_collocation_row0"];
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(basis.values[k], row[k].get<double>(), 1e-15) << k;
}

TEST(FieldSpline, ClampedKnotsAgreeWithWorkedNumbers) {
  for (const auto& [rule, key] : {std::pair(KnotRule::eq3, "eq3_knots"), {KnotRule::averaged, "averaged_knots"}}) {
    const auto wanted = reference()["closed_spline_grid"][key]["U"].get<std::vector<double>>();
    const std::vector<double> knots = open_knots(5, rule);
    ASSERT_EQ(knots.size(), wanted.size()) << key;
    for (std::size_t k = 0; k < knots.size(); ++k) EXPECT_NEAR(knots[k], wanted[k], 1e-15) << key << " " << k;
  }
}

TEST(FieldSpline, ReproducesCubicPolynomials) {
  const auto cubic = [](const Vec2& p) {
    return Vec3(p.x() * p.x() * p.x() - p.y(), p.x() * p.y() * p.y() * p.y(), 1.0 + p.x() * p.x() * p.y());
  };
  const FieldSpline spline(cubic, {9, 7, false, KnotRule::averaged});
  for (double u = 0.0; u <= 1.0; u += 0.07)
    for (double v = 0.0; v <= 1.0; v += 0.09) EXPECT_LT((spline.value({u, v}) - cubic({u, v})).norm(), 1e-12);
}

TEST(FieldSpline, ClosedSplineIsPeriodic) {
  const auto wave = [](const Vec2& p) {
    return Vec3(std::cos(6.283185307179586 * p.y()), std::sin(6.283185307179586 * p.y()), p.x());
  };
  const FieldSpline spline(wave, {6, 24, true, KnotRule::averaged});
  EXPECT_LT((spline.value({0.4, 0.0}) - spline.value({0.4, 1.0})).norm(), 1e-14);
  double largest = 0.0;
  for (double v = 0.0; v < 1.0; v += 0.013)
    largest = std::max(largest, (spline.value({0.5, v}) - wave({0.5, v})).norm());
  EXPECT_LT(largest, 1e-4) << "cubic spline error of order (2 pi / 24)^4 / 384";
}

TEST(CubicBasis, SumsToOne) {
  for (const KnotRule rule : {KnotRule::eq3, KnotRule::averaged})
    for (double t = 0.0; t <= 1.0; t += 0.01) {
      const CubicBasis basis = cubic_basis(open_knots(8, rule), t);
      EXPECT_NEAR(basis.values[0] + basis.values[1] + basis.values[2] + basis.values[3], 1.0, 1e-14);
    }
}

}  // namespace
}  // namespace volute::planner
