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
