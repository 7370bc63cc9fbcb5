#include "geometry/number_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "geometry/angle.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

TEST(NumberText, ShortestTextReadsBackAsTheSameDouble) {
  const unsigned seed = 3;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int i = 0; i < cases(20000); ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(parse_number(shortest_text(value)), value);
  }
}

TEST(NumberText, FixedTextHasItsDecimalsAndNoMinusZero) {
  EXPECT_EQ(fixed_text(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed_text(-0.0, 0), "0");
  EXPECT_EQ(fixed_text(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed_text(1e20, 1), "100000000000000000000.0");
  EXPECT_EQ(fixed_text(2.5, 0), "2");       // exact ties go to even
  EXPECT_EQ(fixed_text(1.005, 2), "1.00");  // the double lies below 1.005
  EXPECT_EQ(shortest_text(-0.0), "0");
}

TEST(NumberText, ParsesWholeWordsOnly) {
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number("-2e3"), -2000.0);
  for (const char* text : {"", "+", "+-1", "1.5x", " 1", "nan", "inf", "1e999", "0x10", "1,5"})
    EXPECT_FALSE(parse_number(text)) << text;
  EXPECT_EQ(parse_integer("-12"), -12);
  EXPECT_FALSE(parse_integer("1.0"));
  EXPECT_FALSE(parse_integer("99999999999999999999"));
}

TEST(Angle, DegreesAndRadiansAgree) {
  EXPECT_DOUBLE_EQ(Angle::degrees(33.5).radians(), 33.5 * std::numbers::pi / 180.0);
  EXPECT_DOUBLE_EQ(Angle::radians(0.7).degrees(), 0.7 * 180.0 / std::numbers::pi);
  EXPECT_LT(Angle::degrees(-10.0), Angle::degrees(3.0));
  EXPECT_NEAR(wrapped_to_half_turn(Angle::degrees(725.0)).degrees(), 5.0, 1e-12);
  EXPECT_EQ(wrapped_to_half_turn(Angle::radians(-std::numbers::pi)).radians(), std::numbers::pi);
}

}  // namespace
}  // namespace volute::geometry::test
