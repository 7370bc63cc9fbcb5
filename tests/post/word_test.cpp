// Numbers as words: every digit counts on a machine.
#include "post/word.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "geometry/number_text.hpp"

namespace volute::post {
namespace {

TEST(NumberText, ByHand) {
  EXPECT_EQ(number_text(0.0, {.decimals = 3}), "0.000");
  EXPECT_EQ(number_text(-0.0004, {.decimals = 3}), "0.000");
  EXPECT_EQ(number_text(-0.0006, {.decimals = 3}), "-0.001");
  EXPECT_EQ(number_text(0.05, {.decimals = 3}), "0.050");
  EXPECT_EQ(number_text(12.3456, {.decimals = 3}), "12.346");
  EXPECT_EQ(number_text(-120.0, {.decimals = 4}), "-120.0000");
  EXPECT_EQ(number_text(99999.9996, {.decimals = 3}), "100000.000");
  EXPECT_EQ(number_text(2500.0, {.decimals = 0}), "2500");
  EXPECT_EQ(number_text(2500.0, {.decimals = 0, .plus_sign = false, .force_point = true}), "2500.");
  EXPECT_EQ(number_text(1.5, {.decimals = 3, .plus_sign = true}), "+1.500");
  EXPECT_EQ(number_text(-1.5, {.decimals = 3, .plus_sign = true}), "-1.500");
  EXPECT_EQ(number_text(0.0, {.decimals = 3, .plus_sign = true}), "+0.000");
}

TEST(NumberText, AgreesWithTheExactConversion) {
  // The exact conversion rounds the double's own value; the scaled one may differ only where that lies on a tie.
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> value(-2000.0, 2000.0);
  int different = 0;
  for (int k = 0; k < 200000; ++k) {
    const double x = value(engine);
    const std::string fast = number_text(x, {.decimals = 4}), exact = geometry::fixed_text(x, 4);
    different += fast != exact ? 1 : 0;
    EXPECT_LE(std::abs(std::strtod(fast.c_str(), nullptr) - x), 0.5e-4 * (1.0 + 1e-9));
  }
  EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace volute::post
