#include "planner/orientation/smooth_curve.hpp"

#include <array>
#include <fstream>
#include <random>
#include <span>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace volute::planner {
namespace {

using Json = nlohmann::json;

Json reference() {
  std::ifstream file(VOLUTE_SOURCE_DIR "/tests/planner/orientation/data/pinned_smoothing.json");
  return Json::parse(file);
}

std::vector<Pin> pins_of(const Json& given) {
  std::vector<Pin> pins;
  for (const auto& [index, value] : given.items()) pins.push_back({std::stoi(index), value.get<double>()});
  std::sort(pins.begin(), pins.end(), [](const Pin& a, const Pin& b) { return a.index < b.index; });
  return pins;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& wanted, double tolerance) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], tolerance) << i;
}

TEST(SmoothCurve, ReproducesTheWorkedNumbers) {
  const Json all = reference();
  const auto s = all.at("s").get<std::vector<double>>();
  int cases = 0;
  for (const auto& [name, one] : all.at("cases").items()) {
    SCOPED_TRACE(name);
    const std::vector<Pin> pins = pins_of(one.at("pins"));
    expect_near(least_velocity(s, pins, Weights::as_printed), one.at("eq27").at("Phi"), 1e-12);
    expect_near(least_velocity(s, pins, Weights::arc_length), one.at("eq27_arc").at("Phi"), 1e-12);
    expect_near(least_acceleration(s, pins, Weights::as_printed), one.at("eq33").at("Phi"), 1e-12);
    expect_near(least_acceleration(s, pins, Weights::arc_length), one.at("eq33_arc").at("Phi"), 1e-12);
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

double objective(const std::vector<double>& s, const std::vector<double>& phi, Weights weights) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < s.size(); ++i) {
    const double l = s[i] - s[i - 1], r = s[i + 1] - s[i], q = l + r;
    const double a = 2.0 * ((phi[i + 1] - phi[i]) / (q * r) - (phi[i] - phi[i - 1]) / (q * l));
    sum += a * a * (weights == Weights::arc_length ? 0.5 * q : 1.0);
  }
  return sum;
}

/// [Sun2016] eq. 34 corrected (its table is mirrored, one entry wrong): the row of an inner free point.
std::array<double, 5> eq34_row(std::span<const double, 4> l) {
  const double q0 = l[0] + l[1], q1 = l[1] + l[2], q2 = l[2] + l[3];
  const double a = q1 * q2 * q2 * l[1] * l[2] * l[2] * l[3], b = q1 * q2 * q2 * l[0] * l[2] * l[2] * l[3],
               c = q0 * q0 * q2 * q2 * l[0] * l[2] * l[3], d = q0 * q0 * q2 * q2 * l[0] * l[1] * l[3],
               e = q0 * q0 * q1 * l[0] * l[1] * l[1] * l[3], f = q0 * q0 * q1 * l[0] * l[1] * l[1] * l[2];
  return {a, -(a + b + c), b + c + d + e, -(d + e + f), f};
}

TEST(SmoothCurve, Eq34CorrectedHoldsAtEveryFreePoint) {
  const Json all = reference();
  const auto lengths = all.at("eq34").at("L").get<std::array<double, 4>>();
  const auto row = eq34_row(lengths);
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(row[k], all.at("eq34").at("K")[k].get<double>(), 1e-12 * std::abs(row[k])) << k;
  const auto s = all.at("s").get<std::vector<double>>();
  int rows = 0;
  for (const auto& [name, one] : all.at("cases").items()) {
    const std::vector<Pin> pins = pins_of(one.at("pins"));
    const std::vector<double> phi = least_acceleration(s, pins, Weights::as_printed);
    for (std::size_t i = 2; i + 2 < s.size(); ++i) {
      if (std::any_of(pins.begin(), pins.end(), [&](const Pin& p) { return p.index == static_cast<int>(i); })) continue;
      const std::array<double, 4> l = {s[i - 1] - s[i - 2], s[i] - s[i - 1], s[i + 1] - s[i], s[i + 2] - s[i + 1]};
      const auto k = eq34_row(l);
      double sum = 0.0, size = 0.0;
      for (std::size_t j = 0; j < 5; ++j) sum += k[j] * phi[i + j - 2], size += std::abs(k[j] * phi[i + j - 2]);
      EXPECT_NEAR(sum, 0.0, 1e-11 * size) << name << " row " << i;
      ++rows;
    }
  }
  EXPECT_GE(rows, 15);
}

TEST(SmoothCurve, NoFreeValueCanLowerTheObjective) {
  const unsigned seed = 2024;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(0.05, 2.0), value(-2.0, 2.0);
  for (int n = 0; n < 20; ++n) {
    std::vector<double> s = {0.0};
    while (s.size() < 60) s.push_back(s.back() + step(random));
    const std::vector<Pin> pins = {
        {3, value(random)}, {17, value(random)}, {18, value(random)}, {40, value(random)}, {59, value(random)}};
    for (const Weights weights : {Weights::arc_length, Weights::as_printed}) {
      const std::vector<double> phi = least_acceleration(s, pins, weights);
      for (const Pin& pin : pins) ASSERT_EQ(phi[static_cast<std::size_t>(pin.index)], pin.value);
      const double least = objective(s, phi, weights);
      for (std::size_t i = 0; i < s.size(); ++i) {
        if (std::any_of(pins.begin(), pins.end(), [&](const Pin& p) { return p.index == static_cast<int>(i); }))
          continue;
        for (const double change : {-1e-4, 1e-4}) {
          std::vector<double> moved = phi;
          moved[i] += change;
          ASSERT_GT(objective(s, moved, weights), least) << "seed " << seed << " case " << n << " point " << i;
        }
      }
    }
  }
}

double velocity_objective(const std::vector<double>& s, const std::vector<double>& phi, Weights weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < s.size(); ++i) {
    const double l = s[i + 1] - s[i], v = (phi[i + 1] - phi[i]) / l;
    sum += v * v * (weights == Weights::arc_length ? l : 1.0);
  }
  return sum;
}

TEST(SmoothCurve, TheWorkedObjectivesAreReached) {
  const Json all = reference();
  const auto s = all.at("s").get<std::vector<double>>();
  for (const auto& [name, one] : all.at("cases").items()) {
    const std::vector<Pin> pins = pins_of(one.at("pins"));
    for (const Weights weights : {Weights::as_printed, Weights::arc_length}) {
      const std::string arc = weights == Weights::arc_length ? "_arc" : "";
      const double v = one.at("eq27" + arc).at("objective"), a = one.at("eq33" + arc).at("objective");
      EXPECT_NEAR(velocity_objective(s, least_velocity(s, pins, weights), weights), v, 1e-12 * v + 1e-18) << name;
      EXPECT_NEAR(objective(s, least_acceleration(s, pins, weights), weights), a, 1e-11 * a + 1e-18) << name;
    }
  }
}

TEST(SmoothCurve, ArcLengthVelocityIsLinearOnAnySpacing) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> step(0.01, 3.0);
  std::vector<double> s = {0.0};
  while (s.size() < 500) s.push_back(s.back() + step(random));
  const std::vector<double> phi = least_velocity(s, std::vector<Pin>{{0, -1.0}, {499, 2.0}}, Weights::arc_length);
  for (std::size_t i = 0; i < s.size(); ++i) EXPECT_NEAR(phi[i], -1.0 + 3.0 * s[i] / s.back(), 1e-12);
}

/// Natural cubic spline through (0, 0), (1/2, 1), (1, 0): M = -12 in the middle.
double natural_spline(double x) {
  const double t = x <= 0.5 ? x : 1.0 - x;
  return 3.0 * t - 4.0 * t * t * t;
}

TEST(SmoothCurve, ArcLengthAccelerationTendsToTheNaturalSpline) {
  double before = 1.0;
  for (const int n : {40, 160, 640}) {
    // Graded: four times as dense in the first half.
    std::vector<double> s = {0.0};
    for (int i = 0; i < 4 * n; ++i) s.push_back(0.5 * (i + 1) / (4 * n));
    for (int i = 0; i < n; ++i) s.push_back(0.5 + 0.5 * (i + 1) / n);
    const std::vector<double> phi =
        least_acceleration(s, std::vector<Pin>{{0, 0.0}, {4 * n, 1.0}, {5 * n, 0.0}}, Weights::arc_length);
    double worst = 0.0;
    for (std::size_t i = 0; i < s.size(); ++i) worst = std::max(worst, std::abs(phi[i] - natural_spline(s[i])));
    EXPECT_LT(worst, before / 12.0);  // second order: 16 times less for 4 times as many
    before = worst;
  }
  EXPECT_LT(before, 1e-5);
}

// The worked natural splines: the same pins with `parts` points to each interval tend to them, with the square of the
// spacing.
TEST(SmoothCurve, TendsToTheWorkedNaturalSplines) {
  const Json all = reference();
  const auto coarse = all.at("s").get<std::vector<double>>();
  int cases = 0;
  for (const auto& [name, one] : all.at("cases").items()) {
    if (!one.contains("natural_cubic_spline_through_pins")) continue;
    SCOPED_TRACE(name);
    ++cases;
    const auto wanted = one.at("natural_cubic_spline_through_pins").get<std::vector<double>>();
    ASSERT_EQ(wanted.size(), coarse.size());
    double before = 0.0;
    for (const int parts : {20, 80, 320}) {
      std::vector<double> s = {coarse.front()};
      for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
        for (int k = 1; k <= parts; ++k) s.push_back(coarse[i] + (coarse[i + 1] - coarse[i]) * k / parts);
      }
      std::vector<Pin> pins = pins_of(one.at("pins"));
      for (Pin& pin : pins) pin.index *= parts;
      const std::vector<double> phi = least_acceleration(s, pins, Weights::arc_length);
      double worst = 0.0;
      for (std::size_t i = 0; i < coarse.size(); ++i)
        worst = std::max(worst, std::abs(phi[i * static_cast<std::size_t>(parts)] - wanted[i]));
      if (parts > 20) {
        EXPECT_LT(worst, before / 12.0 + 1e-10) << parts;
      }
      before = worst;
    }
    EXPECT_LT(before, 1e-4);
  }
  EXPECT_EQ(cases, 2);
}

TEST(SmoothCurve, HoldsItsAccuracyAtAMillionPoints) {
  const int n = 1000000;
  std::vector<double> s(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i <= n; ++i) s[static_cast<std::size_t>(i)] = static_cast<double>(i) / n;
  const std::vector<double> phi =
      least_acceleration(s, std::vector<Pin>{{0, 0.0}, {n / 2, 1.0}, {n, 0.0}}, Weights::arc_length);
  double worst = 0.0;
  for (std::size_t i = 0; i < s.size(); ++i) worst = std::max(worst, std::abs(phi[i] - natural_spline(s[i])));
  EXPECT_LT(worst, 1e-9);
}

}  // namespace
}  // namespace volute::planner
